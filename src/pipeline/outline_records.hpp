// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Outlines as they are written into results.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hdconj/conjugate/outline.hpp"
#include "hdconj/numeric/tolerance.hpp"
#include "hdconj/pipeline/solution.hpp"

namespace hdconj::detail {

[[nodiscard]] inline std::string name_of(OutlineKind kind)
{
    switch (kind)
    {
    case OutlineKind::land: return "land";
    case OutlineKind::flank: return "flank";
    case OutlineKind::corner: return "corner";
    case OutlineKind::bottom: return "bottom";
    case OutlineKind::root_wall: return "root wall";
    case OutlineKind::root: return "root";
    }
    return {};
}

/// Stretches of an outline with the names of the profile segments that made them.
[[nodiscard]] inline std::vector<OutlinePiece> piece_records(Outline const& outline, Profile const& profile)
{
    std::vector<OutlinePiece> records;
    for (OutlineStretch const& s : outline.stretches)
        records.push_back({name_of(s.kind), s.segment < 0 ? "" : profile.segment_names[static_cast<std::size_t>(s.segment)], s.first, s.last});
    return records;
}

/// The half angle of the tip land and the depth of the space, of an outline whose right land begins at point @p right_land, with their errors:
/// the deepest point lies within the chord error beyond the deepest vertex, and the land's corner is as far off along the tip circle as
/// the flank is across it, over the sine of the angle at which they cross.
inline void measure_space(Outline const& outline, std::size_t right_land, double pitch, PairGeometry& geometry, ErrorEstimate& error)
{
    Vec2 const corner = outline.points[right_land];
    geometry.land_half_angle = pitch / 2 - std::atan2(corner.x(), corner.y());
    double deepest = 0;
    for (Vec2 const& p : outline.points)
        deepest = std::max(deepest, p.norm());
    geometry.space_depth = deepest - geometry.circular_spline_inner_radius;
    double const point = std::max(outline.error, 4 * unit_roundoff * deepest);
    error.space_depth = outline.chord + point;
    Vec2 const along = right_land > 0 ? Vec2(corner - outline.points[right_land - 1]) : corner;
    double const sine = std::abs(along.dot(corner)) / (along.norm() * corner.norm());
    error.land = 2 * std::min(point / sine, pitch * deepest);
}

}  // namespace hdconj::detail
