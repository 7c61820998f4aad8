// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "layout.hpp"

namespace nb = nanobind;

namespace hdconj::python {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Keeps the first and the last number of each dataset, and the numbers among the attributes.
class LastNumbers final : public io::layout::GroupSink
{
  public:
    void group(std::string const& name, std::function<void(io::layout::GroupSink&)> const& fill) override
    {
        order_.push_back(name);
        groups_[name] = std::make_unique<LastNumbers>();
        fill(*groups_[name]);
    }
    void dataset(std::string const& name, io::layout::Shape const& shape, io::layout::Values const& values,
                 io::layout::About const&) override
    {
        std::size_t const count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
        std::visit(
            [&](auto const* first) {
                if constexpr (!std::is_same_v<decltype(first), std::string const*>) {
                    columns_[name] = count > 0 ? static_cast<double>(first[count - 1]) : not_a_number;
                    firsts_[name] = count > 0 ? static_cast<double>(first[0]) : not_a_number;
                }
            },
            values);
    }
    void link(std::string const& name, std::string const& other) override { links_[other] = name; }
    void attribute(std::string const& name, io::layout::AttributeValue const& value) override
    {
        std::visit(
            [&](auto const& given) {
                if constexpr (std::is_arithmetic_v<std::decay_t<decltype(given)>>)
                    attributes_[name] = static_cast<double>(given);
            },
            value);
    }
    void figure(io::layout::FigurePlace const& figure) override { figures_.push_back(figure); }

    void append(nb::list& list, std::string const& path) const
    {
        for (io::layout::FigurePlace const& figure : figures_) {
            std::optional<double> const value = figure.value == figure.error ? first(figure.value)
                                                                             : own(figure.value, figure.is_attribute),
                                        error = estimate(figure.error, figure.is_attribute);
            list.append(nb::make_tuple(text_of(path), text_of(figure.name), value.value_or(not_a_number),
                                       error ? nb::cast(*error) : nb::none(), figure.units));
        }
        for (std::string const& name : order_)
            groups_.at(name)->append(list, path.empty() ? name : path + '/' + name);
    }

  private:
    using Numbers = std::map<std::string, double>;
    static std::optional<double> in(Numbers const& numbers, std::string const& name)
    {
        auto const found = numbers.find(name);
        return found == numbers.end() ? std::nullopt : std::optional(found->second);
    }
    [[nodiscard]] std::string const& linked(std::string const& name) const
    {
        auto const link = links_.find(name);
        return link != links_.end() ? link->second : name;
    }
    [[nodiscard]] std::optional<double> own(std::string const& name, bool is_attribute) const
    {
        return is_attribute ? in(attributes_, name) : in(columns_, linked(name));
    }
    /// Of a dataset of a value and its error.
    [[nodiscard]] std::optional<double> first(std::string const& name) const { return in(firsts_, linked(name)); }

    /// In this group, or in one of its groups.
    [[nodiscard]] std::optional<double> at(std::string const& path, bool is_attribute) const
    {
        std::size_t const slash = path.find('/');
        if (slash == std::string::npos)
            return own(path, is_attribute);
        auto const inner = groups_.find(path.substr(0, slash));
        return inner == groups_.end() ? std::nullopt : inner->second->at(path.substr(slash + 1), is_attribute);
    }

    /// An error; not a number where the group that holds it says that there is no estimate.
    [[nodiscard]] std::optional<double> estimate(std::string const& path, bool is_attribute) const
    {
        if (path.empty())
            return std::nullopt;
        std::optional<double> const found = at(path, is_attribute);
        std::size_t const slash = path.rfind('/');
        std::string const group = slash != std::string::npos ? path.substr(0, slash + 1) : "";
        bool const left_out = at(group + "estimated", is_attribute) == 0;
        return found && left_out ? std::optional(not_a_number) : found;
    }

    std::vector<std::string> order_;  ///< of the groups
    std::map<std::string, std::unique_ptr<LastNumbers>> groups_;
    std::map<std::string, std::string> links_;
    Numbers columns_, firsts_, attributes_;
    std::vector<io::layout::FigurePlace> figures_;
};

}  // namespace

nb::list figures_of(Result const& result)
{
    LastNumbers root;
    result.write(io::layout::Writer(root));
    nb::list list;
    root.append(list, "");
    return list;
}

}  // namespace hdconj::python
