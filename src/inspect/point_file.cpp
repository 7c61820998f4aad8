// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "dxf_points.hpp"
#include "file/csv.hpp"
#include "file/listed_faults.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/inspect.hpp"
#include "scene/column_units.hpp"

namespace hdconj::inspect {
namespace {

/// One column of the file.
struct PointColumn
{
    std::size_t at = 0;   ///< number of the column, from 0
    double factor = 1;    ///< to mm
    std::string heading;  ///< as written; empty: the file has no such column

    [[nodiscard]] bool given() const { return !heading.empty(); }
};

/// The columns that a header names.
struct PointColumns
{
    char separator = ',';
    PointColumn x, y, z, tooth, flank;
};

/// How a file of points begins, for messages.
constexpr char const* first_line = "begin the file with a line that names its columns, such as x,y";

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

/// Reads the header @p text of the file @p name. Faults are added to @p faults; the columns are of no use where there
/// are any.
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

constexpr double most_tooth_number = 1e6;

Fault point_file_fault(std::string const& file, std::string reason, std::string remedy)
{
    return {"POINTS", 0, file, std::move(reason), std::move(remedy)};
}

Fault fault_of_points(file::Unreadable cause, std::string const& file)
{
    using enum file::Unreadable;
    if (cause == too_large)
        return point_file_fault(file, fmt::format("is larger than {} MiB", largest_point_file >> 20),
                                "keep every tenth point or so");
    return point_file_fault(file,
                            cause == is_folder    ? "is a folder"
                            : cause == not_opened ? "cannot be read"
                                                  : "is no file that ends",
                            cause == not_opened ? "write the name of a file of points that is there"
                                                : "write the name of a file of points");
}

/// One line of the file, and where its faults go.
struct PointLine
{
    std::vector<std::string_view> fields;
    int number;
    std::string const& file;
    Faults& faults;

    [[nodiscard]] std::string_view field(PointColumn const& column) const
    {
        return column.at < fields.size() ? fields[column.at] : std::string_view();
    }
    void refuse_field(PointColumn const& column, std::string reason, std::string remedy) const
    {
        faults.push_back({fmt::format("column {}, {}", column.at + 1, column.heading), number, printable(field(column)),
                          std::move(reason), std::move(remedy), file});
    }
};

double length_in(PointLine const& line, PointColumn const& column)
{
    if (!column.given())
        return 0;
    std::string_view const text = line.field(column);
    auto const value = file::number_in(text);
    if (!value)
        line.refuse_field(column, text.empty() ? "is missing" : "is no finite number",
                          text.find(',') != std::string_view::npos ? "write a point in place of the decimal comma"
                                                                   : "write a number such as 12.5");
    else if (std::abs(*value * column.factor) > farthest)
        line.refuse_field(column, "is no coordinate of a gear", "write lengths in mm, or the unit after the heading");
    return value.value_or(0) * column.factor;
}

int tooth_in(PointLine const& line, PointColumn const& column)
{
    if (!column.given())
        return 0;
    auto const value = file::number_in(line.field(column));
    if (value && *value == std::floor(*value) && *value >= 1 && *value <= most_tooth_number)
        return static_cast<int>(*value);
    line.refuse_field(column, "is no number of a tooth", "write a whole number from 1 on");
    return 0;
}

std::optional<bool> flank_in(PointLine const& line, PointColumn const& column)
{
    if (!column.given())
        return std::nullopt;
    std::string const word = file::lower_case(line.field(column));
    if (word == "right" || word == "r")
        return true;
    if (word == "left" || word == "l")
        return false;
    line.refuse_field(column, "is no flank", "write left or right");
    return std::nullopt;
}

/// Adds the point of one line. @returns whether to read on
bool add_point_of_line(PointColumns const& columns, PointLine const& line, PointFile& measured)
{
    double const x = length_in(line, columns.x), y = length_in(line, columns.y);
    measured.points.push_back({Vec2(x, y), length_in(line, columns.z), tooth_in(line, columns.tooth),
                               flank_in(line, columns.flank), line.number});
    return measured.points.size() <= most_part_points;
}

std::optional<file::Unreadable> read_csv_points(std::filesystem::path const& file, PointReading& result)
{
    PointFile& measured = result.measured;
    std::optional<PointColumns> columns;
    file::FurtherFaults further;
    auto const unreadable = file::read_csv(file, largest_point_file, [&](std::string_view text, int number) {
        if (!columns) {
            columns = point_columns(file::trimmed(text), number, measured.file, result.faults);
            measured.has_z = columns->z.given();
            return result.faults.empty();
        }
        PointLine const line{file::fields_of(text, columns->separator), number, measured.file, result.faults};
        bool const more = add_point_of_line(*columns, line, measured);
        further.take_from(result.faults);
        return more;
    });
    further.add_to(result.faults, measured.file);
    if (!unreadable && result.faults.empty() && measured.points.empty())
        result.faults.push_back(point_file_fault(measured.file,
                                                 columns ? "has a header and no points" : "has no header and no points",
                                                 columns ? "write one point a line" : first_line));
    return unreadable;
}

}  // namespace
}  // namespace hdconj::inspect

namespace hdconj {

PointReading examine_points(std::filesystem::path const& file)
{
    PointReading result;
    PointFile const& measured = result.measured;
    result.measured.file = file.string();
    bool const drawing = file::lower_case(file.extension().string()) == ".dxf";
    auto const unreadable = drawing ? inspect::read_dxf_points(file, result) : inspect::read_csv_points(file, result);
    if (unreadable)
        result.faults.push_back(inspect::fault_of_points(*unreadable, measured.file));
    else if (result.faults.empty() && measured.points.empty())
        result.faults.push_back(inspect::point_file_fault(measured.file, "has no POINT and no polyline",
                                                          "draw the points as points or as vertices of a polyline"));
    else if (measured.points.size() > most_part_points)
        result.faults.push_back(inspect::point_file_fault(
            measured.file, fmt::format("holds more than {} points", most_part_points), "keep every tenth point or so"));
    return result;
}

}  // namespace hdconj
