// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/number_pairs.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "column_units.hpp"
#include "file/csv.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::scene {

namespace {

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
    auto const unreadable = file::read_csv(pairs.file, largest_number_file, [&](std::string_view line, int number) {
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
