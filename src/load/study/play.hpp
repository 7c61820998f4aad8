// SPDX-License-Identifier: GPL-3.0-or-later
// The play of an assembled drive without torque.
#pragma once

#include <optional>

#include "load_problem.hpp"

namespace hdconj::load {

/// Turns of the flexspline at which flanks first touch on either side, without torque.
struct Play
{
    double right = 0;             ///< to the first touch of right flanks, clockwise [rad]
    double left = 0;              ///< to the first touch of left flanks, counter-clockwise [rad]
    bool tips_interfere = false;  ///< along the radius, so that no turn brings them apart
};

/// How far the drive turns freely [rad]; negative where teeth press on both flanks, or tips along a radius, at every
/// turn.
[[nodiscard]] inline double width_of(Play const& play)
{
    return play.right + play.left;
}
/// The turn in the middle of the play [rad].
[[nodiscard]] inline double middle_of(Play const& play)
{
    return 0.5 * (play.right - play.left);
}

/// The play of teeth in @p shape. Nothing where they interfere by more than the accuracy of the finite-element model at
/// every turn within a pitch; of negative width where they interfere by less. Tips that interfere count as much as
/// flanks, so that no play is smaller than that of the same drive with more material.
[[nodiscard]] std::optional<Play> play_of(LoadProblem const& problem, LoadedShape const& shape);

/// How deep tips interfere along a radius at a turn of the flexspline, so that no turn brings them apart; 0 within the
/// accuracy of gaps [mm].
[[nodiscard]] double tip_overlap(LoadProblem const& problem, LoadedShape const& shape, double turn);

/// The play about the turn @p middle, which lies within it; of negative width where the teeth press on both flanks.
/// Tips that pass each other do not count: they may interfere where the drive runs.
/// @throws NumericalError where no turn within a pitch brings the teeth apart
[[nodiscard]] Play play_about(LoadProblem const& problem, LoadedShape const& shape, double middle);

}  // namespace hdconj::load
