// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Straight stretches between two points.
#pragma once

#include <algorithm>
#include <optional>

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

}  // namespace hdconj
