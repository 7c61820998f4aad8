// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/number_pairs.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "column_units.hpp"
#include "file/csv.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::scene {
namespace {

/// Headings between commas, semicolons or tabs; where there are none, between blanks, a bracket with the word before
/// it.
std::vector<std::string_view> headings_of(std::string_view header)
{
    std::vector<std::string_view> headings;
    bool const marked = header.find_first_of(",;\t") != std::string_view::npos;
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= header.size(); ++at) {
        bool const bracket_follows = !marked && header.substr(std::min(at + 1, header.size())).find_first_of("[(") == 0;
        if (at < header.size() &&
            (std::string_view(marked ? ",;\t" : " ").find(header[at]) == std::string_view::npos || bracket_follows))
            continue;
        std::string_view const heading = without_blanks(header.substr(begin, at - begin));
        if (marked || !heading.empty())
            headings.push_back(heading);
        begin = at + 1;
    }
    return headings;
}

/// What a header says of its two columns.
struct ColumnUnits
{
    std::array<double, 2> factor{1, 1};  ///< to mm and degrees
    std::string reason;                  ///< why the header is refused; empty: it is not
    std::string remedy;
};

/// Reads the units of @p header: "x [inch]", "angle (rad)", "x_mm", "angle um", or the unit alone. A column without one
/// is in mm or degrees.
ColumnUnits column_units(std::string_view header, std::array<ColumnQuantity, 2> const& columns)
{
    ColumnUnits found;
    auto const headings = headings_of(without_blanks(header));
    if (headings.size() != columns.size()) {
        // a title is no header, but one with a unit may be meant for the columns
        if (auto const unit = unit_in_brackets(header); unit && is_unit(*unit)) {
            found.reason = "names the unit [" + std::string(*unit) + "], and not of which of two columns";
            found.remedy = columns[0] == ColumnQuantity::length
                               ? "write the header x [mm],y [mm], or remove it"
                               : "write the header angle [deg],displacement [mm], or remove it";
        }
        return found;
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
        auto const unit = unit_in(headings[k]);
        if (!unit)
            continue;
        auto const factor = factor_of_unit(*unit, columns[k]);
        if (!factor) {
            found.reason =
                "column " + std::to_string(k + 1) + ", " + std::string(headings[k]) + ": the unit is not known";
            found.remedy = write_known_unit(columns[k]);
            return found;
        }
        found.factor[k] = *factor;
    }
    return found;
}

/// Two numbers separated by a comma, semicolon, tab or blanks; nothing else on the line.
bool read_pair(std::string_view line, std::array<double, 2>& p)
{
    char const* at = line.data();
    char const* const end = at + line.size();
    auto const skip = [&](std::string_view what) {
        while (at < end && what.find(*at) != std::string_view::npos)
            ++at;
    };
    for (std::size_t k = 0; k < 2; ++k) {
        skip(k == 0 ? " \t" : " \t,;");
        auto const [next, error] = std::from_chars(at, end, p[k]);
        if (error != std::errc{})
            return false;
        at = next;
    }
    skip(" \t\r");
    return at == end;
}

/// "0,084;0,2" as it should be written; empty where @p line has no decimal commas.
std::string with_decimal_points(std::string_view line)
{
    std::string text(line);
    auto const separator = text.find_first_of(";\t ");
    if (separator == std::string::npos || text.find(',') == std::string::npos)
        return "";
    std::replace(text.begin(), text.end(), ',', '.');
    std::array<double, 2> both{};
    return read_pair(text, both) ? text : "";
}

/// Why the pair @p row cannot be a point; empty when it can.
std::string fault_of(NumberPair const& row, std::array<ColumnQuantity, 2> const& columns)
{
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (!std::isfinite(row.value[k]))
            return "is not a pair of finite numbers";
        if (columns[k] == ColumnQuantity::length && std::abs(row.value[k]) > bounds::largest_length)
            return "has a length larger than any drive (" + number_text(bounds::largest_length) + " mm)";
    }
    return "";
}

}  // namespace

std::filesystem::path number_file(FamilyChoice const& choice, std::string_view key, std::filesystem::path const& folder)
{
    std::filesystem::path const file = choice.word(key).value_or("");
    return file.is_relative() ? folder / file : file;
}

NumberPairs read_number_pairs(FamilyChoice const& choice, std::string_view key, std::string const& folder,
                              std::array<ColumnQuantity, 2> const& columns, std::string_view what, Faults& faults)
{
    auto const refuse = [&](std::string reason, std::string remedy) {
        faults.push_back(parameter_fault(choice, key, std::move(reason), std::move(remedy)));
        return NumberPairs{};
    };
    NumberPairs pairs{number_file(choice, key, folder).string(), {}};
    std::string const thin_it = "write at most " + std::to_string(most_number_pairs) + " lines, such as every tenth";
    bool header_seen = false;
    bool refused = false;
    ColumnUnits units;
    auto const stop = [&](std::string reason, std::string remedy) {
        refused = true;
        refuse(std::move(reason), std::move(remedy));
        return false;
    };
    auto const given = choice.given.find(key);
    std::string const* const content = given == choice.given.end() ? nullptr : given->second.content.get();
    auto const unreadable =
        file::read_csv(pairs.file, content, largest_number_file, [&](std::string_view line, int number) {
            line = line.substr(0, line.find('#'));
            NumberPair row{{}, number};
            bool const ok = read_pair(line, row.value);
            if (!ok && pairs.rows.empty() && !header_seen) {
                header_seen = true;
                units = column_units(line, columns);
                return units.reason.empty() ||
                       stop("line " + std::to_string(number) + " of " + pairs.file + ": " + units.reason, units.remedy);
            }
            for (std::size_t k = 0; k < row.value.size(); ++k)
                row.value[k] *= units.factor[k];
            std::string const place = "line " + std::to_string(number) + " of " + pairs.file + " ";
            if (auto const right = ok ? "" : with_decimal_points(line); !right.empty())
                return stop(place + "has decimal commas", "write decimal points: " + right);
            auto const fault = ok ? fault_of(row, columns) : "is not a pair of finite numbers";
            if (!fault.empty())
                return stop(place + fault, "write two numbers " + std::string(what) + " on each line");
            if (pairs.rows.size() == most_number_pairs)
                return stop(pairs.file + " holds more than " + std::to_string(most_number_pairs) + " points", thin_it);
            pairs.rows.push_back(row);
            return true;
        });
    if (refused)
        return NumberPairs{};
    if (!unreadable)
        return pairs;
    std::string const name_it = "write the name of a CSV file, relative to the scene file";
    if (*unreadable == file::Unreadable::too_large)
        return refuse(pairs.file + " is larger than " + std::to_string(largest_number_file >> 20) + " MiB", thin_it);
    if (*unreadable == file::Unreadable::endless)
        return refuse("is no file of numbers: " + pairs.file, name_it);
    return refuse("cannot be read: " + pairs.file, name_it);
}

}  // namespace hdconj::scene
