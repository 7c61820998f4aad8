// SPDX-License-Identifier: GPL-3.0-or-later
// A drive and its torques on coarser grids, for the errors of its figures.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "assembled_drive.hpp"
#include "load/study/torque_branch.hpp"

namespace hdconj::load {

/// The grid asked for and coarser ones, with what yields in series with all of them.
struct DriveGrids
{
    AssembledDrive fine;
    std::vector<AssembledDrive> coarser = {};  ///< coarser_drives(); empty: no errors
    std::vector<TwistMember> series = {};      ///< with their stiffness
};

/// One surface on a coarser grid. Refers to the drive that it was made from.
struct CoarsePath
{
    contact::FlankGrid flanks;
    LoadProblem problem;
    std::optional<TorqueContinuation> path;  ///< nothing where the grid has no play or no balance without torque

    /// The path on the grid of @p drive.
    /// @param finer  flanks of the grid that is twice as fine
    /// @param fine   path on the grid asked for; twist counts from its middle
    CoarsePath(contact::ContactContext const& context, AssembledDrive const& drive, contact::FlankGrid const& finer,
               TorqueContinuation const& fine);
    CoarsePath(CoarsePath const&) = delete;
    CoarsePath& operator=(CoarsePath const&) = delete;
};

/// The paths of a surface on the coarser grids of @p drives, as far as each has one.
[[nodiscard]] std::vector<std::unique_ptr<CoarsePath>> coarse_paths(contact::ContactContext const& context,
                                                                    DriveGrids const& drives,
                                                                    TorqueContinuation const& fine);

/// A branch on a coarser grid, at the torques of the branch on the grid asked for.
struct CoarseBranch
{
    std::vector<std::optional<LoadedState>> states;  ///< one for each torque; none: no equilibrium
    std::optional<LoadedDrive> last;                 ///< at the last torque; none: no equilibrium

    /// The states that there are.
    [[nodiscard]] std::vector<LoadedState> solved() const;
};

/// @param branch  on the grid asked for, with stiffness
[[nodiscard]] CoarseBranch coarse_branch(TorqueContinuation const& coarse, TorqueBranch const& branch);

}  // namespace hdconj::load
