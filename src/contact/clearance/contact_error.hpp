// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the slices of a surface leave open about its clearances over a full turn.
#pragma once

#include "slice_clearance.hpp"

namespace hdconj::contact {

/// Fewest planes that say something about what lies between them: gaps, and how far a ruled surface deviates; full
/// turns, which are smoother, are the least over all angles and take longer.
inline constexpr std::size_t fewest_planes = 9, fewest_turn_planes = 5;

/// A surface whose slices are the scene's, or more where those are too few to judge by.
struct TurnWork
{
    SliceClearances const& clearances;
    conjugate::MatchedOutline const& outline;
    FlankGrid const& grid;
    TurnMinima const* flank = nullptr;  ///< of its flanks with the scene's side clearance, where they are known
    TurnMinima const* root = nullptr;   ///< around the bottom
};

/// Estimated errors of clearances [mm].
struct ClearanceErrors
{
    double flank = 0;                   ///< of the smallest distance of the flanks, as that of the whole width
    double root = 0;                    ///< and around the bottom
    std::vector<double> flanks, roots;  ///< of each of the scene's slices, for itself
};

/// Error of the smallest distances of the scene's slices, @p slices, with the side clearance @p distance.
///
/// In each plane of @p work the smallest distance; between planes between_places(), around the bottom between its
/// points too. With the accuracy to which a place between two points is known.
[[nodiscard]] ClearanceErrors clearance_errors(ContactContext const& context, TurnWork const& work, double distance,
                                               std::vector<SliceClearance> const& slices);

/// Error of the least distance @p found by which the set must be moved to clear: what still enters between the planes,
/// by the slope with which moving clears it.
/// @param along  between points of the set too
[[nodiscard]] double clearing_error(ContactContext const& context, SliceClearances const& clearances,
                                    ClearanceSet const& set, double found, bool along);

}  // namespace hdconj::contact
