// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The reference table of envelope points: how a row is written and read.
#pragma once

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "envelope.hpp"

namespace oracle {

/// Points per profile piece: t = 0, 1/16, ... 1, exactly representable.
inline constexpr int table_steps = 16;

/// Digits after the point of one in the table.
inline constexpr int table_digits = 30;

inline constexpr char const* table_header = "kinematics,segment,piece,t,u,phi,x,y";

struct TableRow
{
    hdconj::Kinematics kinematics = hdconj::Kinematics::exact;
    std::size_t segment = 0;
    std::string piece;
    Fifty t, u, phi;
    Point<Fifty> point;
};

/// Rounded to table_digits places; a plain 0 for what is zero within them.
inline std::string table_number(Fifty const& value)
{
    Fifty const smallest("0.5e-30");
    return (abs(value) < smallest ? Fifty(0) : value).str(table_digits, std::ios::fixed);
}

inline std::string table_line(TableRow const& row)
{
    std::string line(hdconj::to_string(row.kinematics));
    line += "," + std::to_string(row.segment) + "," + row.piece + "," + row.t.str(6);
    for (Fifty const& value : {row.u, row.phi, row.point.x, row.point.y})
        line += "," + table_number(value);
    return line;
}

/// The rows of one kinematics, computed.
inline std::vector<TableRow> computed_rows(hdconj::Scene scene, hdconj::Kinematics kinematics)
{
    scene.solver.kinematics = kinematics;
    Tooth<double> const tooth(scene);
    std::vector<TableRow> rows;
    for (auto const& found : envelope_points<Fifty>(scene, table_steps))
        rows.push_back(
            {kinematics, found.segment, tooth.name_of_whole(found.segment), found.t, found.u, found.phi, found.point});
    return rows;
}

inline std::vector<TableRow> read_rows(std::string const& file)
{
    std::ifstream in(file);
    std::string line;
    std::vector<TableRow> rows;
    while (std::getline(in, line)) {
        if (line.empty() || line.front() == '#' || line == table_header)
            continue;
        std::istringstream fields(line);
        std::vector<std::string> field;
        for (std::string one; std::getline(fields, one, ',');)
            field.push_back(one);
        if (field.size() != 8)
            throw std::runtime_error("reference table: bad line: " + line);
        auto const kinematics = std::find_if(hdconj::all_kinematics.begin(), hdconj::all_kinematics.end(),
                                             [&](auto model) { return to_string(model) == field[0]; });
        if (kinematics == hdconj::all_kinematics.end())
            throw std::runtime_error("reference table: bad line: " + line);
        rows.push_back({*kinematics,
                        std::stoul(field[1]),
                        field[2],
                        Fifty(field[3]),
                        Fifty(field[4]),
                        Fifty(field[5]),
                        {Fifty(field[6]), Fifty(field[7])}});
    }
    return rows;
}

}  // namespace oracle
