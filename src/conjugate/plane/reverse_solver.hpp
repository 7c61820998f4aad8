// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `solve` for the reverse problem, after the motion is known: the circular spline's tooth given, the flexspline's
/// solved for.
#pragma once

#include "drive/stage_clock.hpp"
#include "hdconj/motion/any_motion.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::conjugate {

/// @param given   the circular-spline tooth in its own frame
/// @param motion  of the flexspline tooth, any model
void solve_reverse(Solution& out, profile::Profile const& given, motion::AnyMotion const& motion,
                   drive::StageClock& clock);

}  // namespace hdconj::conjugate
