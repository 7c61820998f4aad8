// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the forces of single teeth and balls, and of each member's part of the twist.
#pragma once

#include <vector>

#include "branch_on_grids.hpp"

namespace hdconj::load {

/// Errors of values that stand side by side, from the same values on coarser grids. A single value may agree by chance:
/// each gets the largest difference of itself and two neighbours on either side, and of those that are not zero on
/// every grid none counts less than their root mean square.
/// @param fine     values around the ring
/// @param coarser  as many on each coarser grid, at least one
/// @param factor   of the error over the difference
[[nodiscard]] std::vector<double> errors_side_by_side(std::vector<double> const& fine,
                                                      std::vector<std::vector<double>> const& coarser, double factor);

/// Enters the errors of single forces at the largest torque, and of the members of the twist there. Nothing where no
/// coarser grid has an equilibrium at that torque.
/// @param paths    of the case
/// @param coarser  its branch of the largest torque on the coarser grids
/// @param result   with its forces, its members and the error of its backlash
void enter_force_errors(PathsOnGrids const& paths, DriveGrids const& drives, std::vector<CoarseBranch> const& coarser,
                        LoadCase& result);

}  // namespace hdconj::load
