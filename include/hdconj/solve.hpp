// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The main job: from a scene to the conjugate circular spline.
#pragma once

#include <string>

#include "hdconj/error.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// Solves for the member that is conjugate to the given tooth.
///
/// The tooth touches its envelope where n . v = 0, with its normal n and the relative velocity v
/// (docs/explanation/theory.md; Litvin & Fuentes, Gear Geometry and Applied Theory, 2004, ch. 6). All branches of this
/// condition are found; Solution::certificate says whether that is proved. Their outer boundary is the tooth space of
/// the circular spline; in the reverse problem, with the circular spline's tooth given, it is the flexspline tooth.
///
/// Runs the stages of make_plan(scene), and no other. The result has the same bits for any number of threads.
/// Accuracy: no point of an outline is farther than `solver.tolerance` from the true curve, see Solution::error.
/// @param scene     lengths in mm, angles in rad; domain: scenes for which check_scene() finds no fault
/// @param on_stage  called with each stage that begins; null: not called
/// @throws InputError     the scene cannot describe a drive (exit status 2)
/// @throws NumericalError a stage failed; says which, where and why (exit status 1)
[[nodiscard]] Solution solve(Scene const& scene, StageObserver const& on_stage = {});

/// Tries the advice of the notes on flank-contact and undercut, which solve() gives in words alone: the drive is solved
/// with other radial deformations, pressure angles and addenda, as coarsely as notes allow. Advice that makes a drive
/// whose figure is at least a tenth nearer to its usual range, and that brings no new warning, becomes the note's; it
/// contains what the notes before it advise, so that all can be followed together. Where the values of another note
/// make no drive, they are completed by what the refusal writes.
/// @param solution  as solve() returns it
void try_advice(Solution& solution);

/// The plan of a verb by its name.
/// @param scene  domain: scenes for which check_scene() finds no fault
/// @param verb   "solve", "contact", "load" or "run"
/// @param place  option or parameter that names the verb, for messages
/// @throws InputError for another word; for a scene whose neutral curve is wanted, which solve alone takes
[[nodiscard]] Plan plan_of(Scene const& scene, std::string const& verb, std::string const& place);

}  // namespace hdconj
