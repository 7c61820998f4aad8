// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From a scene to what a wire is to do.
#pragma once

#include "hdconj/pipeline/solve.hpp"
#include "hdconj/wedm/faces.hpp"
#include "hdconj/wedm/wire_program.hpp"

namespace hdconj {

/// Faults between [wedm] and the drive: a wire wider than a pitch, a workpiece thinner than the toothing, a tilt that the machine cannot make; also that
/// there is no [wedm]. Not part of reading a scene, so that other verbs do not refuse a drive for its wire.
[[nodiscard]] Faults check_wedm(Scene const& scene);

/// The scene whose solution has the faces: its face width is the workpiece's thickness, and it has slices where the faces differ, a middle one among them
/// (for "per-slice" as many as @p scene, at least 3). Each face is a slice of the true surface; the lower one is that at z = -T/2.
[[nodiscard]] Scene wire_scene(Scene const& scene);

/// One pitch of both faces from the first and last slice of @p outline. Only one slice: both faces are that.
[[nodiscard]] WireFaces wire_faces(CircularSplineOutline const& outline, int teeth);

/// One pitch of the flexspline as it is made, round and without load: its tooth at the radius r_m of the neutral circle, and between two teeth the root, an arc
/// about the axis through the lowest points of both (where they are at different radii, evenly from one to the other). Both faces are the same.
/// Where the circular spline's tooth is given the flexspline's is solved for; else nothing is.
/// @throws InputError where the tooth has an edge in place of a tip, or a land narrower than wedm.tolerance; NumericalError where no root is left
[[nodiscard]] WireFaces flexspline_faces(Scene const& scene, StageObserver const& on_stage = {});

/// Solves wire_scene(scene) and makes the program of all passes, checked (checks.hpp).
///
/// The lower face z = 0 of the workpiece is the slice at -T/2 of the drive, the upper one that at +T/2. Each pass is the parallel of both faces in their
/// planes at wire_diameter/2 + spark_gap + stock, thinned to `tolerance`. All spaces are turned copies of one; every pass begins on a tip land.
/// @throws InputError     faults of the scene, or more residual material than residual_limit
/// @throws NumericalError the drive cannot be solved, or a check failed: all failures in one message
[[nodiscard]] WireProgram wire_program(Scene const& scene, StageObserver const& on_stage = {});

/// The same with an outline that was solved before, its slices from -T/2 to +T/2.
/// @throws InputError also where the slices are not those of the workpiece's faces
[[nodiscard]] WireProgram wire_program(Scene const& scene, CircularSplineOutline const& outline);

/// All set-ups of the part that [wedm] names: the circular spline has one.
///
/// A wire around the flexspline would cut what holds it, so that it is cut in two set-ups of half the teeth each (one more in the first where their number is
/// odd), between which the part is turned by half a turn on its mandrel. Both begin and end in the middle of a tip land, outside the blank; the path goes on for
/// `overlap` beyond that. Checks and errors as of wire_program, for each.
[[nodiscard]] WireSetUps wire_set_ups(Scene const& scene, StageObserver const& on_stage = {});

}  // namespace hdconj
