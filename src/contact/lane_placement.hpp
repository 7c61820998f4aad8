// SPDX-License-Identifier: GPL-3.0-or-later
// Several points of a space against one of the teeth beside it.
#pragma once

#include "hdconj/distance/tooth_distance.hpp"
#include "hdconj/distance/tooth_lanes.hpp"

namespace hdconj::contact {

/// Points of a space, as many as there are lanes, and what is known of their distances.
struct LanePoints
{
    distance::Lanes x, y;  ///< in the frame of the space [mm]
    distance::Lanes best;  ///< smallest distance so far [mm]
};

/// The same points in the frame of a tooth.
struct PlacedLanes
{
    distance::Lanes x, y;   ///< [mm]
    distance::Lanes asked;  ///< 1: the tooth may be nearer than what is known, or 0
    bool any = false;       ///< whether it may be to any
};

/// x = R q - shift of all points, R of @p cosine and @p sine, with the bits of one point by itself.
/// @param more  how far a gap may be below the distance [mm]
void place(distance::ToothDistance const& tooth, double cosine, double sine, Vec2 const& shift,
           LanePoints const& points, double more, PlacedLanes& placed);

/// Takes @p distance of each point that was asked for as its best, where it is smaller. Then `asked` is 1 for the
/// points that changed.
void keep_nearer(distance::Lanes const& distance, LanePoints& points, PlacedLanes& placed);

}  // namespace hdconj::contact
