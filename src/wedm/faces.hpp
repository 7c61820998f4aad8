// SPDX-License-Identifier: GPL-3.0-or-later
// The part that the wire is to make: one pitch of both faces, and turned copies of it all around.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/solution.hpp"
#include "paired_path.hpp"

namespace hdconj::wedm {

/// A true section of the part between the faces.
struct SectionBetween
{
    double share = 0;          ///< height above the lower face over T, 0 ... 1
    std::vector<Vec2> points;  ///< (n) point for point with the faces [mm]
};

/// One pitch of a toothed part, in points far closer than the wire needs.
/// Tooth space 0 lies on the y axis; the others follow clockwise.
struct WireFaces
{
    int teeth = 0;          ///< tooth spaces around
    bool external = false;  ///< teeth outside, void around them
    PairedPath pitch;       ///< from mid-land to mid-land across space 0, void on the left: internal counter-clockwise,
                            ///< external clockwise
    std::vector<std::size_t> marks;       ///< land corners, flank ends, middle of the space: indices, increasing
    std::vector<char> meshing;            ///< (n) 1: on a flank
    std::vector<char> wall;               ///< (n) 1: between land and root, made by a flank or a corner of the other
                                          ///< tooth; empty where both faces are the same
    std::vector<SectionBetween> between;  ///< of the true surface
    bool knows_sections = true;           ///< false: no slice between two that differ, and no straight lines join them

    /// Number of the @p k th space that a wire meets which starts at space @p start and has the void on its left.
    [[nodiscard]] int space_in_order(int start, int k) const { return ((start + next() * k) % teeth + teeth) % teeth; }
    /// Spaces from one pitch to the next one in that direction.
    [[nodiscard]] int next() const { return external ? 1 : -1; }
};

/// Marks the points @p first to @p last of @p faces as a flank.
inline void mark_flank(WireFaces& faces, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i <= last; ++i)
        faces.meshing[i] = 1;
}

/// @p points of space 0 turned to space @p space; for space 0 the same bits.
[[nodiscard]] std::vector<Vec2> turned_to(std::vector<Vec2> const& points, int space, int teeth);
[[nodiscard]] Vec2 turned_to(Vec2 const& point, int space, int teeth);

/// @p points of one pitch of @p faces with @p more points of each neighbour: a line whose neighbourhood is whole.
[[nodiscard]] std::vector<Vec2> with_neighbours(std::vector<Vec2> const& points, WireFaces const& faces,
                                                std::size_t more);

/// One pitch of both faces of a workpiece from the slices of @p outline, the first and last at the ends of the
/// toothing. Only one slice: both faces are that. Beyond the toothing the faces go on along the straight rulings that
/// join its ends, and the ends are sections between the faces.
/// @param thickness  of the workpiece, its middle at z = 0; at least that of the toothing [mm]
/// @param straight   straight lines join the slices point for point, so that two alone have a section between them
[[nodiscard]] WireFaces wire_faces(CircularSplineOutline const& outline, int teeth, double thickness,
                                   bool straight = false);

/// One pitch of the flexspline as it is made, round and without load: its tooth at the radius r_m of the neutral
/// circle, and between two teeth the root, an arc about the axis through the lowest points of both (where they are at
/// different radii, evenly from one to the other). Both faces are the same.
/// @param solved  where the circular spline's tooth is given: the solution, which has the flexspline's tooth; else null
/// @throws InputError where the tooth has an edge in place of a tip, or a land narrower than wedm.tolerance;
/// NumericalError where no root is left
[[nodiscard]] WireFaces flexspline_faces(Scene const& scene, Solution const* solved = nullptr);

}  // namespace hdconj::wedm
