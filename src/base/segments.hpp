// SPDX-License-Identifier: GPL-3.0-or-later
// Straight stretches between two points.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj {

/// Where the segments a ... b and c ... d cross, their ends included. Nothing where they do not, or are parallel: then
/// any point of an overlap would do. Accuracy: the coordinates' roundoff over the sine of the angle between them.
[[nodiscard]] inline std::optional<Vec2> crossing_of_segments(Vec2 const& a, Vec2 const& b, Vec2 const& c,
                                                              Vec2 const& d)
{
    Vec2 const u = b - a, v = d - c;
    double const area = cross(u, v);
    if (area == 0)
        return std::nullopt;
    double const s = cross(c - a, v) / area, t = cross(c - a, u) / area;
    if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1))
        return std::nullopt;
    return Vec2(a + s * u);
}

/// Squared distance of @p point from the segment a b.
[[nodiscard]] inline double squared_distance(Vec2 const& point, Vec2 const& a, Vec2 const& b)
{
    Vec2 const along = b - a;
    double const length = along.squaredNorm();
    double const at = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - a - at * along).squaredNorm();
}

/// Adds to @p kept, in their order, the indices between @p first and @p last that the @p lines, of equal numbers of
/// points, need there: without them a point of some line would be further than @p tolerance from its chord.
inline void keep_between(std::span<std::vector<Vec2> const> lines, std::size_t first, std::size_t last,
                         double tolerance, std::vector<std::size_t>& kept)
{
    std::size_t furthest = first;
    double distance = tolerance * tolerance;
    for (auto const& line : lines)
        for (std::size_t i = first + 1; i < last; ++i)
            if (double const here = squared_distance(line[i], line[first], line[last]); here > distance) {
                distance = here;
                furthest = i;
            }
    if (furthest == first)
        return;
    keep_between(lines, first, furthest, tolerance, kept);
    kept.push_back(furthest);
    keep_between(lines, furthest, last, tolerance, kept);
}

}  // namespace hdconj
