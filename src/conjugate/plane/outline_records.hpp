// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines as they are written into results.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "conjugate/outline.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// Stretches of an outline with the names of the profile segments that made them.
[[nodiscard]] inline std::vector<OutlinePiece> piece_records(Outline const& outline, profile::Profile const& profile)
{
    constexpr std::array<char const*, 6> kinds{"land", "flank", "corner", "bottom", "root wall", "root"};
    std::vector<OutlinePiece> records;
    for (OutlineStretch const& s : outline.stretches)
        records.push_back({kinds[static_cast<std::size_t>(s.kind)],
                           s.segment < 0 ? "" : profile.segment_names[static_cast<std::size_t>(s.segment)], s.first,
                           s.last});
    return records;
}

/// Half the tip land between two neighbouring spaces whose lands begin at @p left and @p right of the middle of one:
/// the mean of the two halves, which differ where the drive is not its own mirror image. @param pitch  [rad]
[[nodiscard]] inline double land_half_angle(Vec2 const& left, Vec2 const& right, double pitch)
{
    return ((pitch / 2 + std::atan2(left.x(), left.y())) + (pitch / 2 - std::atan2(right.x(), right.y()))) / 2;
}

/// The half angle of the tip land and the depth of the space, of an outline whose lands begin at points @p left_land
/// and @p right_land, with their errors: the deepest point lies within the chord error beyond the deepest vertex, and
/// each of the land's corners is as far off along the tip circle as the flank is across it, over the sine of the angle
/// at which they cross.
inline void measure_space(Outline const& outline, std::size_t left_land, std::size_t right_land, double pitch,
                          PairGeometry& geometry, ErrorEstimate& error)
{
    std::vector<Vec2> const& points = outline.points;
    geometry.land_half_angle = land_half_angle(points[left_land], points[right_land], pitch);
    double deepest = 0;
    for (Vec2 const& p : points)
        deepest = std::max(deepest, p.norm());
    geometry.space_depth = deepest - geometry.circular_spline_inner_radius;
    double const point = std::max(outline.error, 4 * unit_roundoff * deepest);
    error.space_depth = outline.chord + point;
    auto const off = [&](Vec2 const& corner, Vec2 const& along) {
        double const sine = std::abs(along.dot(corner)) / (along.norm() * corner.norm());
        return std::min(point / sine, pitch * deepest);
    };
    Vec2 const left = points[left_land], right = points[right_land];
    error.land = off(left, left_land + 1 < points.size() ? Vec2(points[left_land + 1] - left) : left) +
                 off(right, right_land > 0 ? Vec2(right - points[right_land - 1]) : right);
}

}  // namespace hdconj::conjugate
