// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibria from torque to torque.
#pragma once

#include "load_problem.hpp"
#include "play.hpp"

namespace hdconj::load {

/// What every torque of a loading path starts from.
struct TorqueContinuation
{
    LoadProblem const& problem;
    Play play;             ///< without torque
    LoadedDrive start;     ///< without torque; where the teeth press on both flanks, in balance
    double middle = 0;     ///< turn from which twist counts [rad]
    bool pressed = false;  ///< the assembled teeth press on both flanks
};

/// @param unloaded  the cup on its wave generator without any tooth in contact
/// @param play      of the assembled drive; a negative width: the teeth press
/// @throws NumericalError as converged_at() does where the teeth press
[[nodiscard]] TorqueContinuation torque_continuation(LoadProblem const& problem, LoadedDrive const& unloaded,
                                                     Play const& play);

/// The drive at @p torque [N mm], continued from @p from, or from the first touch where @p from is not loaded to the
/// side of @p torque.
/// @throws NumericalError as converged_at() does
[[nodiscard]] LoadedDrive advance(TorqueContinuation const& path, LoadedDrive const& from, double torque);

/// Equilibrium at @p torque [N mm], iterated from the shape of @p start on until the gaps of the loaded shape are those
/// of the linear model to gap_tolerance().
/// @throws NumericalError with the torque where the iteration does not converge, or no flank carries the torque
[[nodiscard]] LoadedDrive converged_at(LoadProblem const& problem, double torque, LoadedDrive const& start);

/// Turn at @p torque [N mm] near that of the equilibrium @p start, for a chord of the curve between them: iterated
/// until it moves by no more than 2^-10 of the way from @p start. The turn settles long before all gaps do, where one
/// contact among many alternates between two places; where it does not settle in eight iterations, converged_at() tells
/// it.
/// @throws NumericalError as converged_at() does
[[nodiscard]] double turn_near(LoadProblem const& problem, double torque, LoadedDrive const& start);

}  // namespace hdconj::load
