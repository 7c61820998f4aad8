// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of contact arcs that bound a tooth space, in order.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::conjugate {

/// A stretch of the boundary of one pitch: on a contact arc, or on the tip circle.
struct BoundaryPiece
{
    int arc = -1;      ///< index into the arcs given; -1: land on the tip circle
    int copy = 0;      ///< the tooth this many pitches clockwise of the one at the y axis
    double begin = 0;  ///< u where the boundary (left to right) enters; on a land the angle from the y axis
    double end = 0;
};

/// What the boundary is made of, left mid-land to right mid-land.
struct ToothSpace
{
    std::vector<BoundaryPiece> pieces;
    std::size_t segments = 0;  ///< given to the arrangement, all attempts
    double gap = 0;            ///< largest distance between arcs that were taken for one [mm]
};

/// Whether two runs share an end point that both their polygons have; positions count vertices.
[[nodiscard]] inline bool shared_end(std::vector<Vec2> const& before, double end, std::vector<Vec2> const& after,
                                     double begin)
{
    auto const is_end = [](std::vector<Vec2> const& polygon, double position) {
        return position == 0 || position == static_cast<double>(polygon.size() - 1);
    };
    auto const vertex = [](std::vector<Vec2> const& polygon, double position) {
        return polygon[static_cast<std::size_t>(position)];
    };
    return is_end(before, end) && is_end(after, begin) && vertex(before, end) == vertex(after, begin);
}

}  // namespace hdconj::conjugate
