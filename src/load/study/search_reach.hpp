// SPDX-License-Identifier: GPL-3.0-or-later
// How far flanks are searched for contacts while the shape of a loaded drive is iterated.
#pragma once

#include "load_problem.hpp"

namespace hdconj::load {

/// At first as far as search_limit(), then only as far as the next step may close gaps: far contacts cost time and
/// carry nothing. A step that closes more than that is not lost: at the next shape these contacts overlap, and are
/// found within any limit.
struct SearchReach
{
    double limit;            ///< of the next search [mm]
    GapBounds known = {};    ///< by the searches before
    LoadedShape shape = {};  ///< of the last step, whose contacts were found within `solved_limit`
    double turn = 0;         ///< likewise [rad]
    double solved_limit;     ///< [mm]
};
[[nodiscard]] SearchReach whole_reach(LoadProblem const& problem);

/// After the step of @p drive from the shape @p before at @p turn, whose contacts were found last.
void follow_step(LoadProblem const& problem, LoadedShape before, double turn, LoadedDrive const& drive,
                 SearchReach& reach);

/// No gap closes by more than this between two shapes at their turns [mm]; infinite where flanks deviate. A point of a
/// tooth moves by no more than its origin and the turn about it, one of the circular spline by its radius times the
/// turn.
[[nodiscard]] double largest_fall(LoadProblem const& problem, LoadedShape const& from, double turn_from,
                                  LoadedShape const& to, double turn_to);

/// Adds the contacts of the last step that were beyond its limit, without force, in order.
/// @param search  of that step, within search_limit()
void add_far_contacts(LoadProblem const& problem, FlankSearch const& search, SearchReach& reach, LoadedDrive& drive);

}  // namespace hdconj::load
