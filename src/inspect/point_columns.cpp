// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/text.hpp"
#include "file/csv.hpp"
#include "hdconj/base/suggest.hpp"
#include "scene/column_units.hpp"

namespace hdconj::inspect {
namespace {

/// What a column may hold.
struct Content
{
    std::string_view name;
    PointColumn PointColumns::*column;
    bool is_length;
};
constexpr std::array contents = {Content{"x", &PointColumns::x, true}, Content{"y", &PointColumns::y, true},
                                 Content{"z", &PointColumns::z, true}, Content{"tooth", &PointColumns::tooth, false},
                                 Content{"flank", &PointColumns::flank, false}};

/// A header that is read, and where its faults go.
struct Header
{
    int line;
    std::string const& file;
    Faults& faults;

    void fault(std::string path, std::string_view value, std::string reason, std::string remedy) const
    {
        faults.push_back({std::move(path), line, printable(value), std::move(reason), std::move(remedy), file});
    }
};

/// Enters the heading of column @p at. @returns whether it names anything known
bool enter(Header const& header, std::string_view text, std::size_t at, PointColumns& columns)
{
    file::Heading const heading = file::heading_of(text);
    std::string const name = file::lower_case(heading.name);
    auto const found = std::find_if(contents.begin(), contents.end(), [&](Content const& c) { return name == c.name; });
    if (found == contents.end())
        return false;
    PointColumn& column = columns.*found->column;
    std::string const place = fmt::format("column {}", at + 1);
    if (column.given()) {
        header.fault(place, text, "this quantity has a column already, " + column.heading,
                     "leave one of them out, or give it another name");
        return true;
    }
    column = {at, 1, std::string(text)};
    if (!heading.unit)
        return true;
    constexpr auto length = scene::ColumnQuantity::length;
    auto const factor = found->is_length ? scene::factor_of_unit(*heading.unit, length) : std::nullopt;
    if (factor)
        column.factor = *factor;
    else
        header.fault(place, text, found->is_length ? "the unit is not known" : "has no unit",
                     found->is_length ? fmt::format("write {} {}", found->name, scene::known_units(length))
                                      : fmt::format("write {}", found->name));
    return true;
}

void require(Header const& header, Content const& content, PointColumns const& columns,
             std::vector<std::string_view> const& unknown)
{
    if ((columns.*content.column).given())
        return;
    std::string remedy = first_line;
    for (auto const name : unknown)
        if (auto const meant = nearest(name, {content.name}))
            remedy = fmt::format("write {} in place of {}", *meant, printable(name));
    header.fault("header", "", fmt::format("there is no column \"{}\"", content.name), remedy);
}

}  // namespace

PointColumns point_columns(std::string_view text, int line, std::string const& name, Faults& faults)
{
    PointColumns columns;
    columns.separator = file::separator_of(text);
    Header const header{line, name, faults};
    auto const headings = file::fields_of(text, columns.separator);
    if (std::all_of(headings.begin(), headings.end(),
                    [](std::string_view each) { return file::number_in(each).has_value(); })) {
        header.fault("header", text, "is missing: the file begins with numbers", first_line);
        return columns;
    }
    std::vector<std::string_view> unknown;
    for (std::size_t i = 0; i < headings.size(); ++i)
        if (!enter(header, headings[i], i, columns))
            unknown.push_back(file::heading_of(headings[i]).name);
    require(header, contents[0], columns, unknown);
    require(header, contents[1], columns, unknown);
    return columns;
}

}  // namespace hdconj::inspect
