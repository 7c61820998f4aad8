// SPDX-License-Identifier: GPL-3.0-or-later
// Friction over torque, speed and temperature.
#pragma once

#include "friction_loss.hpp"
#include "run_scene.hpp"
#include "sequences.hpp"

namespace hdconj::running {

inline constexpr int loss_positions = 4;

/// The drive under the torques that its losses follow from.
struct LossRuns
{
    std::vector<LoadedRun> asked;    ///< without torque and under each torque of the task; empty: no results
    std::vector<LoadedRun> between;  ///< under further torques, near the back-driving torque
    /// By how much that torque moved with the last of them; without any, the interval that it lies in [N mm].
    double unsettled = 0;

    [[nodiscard]] std::vector<LoadedRun> with_between() const;  ///< in order of torque
};

/// Forces and velocities at @ref loss_positions even positions over a tooth pitch. Torques near the back-driving torque
/// are added until that moves by at most a thousandth. A position without balances is told and left out.
[[nodiscard]] LossRuns loss_runs(LossModel const& model, TurningDrive const& drive, RunTask const& task,
                                 SequenceObserver const& observer);

/// The same drive on another grid, under the torques of @p like.
[[nodiscard]] LossRuns loss_runs_like(LossRuns const& like, TurningDrive const& drive, RunTask const& task,
                                      SequenceObserver const& observer);

/// What follows from them.
/// @param coarser  of coarser grids, the next one first; those without results do not count, and without any there are
///                 no errors
/// @param safety   of the differences of grids
[[nodiscard]] RunLosses run_losses(LossModel const& model, RunTask const& task, LossRuns const& runs,
                                   std::vector<LossRuns> const& coarser, double safety);

}  // namespace hdconj::running
