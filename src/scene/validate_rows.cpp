// SPDX-License-Identifier: GPL-3.0-or-later
// A list of lists of numbers against the forms that its rows may have.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "file/csv.hpp"
#include "hdconj/scene/schema.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

using Kind = RawValue::Kind;

// of lubricants, in degrees Celsius: beyond, the law of their viscosity says nothing
constexpr double coldest = -60, hottest = 200;

bool is_number(RawValue const& value)
{
    return value.kind == Kind::integer || value.kind == Kind::number;
}

/// A row or a number of it as a message shows it.
std::string text_of(RawValue const& value)
{
    if (is_number(value))
        return number_text(value.number);
    if (value.kind != Kind::array)
        return value.kind == Kind::text ? "text" : "no number";
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, value.items.size()); ++i)
        text += (i > 0 ? ", " : "") + (value.items[i].kind == Kind::array ? "[...]" : text_of(value.items[i]));
    return "[" + text + (value.items.size() > most ? ", ...]" : "]");
}

/// Why @p value cannot stand in @p column; empty when it can.
std::string column_fault(RawValue const& value, std::string_view column)
{
    if (!is_number(value))
        return "is no number";
    if (!std::isfinite(value.number))
        return "is not a finite number";
    if (column.ends_with("_deg"))
        return "";
    if (column == "torque" || column == "speed")
        return value.number > 0 ? "" : "must be larger than 0";
    if (column == "temperature")
        return value.number >= coldest && value.number <= hottest
                   ? ""
                   : "is no temperature of a lubricant, which lies between " + number_text(coldest) + " and " +
                         number_text(hottest) + " degrees Celsius";
    if (column == "radius")
        return value.number == 0 ? "must not be 0" : "";
    if (column == "length" && value.number < 0)
        return "must not be negative";
    return std::abs(value.number) > bounds::largest_length
               ? "is larger than any drive (" + number_text(bounds::largest_length) + " mm)"
               : "";
}

/// The numbers of a row. One number without brackets is a row of one, where rows have one form.
std::vector<RawValue> items_of(RawValue const& row)
{
    return row.kind == Kind::array ? row.items : std::vector<RawValue>{row};
}

/// Every fault of one row, as the rest of a sentence about it.
std::vector<std::string> row_faults(RawValue const& row, std::vector<std::string_view> const& forms)
{
    if (row.kind != Kind::array && forms.size() > 1)
        return {" is no list"};
    auto const items = items_of(row);
    std::vector<std::string> faults;
    for (auto const form : forms) {
        auto const columns = columns_of(form);
        if (columns.size() != items.size())
            continue;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            auto const fault = column_fault(items[i], columns[i]);
            if (!fault.empty())
                faults.push_back(": " + std::string(columns[i]) + " " + fault);
        }
        return faults;
    }
    if (row.kind != Kind::array)
        return {" is no list"};
    return {" has " + std::to_string(items.size()) + (items.size() == 1 ? " number" : " numbers")};
}

}  // namespace

std::vector<std::string_view> columns_of(std::string_view form)
{
    return file::fields_of(form.substr(1, form.size() - 2), ',');
}

std::variant<Parameter, Faults> validate_rows(ParameterSpec const& spec, RawEntry const& entry, std::string const& path)
{
    constexpr std::size_t most_faults = 20;
    auto const& rows = entry.value.items;
    std::vector<std::string_view> const forms = row_forms(spec);
    Faults faults;
    NumberRows numbers;
    auto const add = [&](std::string reason) {
        faults.push_back(fault_at(entry, path, {std::move(reason), write_instead(spec, "")}));
    };
    auto const add_row = [&](RawValue const& row, std::size_t number, std::string const& reason) {
        std::string const name = "row " + std::to_string(number);
        Fault& fault =
            faults.emplace_back(fault_at(entry, path, {name + reason, "write " + name + " as " + row_form(spec)}));
        fault.line = row.line > 0 ? row.line : entry.line;
        fault.value = printable(text_of(row));
    };
    if (rows.size() > static_cast<std::size_t>(bounds::most_rows)) {
        add("has more than " + std::to_string(bounds::most_rows) + " rows: give that many points in a file");
        return faults;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (auto const& fault : row_faults(rows[i], forms))
            add_row(rows[i], i + 1, fault);
        if (faults.size() >= most_faults) {
            add("rows after row " + std::to_string(i + 1) + " were not looked at");
            return faults;
        }
        std::vector<double> row;
        for (auto const& item : items_of(rows[i]))
            row.push_back(item.number);
        numbers.push_back(std::move(row));
    }
    if (static_cast<double>(rows.size()) < spec.at_least)
        add("has " + std::to_string(rows.size()) + (rows.size() == 1 ? " row" : " rows"));
    if (!faults.empty())
        return faults;
    return Parameter{std::move(numbers), entry.line};
}

}  // namespace hdconj::scene
