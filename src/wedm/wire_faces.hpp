// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The faces that a wire is to cut, of either member.
#pragma once

#include "faces.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::wedm {

/// One pitch of both faces from the first and last slice of @p outline. Only one slice: both faces are that.
[[nodiscard]] WireFaces wire_faces(CircularSplineOutline const& outline, int teeth);

/// One pitch of the flexspline as it is made, round and without load: its tooth at the radius r_m of the neutral
/// circle, and between two teeth the root, an arc about the axis through the lowest points of both (where they are at
/// different radii, evenly from one to the other). Both faces are the same.
/// @param solved  where the circular spline's tooth is given: the solution, which has the flexspline's tooth; else null
/// @throws InputError where the tooth has an edge in place of a tip, or a land narrower than wedm.tolerance;
/// NumericalError where no root is left
[[nodiscard]] WireFaces flexspline_faces(Scene const& scene, Solution const* solved = nullptr);

}  // namespace hdconj::wedm
