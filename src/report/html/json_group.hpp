// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of a result as JSON, arrays in base64.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/layout/writer.hpp"
#include "report/json/summary_object.hpp"

namespace hdconj::report {

/// The array as {type: "f8" | "f4" | "i4", shape, data}, little-endian numbers in base64. The second form writes
/// doubles, of more than 4,096 values in single precision.
[[nodiscard]] Json array_json(std::string_view type, io::layout::Shape const& shape, void const* values,
                              std::size_t bytes);
[[nodiscard]] Json array_json(io::layout::Shape const& shape, double const* values);

/// The numbers of such an array.
[[nodiscard]] std::vector<double> array_values(Json const& array);

/// A column of such a group as @p unit; empty where there is none.
[[nodiscard]] std::vector<double> column_of(Json const& group, char const* name, double unit = 1);

/// A number among the attributes of such a group; 0 where there is none.
[[nodiscard]] double attribute_of(Json const& group, char const* name);

/// The group at the end of a path; empty where there is none.
[[nodiscard]] Json group_at(Json const& root, std::initializer_list<std::string> path);

/// The groups in such a group whose names begin with @p beginning, in their order.
[[nodiscard]] std::vector<Json> groups_of(Json const& group, std::string_view beginning);

/// A group as {attributes, datasets, groups, figures}.
class JsonGroup final : public io::layout::GroupSink
{
  public:
    /// @param left  names of groups and datasets that are left out
    explicit JsonGroup(std::set<std::string> left = {}) : left_(std::move(left)) {}

    void group(std::string const& name, std::function<void(io::layout::GroupSink&)> const& fill) override;
    void dataset(std::string const& name, io::layout::Shape const& shape, io::layout::Values const& values,
                 io::layout::About const& about) override;
    void link(std::string const&, std::string const&) override {}
    void attribute(std::string const& name, io::layout::AttributeValue const& value) override;
    void figure(io::layout::FigurePlace const& figure) override;

    [[nodiscard]] Json const& json() const { return json_; }

  private:
    std::set<std::string> left_;
    Json json_ = Json::object();
};

/// What @p write puts into a root group, called with its writer.
template <class Write>
[[nodiscard]] Json layout_json(std::set<std::string> left, Write const& write)
{
    JsonGroup root(std::move(left));
    write(io::layout::Writer(root));
    return root.json();
}

}  // namespace hdconj::report
