// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The figures of one torque.
#pragma once

#include "hdconj/load.hpp"
#include "load_problem.hpp"

namespace hdconj::load {

/// Figures of a drive in equilibrium. @param middle  turn from which the twist counts [rad]
[[nodiscard]] LoadedState loaded_state(LoadProblem const& problem, LoadedDrive const& loaded, double middle);

}  // namespace hdconj::load
