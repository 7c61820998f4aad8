// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part that the wire is to make: one pitch of both faces, and turned copies of it all around.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/wedm/paired_path.hpp"

namespace hdconj {

/// A true section of the part between the faces.
struct SectionBetween
{
    double share = 0;            ///< height z/T above the lower face, 0 ... 1
    std::vector<Vec2> points;    ///< (n) point for point with the faces [mm]
};

/// One pitch of a ring with internal teeth, in points far closer than the wire needs.
/// Tooth space 0 lies on the y axis; the others follow clockwise.
struct WireFaces
{
    int teeth = 0;                        ///< tooth spaces of the ring
    PairedPath pitch;                     ///< from mid-land to mid-land across space 0, counter-clockwise: void on the left
    std::vector<std::size_t> marks;       ///< land corners, flank ends, middle of the space: indices, increasing
    std::vector<char> meshing;            ///< (n) 1: on a flank
    std::vector<SectionBetween> between;  ///< of the true surface

    [[nodiscard]] double pitch_angle() const;
};

/// @p points of space 0 turned to space @p space; for space 0 the same bits.
[[nodiscard]] std::vector<Vec2> turned_to(std::vector<Vec2> const& points, int space, int teeth);
[[nodiscard]] Vec2 turned_to(Vec2 const& point, int space, int teeth);

/// @p points of one pitch with @p more points of each neighbour: a line whose neighbourhood is whole.
[[nodiscard]] std::vector<Vec2> with_neighbours(std::vector<Vec2> const& points, int teeth, std::size_t more);

/// Spaces in the order in which a wire meets them that starts clockwise of @p start and goes counter-clockwise.
[[nodiscard]] inline int space_in_order(int start, int k, int teeth)
{
    return ((start - k) % teeth + teeth) % teeth;
}

}  // namespace hdconj
