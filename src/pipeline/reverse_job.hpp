// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `solve` for the reverse problem, after the motion is known: the circular spline's tooth given, the flexspline's solved for.
#pragma once

#include "hdconj/motion/erased_motion.hpp"
#include "hdconj/profile/profile.hpp"
#include "stage_clock.hpp"

namespace hdconj::detail {

/// @param given   the circular-spline tooth in its own frame
/// @param motion  of the flexspline tooth, any model
void solve_reverse(Solution& out, Profile const& given, ErasedMotion const& motion, StageClock& clock);

}  // namespace hdconj::detail
