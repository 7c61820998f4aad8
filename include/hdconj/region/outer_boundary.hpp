// SPDX-License-Identifier: GPL-3.0-or-later
// The outer side of a heap of curves, as a planar arrangement sees it.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::region {

/// A stretch of one curve on the boundary. Positions count vertices of the curve's polygon, with a fraction
/// inside a segment; begin > end where the boundary runs against the curve.
struct BoundaryRun
{
    int curve = 0;
    double begin = 0;
    double end = 0;
};

/// The boundary from the first to the last point of the floor, and how many segments were arranged.
struct OuterBoundary
{
    std::vector<BoundaryRun> runs;
    std::size_t segments = 0;
    /// Places where segments stick out into the open side and bound nothing. The curves of a swept region have none on
    /// its outer side, so there they tell of polygons too coarse to cross where their curves do.
    std::vector<Vec2> loose;
};

/// Walks from the first to the last point of curve @p floor along the boundary of everything that can be reached from
/// far away on the floor's left side.
///
/// Topology is exact (CGAL arrangement with exact constructions). Pieces that reach into the open side without bounding
/// anything are left out. Positions are rounded to double.
/// @param curves  polygons, each of 2 points or more; points that are meant to coincide must be bit-identical
/// @param floor   index of a polygon that runs below all others and past them at both ends
/// @param same    what sticks out no farther than this is no loose place: curves that run into one point share the
///                roundings of their last vertices [mm]
/// @throws NumericalError when the floor is not reached again
[[nodiscard]] OuterBoundary outer_boundary(std::vector<std::vector<Vec2>> const& curves, int floor, double same = 0);

}  // namespace hdconj::region
