// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated discretisation errors of the cup on its wave generator and of its largest stress.
#pragma once

#include <span>

#include "coarse_path.hpp"

namespace hdconj::load {

/// Difference of the assembled wall between grids, as grid_difference(): the largest radial one in a slice [mm].
/// Domain: drives with a coarse grid.
[[nodiscard]] double wall_difference(contact::ContactContext const& context, DriveGrids const& drives);

/// Enters the errors of @p cup, as it is on the fine grid.
/// Domain: drives with a coarse grid.
void estimate_errors(contact::ContactContext const& context, DriveGrids const& drives, AssembledCup& cup);

/// Error of the largest stress from its values on all grids, from CupStress::unresolved and from what
/// spread_over_slices() changes, @p of_slices. All in MPa. Half of the sum of the first two, and no less than 8 % of
/// the stress, since the grids have elements of the same length: 34 drives, 16 of them designed, 18 like type-50, are
/// within it of a grid with four times the slices and elements a quarter as large. Slices and harmonics of coarser
/// grids may cancel; so no less than 1.5 times what slices change, which is about what 33 slices change.
[[nodiscard]] double stress_error(double fine, std::span<double const> coarser, double unresolved, double of_slices,
                                  double safety);

}  // namespace hdconj::load
