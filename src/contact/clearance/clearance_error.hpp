// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated errors of the least side and root clearances that were found.
#pragma once

#include <cstddef>
#include <vector>

#include "contact/study/case_surface.hpp"
#include "part_flanks.hpp"
#include "slice_clearance.hpp"

namespace hdconj::contact {

/// Fewest planes that say something about what lies between them: gaps, and how far a ruled surface deviates; full
/// turns, which are smoother, are the least over all angles and take longer.
inline constexpr std::size_t fewest_planes = 9, fewest_turn_planes = 5;

/// What the points of @p set have over a full turn, moved by @p distance. @p known: that, or null
[[nodiscard]] TurnsOfSet turns_of(SliceClearances const& clearances, ClearanceSet const& set, double distance,
                                  TurnsOfSet const* known = nullptr);

/// The least of each plane. @p along: between the points too, which are even but for the last, the middle of the
/// bottom.
[[nodiscard]] std::vector<double> lowest_of(TurnsOfSet const& turns, bool along);

/// Error of the least distance @p found by which the set must be moved to clear: what still enters between the planes,
/// or is clear everywhere, by the slope with which moving clears it.
/// @param along  between points of the set too
/// @param turns  of the set at that distance
[[nodiscard]] double least_clearance_error(ContactContext const& context, SliceClearances const& clearances,
                                           ClearanceSet const& set, double found, bool along, TurnsOfSet const& turns);

/// Whether planes of @p surface between its slices are solved anew: then they have their own chords, were made to clear
/// a tooth by points, and have corners that move along the flank.
[[nodiscard]] bool has_planes_solved_anew(CaseSurface const& surface, Cleared const& cleared);

/// What planes that are solved anew add to an error [mm].
[[nodiscard]] double chords_of(CaseSurface const& surface, Cleared const& cleared);

/// Estimated error of the side clearance of @p cleared [mm].
/// @param surface, clearances, grid  its flanks in all slices of the scene or in more planes
/// @param known                      full turns of these at that side clearance; null: not known
[[nodiscard]] double found_clearance_error(CaseSurface const& surface, SliceClearances const& clearances,
                                           FlankGrid const& grid, Cleared const& cleared, TurnsOfSet const* known);

/// Whether the slices of @p surface say something about what lies between them.
[[nodiscard]] bool has_enough_planes(CaseSurface const& surface);

/// @p surface in enough planes.
[[nodiscard]] CaseSurface in_enough_planes(CaseSurface surface);

/// Estimated error of the side clearance of @p cleared, which was found [mm]: what still enters between the slices, by
/// the slope with which moving the flanks clears it. Where planes between the slices cannot be made, the slices alone
/// tell.
[[nodiscard]] double error_of_clearance(CaseSurface const& surface, SliceClearances const& clearances,
                                        Cleared const& cleared);

}  // namespace hdconj::contact
