// SPDX-License-Identifier: GPL-3.0-or-later
// What the wire leaves, as a note on the design.
#pragma once

#include "hdconj/note.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::wedm {

/// Puts into @p notes whether the wire of @p scene leaves more than wedm.residual_limit of a circular spline with @p
/// outline, in the place of what they say of it. Figure and advised wire are those that the verb `wedm` has for this
/// outline. Without [wedm] a common wire is judged; nothing is said where the circular spline is given.
void judge_sharp_corner(Notes& notes, Scene const& scene, CircularSplineOutline const& outline);

}  // namespace hdconj::wedm
