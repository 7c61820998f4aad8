// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Distance of points from a polyline that runs in order of increasing x, by looking near and then as far as it can
/// matter.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::test {

inline double distance_to_segment(Vec2 const& a, Vec2 const& b, Vec2 const& p)
{
    Vec2 const along = b - a;
    double const length2 = along.squaredNorm();
    double const t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p - a - t * along).norm();
}

/// @param line  x must not decrease
inline double distance_to_polyline(std::vector<Vec2> const& line, Vec2 const& p)
{
    double best = std::numeric_limits<double>::infinity();
    auto const after =
        std::lower_bound(line.begin(), line.end(), p.x(), [](Vec2 const& q, double x) { return q.x() < x; });
    auto const start =
        std::clamp<std::ptrdiff_t>(after - line.begin(), 1, static_cast<std::ptrdiff_t>(line.size()) - 1);
    auto const at = [&](std::ptrdiff_t i) { return line[static_cast<std::size_t>(i)]; };
    for (std::ptrdiff_t i = start; i < static_cast<std::ptrdiff_t>(line.size()) && at(i - 1).x() - p.x() < best; ++i)
        best = std::min(best, distance_to_segment(at(i - 1), at(i), p));
    for (std::ptrdiff_t i = start - 1; i > 0 && p.x() - at(i).x() < best; --i)
        best = std::min(best, distance_to_segment(at(i - 1), at(i), p));
    return best;
}

}  // namespace hdconj::test
