// SPDX-License-Identifier: GPL-3.0-or-later
// A branch of a torque-twist curve with the errors of its states.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "coarse_path.hpp"

namespace hdconj::load {

/// Whether the drive under a torque is the mirror image of itself under the opposite one.
[[nodiscard]] bool is_mirror_image(contact::ContactContext const& context);

/// A branch with its errors.
struct BranchWithErrors
{
    TorqueBranch branch;
    std::vector<CoarseBranch> coarser;               ///< on the coarser grids
    std::vector<std::optional<LoadedState>> errors;  ///< one for each state; none: unknown
};

/// The paths of a case on the grid asked for and on coarser grids.
struct PathsOnGrids
{
    TorqueContinuation const& fine;
    std::vector<std::unique_ptr<CoarsePath>> const& coarser;
    double series;  ///< compliance in series with the teeth [rad/(N mm)]; 0: none
};

/// @param on_state  as that of torque_branch()
/// @throws NumericalError as torque_branch() does
[[nodiscard]] BranchWithErrors solved_branch(PathsOnGrids const& paths, BranchTorques const& torques,
                                             std::function<void(double)> const& on_state);

/// The branch of the opposite torques: solved, or the mirror image of @p forth. Where the run is stopped before, all
/// are unsettled.
/// @param space_angle  of LoadMap
[[nodiscard]] BranchWithErrors opposite_branch(contact::ContactContext const& context, PathsOnGrids const& paths,
                                               BranchWithErrors const& forth, std::vector<double> const& space_angle,
                                               std::function<bool()> const& stop,
                                               std::function<void(double)> const& on_state);

}  // namespace hdconj::load
