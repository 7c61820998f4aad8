// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a settled torque is told as.
#pragma once

#include "hdconj/pipeline/load_study.hpp"
#include "load_settle.hpp"

namespace hdconj::detail {

/// Figures of one torque. @param middle  turn that twist is counted from [rad]
[[nodiscard]] LoadedState summary_of(LoadWork const& work, Loaded const& loaded, double torque, double middle);

/// Forces over space, flank and slice.
[[nodiscard]] LoadMap map_of(LoadWork const& work, Loaded const& loaded, double torque);

}  // namespace hdconj::detail
