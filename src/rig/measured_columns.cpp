// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "file/csv.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/units.hpp"

namespace hdconj::rig {
namespace {

using file::ColumnUnit;

constexpr std::array torque_units = {ColumnUnit{"nm", newton_metre}, ColumnUnit{"nmm", 1.0}, ColumnUnit{"mnm", 1.0}};
constexpr std::array current_units = {ColumnUnit{"a", 1.0}, ColumnUnit{"ma", 1e-3}};
constexpr std::array angle_units = {ColumnUnit{"deg", deg},  ColumnUnit{"°", deg},         ColumnUnit{"arcmin", arcmin},
                                    ColumnUnit{"'", arcmin}, ColumnUnit{"arcsec", arcsec}, ColumnUnit{"rad", 1.0},
                                    ColumnUnit{"mrad", 1e-3}};
constexpr std::array position_units = {ColumnUnit{"counts", 1.0}, ColumnUnit{"count", 1.0}, ColumnUnit{"1", 1.0}};

/// What a column may hold.
struct Quantity
{
    std::string_view name, also;
    std::span<ColumnUnit const> units;
    std::string_view known_units;
    MeasuredColumn MeasuredColumns::*column;
    bool may_lack_unit = false;
};
constexpr std::array quantities = {
    Quantity{"torque", "load", torque_units, "[N m], [N mm] or [mN m]", &MeasuredColumns::torque},
    Quantity{"current", "motor current", current_units, "[A] or [mA]", &MeasuredColumns::current},
    Quantity{"angle", "twist", angle_units, "[deg], [arcmin], [arcsec], [rad] or [mrad]", &MeasuredColumns::angle},
    Quantity{"position", "counts", position_units, "[counts]", &MeasuredColumns::position, true}};

/// A unit in lower case without blanks, points and the multiplication dots U+00B7 and U+22C5: "N·m" and "N m" are one.
std::string plain_unit(std::string_view unit)
{
    std::string text = file::lower_case(unit, " .*_");
    for (std::string_view const dot : {"\xc2\xb7", "\xe2\x8b\x85"})
        for (auto at = text.find(dot); at != std::string::npos; at = text.find(dot))
            text.erase(at, dot.size());
    return text;
}

/// Where a header is read, and what it has given so far.
struct HeaderReading
{
    int line;
    std::string const& file;
    MeasuredColumns& columns;
    Faults& faults;

    void fault(std::string path, std::string value, std::string reason, std::string remedy) const
    {
        faults.push_back({std::move(path), line, std::move(value), std::move(reason), std::move(remedy), file});
    }
};

/// Enters the heading of column @p at as the quantity that it names. @returns whether it names one.
bool read_heading(HeaderReading const& reading, std::string_view text, std::size_t at)
{
    file::Heading const heading = file::heading_of(text);
    std::string const name = file::lower_case(heading.name);
    auto const found = std::find_if(quantities.begin(), quantities.end(),
                                    [&](Quantity const& each) { return name == each.name || name == each.also; });
    if (found == quantities.end())
        return false;
    MeasuredColumn& column = reading.columns.*found->column;
    std::string const place = fmt::format("column {}", at + 1);
    if (column.given()) {
        reading.fault(place, std::string(text), "this quantity has a column already, " + column.heading,
                      "leave one of them out, or give it another name");
        return true;
    }
    column = {at, 1, std::string(text)};
    if (!heading.unit && found->may_lack_unit)
        return true;
    if (auto const factor = heading.unit ? file::factor_of(found->units, plain_unit(*heading.unit)) : std::nullopt)
        column.factor = *factor;
    else
        reading.fault(place, std::string(text), heading.unit ? "the unit is not known" : "the unit is missing",
                      fmt::format("write {} {}", found->name, found->known_units));
    return true;
}

/// The heading that @p unknown most likely means, with its unit where that stands in brackets or, as in "torque in N m"
/// and "angle_deg", behind the name; else with all units that are known.
std::optional<std::string> meant_heading(std::string_view unknown, Quantity const& read, Quantity const& computed)
{
    file::Heading const heading = file::heading_of(unknown);
    auto const name = nearest(heading.name, {read.name, computed.name, read.also, computed.also});
    if (!name)
        return std::nullopt;
    Quantity const& meant = *name == read.name || *name == read.also ? read : computed;
    std::string_view unit =
        file::trimmed(heading.unit.value_or(heading.name.substr(std::min(name->size(), heading.name.size()))), " _/");
    if (constexpr std::string_view in = "in "; file::lower_case(unit).starts_with(in))
        unit = file::trimmed(unit.substr(in.size()));
    if (file::factor_of(meant.units, plain_unit(unit)))
        return fmt::format("{} [{}]", *name, unit);
    return meant.may_lack_unit ? std::string(*name) : fmt::format("{} {}", *name, meant.known_units);
}

/// Requires one of two columns, and not both.
/// @param unknown  headings that name no quantity: one of them may be a misspelt one
void require_one(HeaderReading const& reading, Quantity const& read, Quantity const& computed,
                 std::vector<std::string_view> const& unknown)
{
    MeasuredColumn const &a = reading.columns.*read.column, &b = reading.columns.*computed.column;
    if (a.given() && b.given())
        reading.fault(fmt::format("column {}", b.at + 1), b.heading,
                      "both " + a.heading + " and " + b.heading + " are there, and they may disagree",
                      "leave one of them out");
    if (a.given() || b.given())
        return;
    std::string remedy = how_to_begin;
    for (auto const heading : unknown)
        if (auto const meant = meant_heading(heading, read, computed)) {
            remedy = fmt::format("write {} in place of {}", *meant, heading);
            break;
        }
    reading.fault("header", "", fmt::format("there is no column \"{}\" or \"{}\"", read.name, computed.name), remedy);
}

}  // namespace

MeasuredColumns measured_columns(std::string_view text, int line, std::string const& name, Faults& faults)
{
    MeasuredColumns columns;
    columns.separator = file::separator_of(text);
    HeaderReading const reading{line, name, columns, faults};
    auto const headings = file::fields_of(text, columns.separator);
    columns.count = headings.size();
    std::vector<std::string_view> unknown;
    for (std::size_t i = 0; i < headings.size(); ++i)
        if (!read_heading(reading, headings[i], i))
            unknown.push_back(headings[i]);
    if (std::ranges::all_of(headings, [](std::string_view each) { return file::number_in(each).has_value(); })) {
        reading.fault("header", std::string(text), "is missing: the file begins with numbers", how_to_begin);
        return columns;
    }
    require_one(reading, quantities[0], quantities[1], unknown);
    require_one(reading, quantities[2], quantities[3], unknown);
    return columns;
}

Fault fault_of_file(std::string const& name, std::string reason, std::string remedy)
{
    return {"--measured", 0, name, std::move(reason), std::move(remedy), ""};
}

}  // namespace hdconj::rig
