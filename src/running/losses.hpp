// SPDX-License-Identifier: GPL-3.0-or-later
// Friction over torque, speed and temperature.
#pragma once

#include "friction_loss.hpp"
#include "run_scene.hpp"
#include "sequences.hpp"

namespace hdconj::running {

/// Forces and velocities of the drive without torque and under each torque of @p task, at @ref loss_positions even
/// positions over a tooth pitch. A position without balances is told and left out.
[[nodiscard]] std::vector<LoadedRun> loaded_runs(TurningDrive const& drive, RunTask const& task,
                                                 SequenceObserver const& observer);

inline constexpr int loss_positions = 4;

/// What follows from them. @param coarse  of the coarse grid; empty: no errors
/// @param safety  of the difference of both grids
[[nodiscard]] RunLosses run_losses(LossModel const& model, RunTask const& task, std::vector<LoadedRun> const& runs,
                                   std::vector<LoadedRun> const& coarse, double safety);

}  // namespace hdconj::running
