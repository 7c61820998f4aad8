// SPDX-License-Identifier: GPL-3.0-or-later
// How far flanks are searched for contacts while the shape of a loaded drive is iterated.
#pragma once

#include "load_problem.hpp"

namespace hdconj::load {

/// The reach of a first search.
[[nodiscard]] SearchReach whole_reach(LoadProblem const& problem);

/// Sets the limit of the next search after a step has changed the shape @p before, at @p turn, into that of @p drive.
void follow_step(LoadProblem const& problem, LoadedShape before, double turn, LoadedDrive const& drive,
                 SearchReach& reach);

/// No gap closes by more than this between two shapes at their turns [mm]; infinite where flanks deviate from their
/// nominal form. Against the circular spline, a point of a tooth moves by at most the movement of the tooth's origin,
/// and the tooth's turn times its size.
[[nodiscard]] double largest_fall(LoadProblem const& problem, LoadedShape const& from, double turn_from,
                                  LoadedShape const& to, double turn_to);

/// Adds the contacts of the last step that were beyond its limit, without force, in order, and makes @p reach one from
/// which another torque can go on.
/// @param search  of that step, within search_limit()
void widen(LoadProblem const& problem, FlankSearch const& search, SearchReach& reach, LoadedDrive& drive);

}  // namespace hdconj::load
