// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated discretisation errors, from the same drive on a coarser grid.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "assembled_drive.hpp"
#include "torque_branch.hpp"

namespace hdconj::load {

/// The grid asked for and a coarser one, with what yields in series with either.
struct DrivePair
{
    AssembledDrive fine;
    std::optional<AssembledDrive> coarse;
    std::vector<TwistMember> series = {};  ///< with their stiffness
};

/// Estimated error over the difference to a grid half as fine: two grids, first order, safety 3 of Roache's index (J.
/// Fluids Eng. 116, 1994), and a third more, since grids and meshes may differ in opposite senses. Below nine slices
/// the coarse grid has fewer than five and no longer converges regularly: three times as much.
[[nodiscard]] inline double grid_safety(std::size_t slices)
{
    constexpr double two_grids = 4;
    constexpr std::size_t regular = 9;
    return slices < regular ? two_grids * 3 : two_grids;
}

/// Error of the largest stress from two grids and from the corners of its element, which the stress is extrapolated to.
/// All in MPa. A quarter of their sum: of 24 random drives the sum was at least eighteen times the distance from a grid
/// four times finer, and of five drives with fillets at least nine times.
[[nodiscard]] double stress_error(double fine, double coarse, double at_corners, double safety);

/// Enters the errors of @p cup, as it is on the fine grid.
/// Domain: a pair with a coarse grid.
void estimate_errors(contact::ContactContext const& context, DrivePair const& drives, AssembledCup& cup);

/// The coarse grid's path with the surface of @p flanks, about the middle of @p fine; nothing where that has no play or
/// no balance without torque.
/// @param problem  on the coarse grid
[[nodiscard]] std::optional<TorqueContinuation> coarse_path(LoadProblem const& problem, LoadedDrive const& unloaded,
                                                            TorqueContinuation const& fine);

/// Errors of the states of a branch.
struct BranchErrors
{
    std::vector<std::optional<LoadedState>> states;  ///< none where the coarse grid has no equilibrium
    std::vector<LoadedState> coarse;                 ///< the equilibria that it has
    Eigen::MatrixXd last_forces;                     ///< on the coarse cup at the last torque; empty: unknown
};

/// @param coarse  path on the coarse grid
/// @param branch  on the fine grid, with stiffness
[[nodiscard]] BranchErrors branch_errors(TorqueContinuation const& coarse, TorqueBranch const& branch, double safety);

}  // namespace hdconj::load
