// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the reference table of envelope points of the built-in scene to standard output:
///
///   make_table > data/reference/type-50-envelope.csv
///
/// Computed in 50 digits by the oracle, printed with 30 places. Of the program only the reader of
/// the scene is used.
#include <iostream>

#include "support/oracle/reference_table.hpp"
#include "support/oracle/run.hpp"

int main()
{
    std::cout
        << "# Envelope points of type-50 (data/scenes/type-50.toml), made by tests/reference/make_table.cpp.\n"
           "# Pieces of the whole tooth from the left root over the tip to the right root; t from 0 to 1 along the\n"
           "# piece, proportional to arc length; u and phi in rad, x and y in mm in the circular-spline frame.\n"
        << oracle::table_header << "\n";
    for (auto const kinematics : hdconj::all_kinematics)
        for (auto const& row : oracle::computed_rows(hdconj::builtin_scene(), kinematics))
            std::cout << oracle::table_line(row) << "\n";
}
