// SPDX-License-Identifier: GPL-3.0-or-later
// What the contacts of each flank and slice add up to.
#pragma once

#include <cstddef>
#include <vector>

#include "load_problem.hpp"

namespace hdconj::load {

/// Values over (space, flank, slice) of one sector, all contacts of a flank and slice together.
struct FlankTable
{
    std::size_t slices = 0;
    std::vector<double> force;       ///< [N]
    std::vector<double> line_load;   ///< [N/mm]
    std::vector<double> pressure;    ///< largest [MPa]
    std::vector<double> off_edges;   ///< the same of contacts that lie on no edge [MPa]
    std::vector<double> on_edges;    ///< force of those that do [N]
    std::vector<double> flowing;     ///< force of those where the steel flows [N]
    std::vector<double> gap;         ///< smallest [mm]; of a loaded contact minus its approach; infinite: none is near
    std::vector<double> height;      ///< of that contact along the flank, 0 at the land corner ... 1 at the flank end
    std::vector<double> half_width;  ///< of the strips under pressure [mm]

    [[nodiscard]] std::size_t index(std::size_t space, std::size_t flank, std::size_t slice) const
    {
        return (2 * space + flank) * slices + slice;
    }
};

[[nodiscard]] FlankTable flank_table(LoadProblem const& problem, LoadedDrive const& loaded);

/// Area under pressure on the flanks of one side [mm^2]: Hertz strips. Between two loaded slices the strip has the
/// widths of both; from a loaded slice to an unloaded one it reaches as far as the force, which falls linearly through
/// the gap there.
[[nodiscard]] double pressed_area(LoadProblem const& problem, FlankTable const& table, std::size_t flank);

}  // namespace hdconj::load
