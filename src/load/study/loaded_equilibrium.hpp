// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Forces and loaded shape that reproduce each other at one torque.
#pragma once

#include "load_problem.hpp"

namespace hdconj::load {

/// Equilibrium at @p torque [N mm], iterated from the shape of @p start on until the gaps of the loaded shape are those
/// of the linear model to gap_tolerance().
/// @throws NumericalError with the torque where the iteration does not converge, or no flank carries the torque
[[nodiscard]] LoadedDrive converged_at(LoadProblem const& problem, double torque, LoadedDrive const& start);

}  // namespace hdconj::load
