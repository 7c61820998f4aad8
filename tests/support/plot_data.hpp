// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the data of a plot's script.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace hdconj::test {

/// Lines of the block $NAME, of one of its indices, which two empty lines part; empty lines are left out.
inline std::vector<std::string> plot_lines(std::string const& script, std::string const& name, int index = 0)
{
    std::istringstream lines(script);
    std::string line;
    while (std::getline(lines, line) && line != "$" + name + " << EOD") {
    }
    std::vector<std::string> found;
    int at = 0, empty = 0;
    while (std::getline(lines, line) && line != "EOD") {
        if (line.empty()) {
            ++empty;
            continue;
        }
        at += empty > 1 ? 1 : 0;
        empty = 0;
        if (at == index)
            found.push_back(line);
    }
    return found;
}

/// The numbers at the beginning of those lines; lines without any are left out.
inline std::vector<std::vector<double>> plot_rows(std::string const& script, std::string const& name, int index = 0)
{
    std::vector<std::vector<double>> found;
    for (auto const& line : plot_lines(script, name, index)) {
        std::istringstream numbers(line);
        std::vector<double> row;
        for (double number = 0; numbers >> number;)
            row.push_back(number);
        if (!row.empty())
            found.push_back(row);
    }
    return found;
}

}  // namespace hdconj::test
