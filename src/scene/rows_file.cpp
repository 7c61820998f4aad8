// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a list from a CSV file that the scene names in its place.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "column_units.hpp"
#include "file/csv.hpp"
#include "hdconj/scene/schema.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// A column of the list.
struct WantedColumn
{
    std::string name;  ///< in the file's header, without unit
    ColumnQuantity quantity;
};

/// Columns of the list and of the file.
class RowColumns
{
  public:
    explicit RowColumns(std::string_view form)
    {
        for (std::string_view const column : columns_of(form)) {
            bool const angle = column.ends_with("_deg");
            wanted_.push_back({std::string(column.substr(0, column.size() - (angle ? 4 : 0))),
                               angle ? ColumnQuantity::angle : ColumnQuantity::length});
        }
    }

    /// A header as it should be.
    [[nodiscard]] std::string example() const
    {
        std::string text = wanted_.size() == 1 ? "tooth" : "";
        for (WantedColumn const& each : wanted_)
            text +=
                (text.empty() ? "" : ",") + each.name + (each.quantity == ColumnQuantity::length ? " [um]" : " [deg]");
        return text;
    }

    /// Finds the columns in @p header. Those that the list does not have are passed over.
    [[nodiscard]] std::optional<Refusal> find(std::string_view header)
    {
        separator_ = file::separator_of(header);
        auto const headings = file::fields_of(header, separator_);
        std::string const write = "write a header such as " + example();
        for (WantedColumn const& each : wanted_) {
            auto const is_it = [&](std::string_view heading) { return name_of(heading) == each.name; };
            auto const found = std::ranges::find_if(headings, is_it);
            if (found == headings.end())
                return Refusal{"names no column " + each.name, write};
            auto const unit = unit_in(*found);
            if (!unit)
                return Refusal{"column " + each.name + " has no unit", write};
            auto const factor = factor_of_unit(*unit, each.quantity);
            if (!factor)
                return Refusal{"column " + printable(std::string(*found)) + ": the unit is not known",
                               write_known_unit(each.quantity)};
            at_.push_back(static_cast<std::size_t>(found - headings.begin()));
            factor_.push_back(*factor);
        }
        auto const tooth = std::ranges::find(headings, "tooth", name_of);
        if (wanted_.size() == 1 && tooth != headings.end())
            tooth_ = static_cast<std::size_t>(tooth - headings.begin());
        return std::nullopt;
    }

    /// Takes the numbers of @p line into @p rows.
    [[nodiscard]] std::optional<Refusal> take(std::string_view line, std::map<int, std::vector<double>>& rows) const
    {
        auto const fields = file::fields_of(line, separator_);
        std::vector<double> row;
        for (std::size_t k = 0; k < wanted_.size(); ++k) {
            auto const value = at_[k] < fields.size() ? file::number_in(fields[at_[k]]) : std::nullopt;
            if (!value)
                return Refusal{wanted_[k].name + " is no finite number", "write a number with a decimal point"};
            row.push_back(*value * factor_[k]);
            if (wanted_[k].quantity == ColumnQuantity::length && std::abs(row.back()) > bounds::largest_length)
                return Refusal{wanted_[k].name + " is larger than any drive", "check number and unit"};
        }
        auto number = static_cast<int>(rows.size()) + 1;
        if (tooth_) {
            auto const tooth = *tooth_ < fields.size() ? file::number_in(fields[*tooth_]) : std::nullopt;
            if (!tooth || *tooth != std::floor(*tooth) || *tooth < 1 || *tooth > bounds::most_teeth)
                return Refusal{"tooth is no whole number from 1 on", "count the teeth clockwise from 1"};
            number = static_cast<int>(*tooth);
        }
        if (rows.size() == static_cast<std::size_t>(bounds::most_rows))
            return Refusal{"is one row more than the " + std::to_string(bounds::most_rows) + " that are read",
                           "leave rows out"};
        if (!rows.emplace(number, std::move(row)).second)
            return Refusal{"tooth " + std::to_string(number) + " stands there twice", "write each tooth once"};
        return std::nullopt;
    }

  private:
    /// What @p heading names, in lower case and without its unit.
    [[nodiscard]] static std::string name_of(std::string_view heading)
    {
        if (unit_in_brackets(heading))
            return file::lower_case(file::heading_of(heading).name);
        if (auto const unit = unit_in(heading); unit && unit->size() < heading.size())
            heading.remove_suffix(unit->size() + 1);
        return file::lower_case(without_blanks(heading));
    }

    std::vector<WantedColumn> wanted_;
    std::vector<std::size_t> at_;
    std::vector<double> factor_;
    std::optional<std::size_t> tooth_;
    char separator_ = ',';
};

/// What became of reading the file.
std::optional<Refusal> read_all(std::filesystem::path const& file, std::string const* content, RowColumns& columns,
                                std::map<int, std::vector<double>>& rows)
{
    bool header = true;
    std::optional<Refusal> refusal;
    auto const unreadable = file::read_csv(file, content, largest_number_file, [&](std::string_view line, int number) {
        refusal = header ? columns.find(line) : columns.take(line, rows);
        header = false;
        if (refusal)
            refusal->reason = "line " + std::to_string(number) + " of " + file.string() + ": " + refusal->reason;
        return !refusal;
    });
    std::string const name_it = "write the name of a CSV file, relative to the scene file";
    if (unreadable)
        return Refusal{*unreadable == file::Unreadable::too_large ? file.string() + " is too large"
                       : *unreadable == file::Unreadable::endless ? "is no file of numbers: " + file.string()
                                                                  : "cannot be read: " + file.string(),
                       name_it};
    if (refusal)
        return refusal;
    if (rows.empty())
        return Refusal{file.string() + " has no rows",
                       "write a header such as " + columns.example() + " and a row for each line of the list"};
    for (int expected = 1; auto const& [number, row] : rows)
        if (number != expected++)
            return Refusal{file.string() + " leaves out tooth " + std::to_string(expected - 1),
                           "write a row for each tooth"};
    return std::nullopt;
}

}  // namespace

std::shared_ptr<std::string const> content_of(Scene& scene, std::string const& name)
{
    auto const [found, is_new] = scene.files.try_emplace(name);
    if (is_new)
        found->second =
            file::whole_text(scene.folder / name, largest_number_file);  // an absolute name stands for itself
    return found->second;
}

std::variant<Parameter, Faults> rows_of_file(ParameterSpec const& spec, RawEntry const& entry, std::string const& path,
                                             Scene& scene)
{
    RowColumns columns(spec.words.front());
    std::map<int, std::vector<double>> rows;
    auto const content = content_of(scene, entry.value.text);
    auto refusal = read_all(scene.folder / entry.value.text, content.get(), columns, rows);
    if (!refusal && static_cast<double>(rows.size()) < spec.at_least)
        refusal = Refusal{"the file has " + std::to_string(rows.size()) + " rows",
                          "write at least " + number_text(spec.at_least)};
    if (refusal)
        return Faults{fault_at(entry, path, *refusal)};
    NumberRows numbers;
    for (auto& [number, row] : rows)
        numbers.push_back(std::move(row));
    return Parameter{std::move(numbers), entry.line};
}

}  // namespace hdconj::scene
