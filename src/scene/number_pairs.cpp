// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/number_pairs.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include "column_units.hpp"
#include "hdconj/scene/parameter_fault.hpp"

namespace hdconj {

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
    for (std::size_t k = 0; k < 2; ++k)
    {
        skip(k == 0 ? " \t" : " \t,;");
        auto const [next, error] = std::from_chars(at, end, p[k]);
        if (error != std::errc{})
            return false;
        at = next;
    }
    skip(" \t\r");
    return at == end;
}

}  // namespace

std::filesystem::path number_file(FamilyChoice const& choice, std::string_view key, std::filesystem::path const& folder)
{
    std::filesystem::path const file = choice.word(key).value_or("");
    return file.is_relative() ? folder / file : file;
}

NumberPairs read_number_pairs(FamilyChoice const& choice, std::string_view key, std::string const& folder, std::array<ColumnQuantity, 2> const& columns,
                              std::string_view what, Faults& faults)
{
    auto const refuse = [&](std::string reason, std::string remedy) {
        faults.push_back(parameter_fault(choice, key, std::move(reason), std::move(remedy)));
        return NumberPairs{};
    };
    std::filesystem::path const file = number_file(choice, key, folder);
    NumberPairs pairs{file.string(), {}};
    std::error_code ignored;
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file, ignored))
        return refuse("cannot be read: " + pairs.file, "write the name of a CSV file, relative to the scene file");
    // a device has no end, and may have no line either
    if (!std::filesystem::is_regular_file(file, ignored))
        return refuse("is no file of numbers: " + pairs.file, "write the name of a CSV file, relative to the scene file");
    std::string const thin_it = "write at most " + std::to_string(most_number_pairs) + " lines, such as every tenth";
    if (std::filesystem::file_size(file, ignored) > largest_number_file)
        return refuse(pairs.file + " is larger than " + std::to_string(largest_number_file >> 20) + " MiB", thin_it);
    std::string line;
    int number = 0;
    bool header_seen = false;
    detail::ColumnUnits units;
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    while (std::getline(in, line))
    {
        ++number;
        if (number == 1 && line.starts_with(byte_order_mark))
            line.erase(0, byte_order_mark.size());
        line.erase(std::find(line.begin(), line.end(), '#'), line.end());
        if (line.find_first_not_of(" \t\r") == std::string::npos)
            continue;
        NumberPair row{{}, number};
        bool const ok = read_pair(line, row.value);
        if (!ok && pairs.rows.empty() && !header_seen)
        {
            header_seen = true;
            units = detail::column_units(line, columns);
            if (!units.reason.empty())
                return refuse("line " + std::to_string(number) + " of " + pairs.file + ": " + units.reason, units.remedy);
            continue;
        }
        for (std::size_t k = 0; k < row.value.size(); ++k)
            row.value[k] *= units.factor[k];
        if (!ok || !std::isfinite(row.value[0]) || !std::isfinite(row.value[1]))
            return refuse("line " + std::to_string(number) + " of " + pairs.file + " is not a pair of finite numbers",
                          "write two numbers " + std::string(what) + " on each line");
        if (pairs.rows.size() == most_number_pairs)
            return refuse(pairs.file + " holds more than " + std::to_string(most_number_pairs) + " points", thin_it);
        pairs.rows.push_back(row);
    }
    return pairs;
}

}  // namespace hdconj
