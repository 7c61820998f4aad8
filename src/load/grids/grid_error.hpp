// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated discretisation errors, from the same drive on two coarser grids.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "coarse_path.hpp"

namespace hdconj::load {

/// Distance of a figure from its value on an infinitely fine grid, as its values on the grid asked for and on coarser
/// ones tell it. Two grids may agree by chance, three hardly do.
/// @param coarser  at least one value, each on a grid half as fine as the one before
[[nodiscard]] double grid_difference(double fine, std::span<double const> coarser);

/// Estimated error over grid_difference(): first order, safety 3 of Roache's index (J. Fluids Eng. 116, 1994), and a
/// third more, since grids and meshes may differ in opposite senses. Below nine slices the coarse grids have fewer than
/// five and no longer converge regularly: three times as much.
[[nodiscard]] inline double grid_safety(std::size_t slices)
{
    constexpr double regular_safety = 4;
    constexpr std::size_t regular = 9;
    return slices < regular ? regular_safety * 3 : regular_safety;
}

/// Error of a number of teeth or balls that carry force. Whether the one at the border of the zone of contact carries
/// may depend on rounding, so the error is at least one for each sector. The border itself converges by first order:
/// from the grid asked for to an infinitely fine one it moves as far as from the next coarser grid to this one, and
/// half as far as between the two coarser grids. Half the safety times the larger of these is taken.
/// @param sectors  how often the ring repeats itself
/// @param safety   grid_safety()
[[nodiscard]] int count_error(int fine, std::span<int const> coarser, int sectors, double safety);

/// Turn that closes a gap by @p length along the normal of a flank at the radius @p radius [mm, rad]. A flank is as
/// steep as the rounded edges of tips: tan(alpha) = 0.8, alpha between its normal and the circumference.
[[nodiscard]] double turn_to_close(double length, double radius);

/// Error of the play @p width between the first touches of both sides [rad] from its values on coarser grids. First
/// touches of all grids may agree by chance, but places of teeth are known no better than the wall: where it moves by
/// w, each of two flanks is reached w tan(alpha)/r later, alpha between its normal and the circumference. No figure of
/// the play gets less.
/// @param coarser  at least one
/// @param wall     wall_difference() [mm]
/// @param radius   r [mm]
[[nodiscard]] double backlash_error(double width, std::span<double const> coarser, double wall, double radius,
                                    double safety);

/// Errors of the states of @p branch.
/// @param coarser  each on a grid half as fine as the one before; empty: nothing is known
/// @returns one for each state; none where the first of the coarser grids has no equilibrium
[[nodiscard]] std::vector<std::optional<LoadedState>> branch_errors(LoadProblem const& problem,
                                                                    TorqueBranch const& branch,
                                                                    std::vector<CoarseBranch> const& coarser);

}  // namespace hdconj::load
