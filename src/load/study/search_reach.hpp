// SPDX-License-Identifier: GPL-3.0-or-later
// How far flanks are searched for contacts while the shape of a loaded drive is iterated.
#pragma once

#include "load_problem.hpp"

namespace hdconj::load {

/// The first search of an iteration finds all contacts within search_limit(). Each later one looks only as far as the
/// step before it has closed a gap, since contacts farther away cost time and carry no force. Where a step closes a gap
/// that is wider, teeth overlap in the next shape, and every search finds contacts that overlap.
struct SearchReach
{
    double limit;            ///< of the next search [mm]
    GapBounds known = {};    ///< from the searches before
    LoadedShape shape = {};  ///< at which the last step found its contacts
    double turn = 0;         ///< at which it found them [rad]
    double solved_limit;     ///< within which it found them [mm]
};
[[nodiscard]] SearchReach whole_reach(LoadProblem const& problem);

/// Sets the limit of the next search after a step has changed the shape @p before, at @p turn, into that of @p drive.
void follow_step(LoadProblem const& problem, LoadedShape before, double turn, LoadedDrive const& drive,
                 SearchReach& reach);

/// No gap closes by more than this between two shapes at their turns [mm]; infinite where flanks deviate from their
/// nominal form. A point of a tooth moves by at most the movement of the tooth's origin, and the tooth's turn times its
/// size. A point of the circular spline moves by its radius times the turn of the circular spline.
[[nodiscard]] double largest_fall(LoadProblem const& problem, LoadedShape const& from, double turn_from,
                                  LoadedShape const& to, double turn_to);

/// Adds the contacts of the last step that were beyond its limit, without force, in order.
/// @param search  of that step, within search_limit()
void add_far_contacts(LoadProblem const& problem, FlankSearch const& search, SearchReach& reach, LoadedDrive& drive);

}  // namespace hdconj::load
