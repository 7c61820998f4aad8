// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Distances from polygons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "number.hpp"

namespace oracle {

/// Distance of @p p from the line from @p a to @p b.
inline double distance_to_side(Point<double> const& p, Point<double> const& a, Point<double> const& b)
{
    Point<double> const d = b - a;
    double const whole = dot(d, d);
    double const along = whole > 0 ? std::clamp(dot(p - a, d) / whole, 0.0, 1.0) : 0;
    return length(p - (a + along * d));
}

/// Distance of @p p from a chain of sides.
inline double distance_to_chain(Point<double> const& p, std::vector<Point<double>> const& chain, bool closed)
{
    double best = 1e300;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < chain.size(); ++i)
        best = std::min(best, distance_to_side(p, chain[i], chain[(i + 1) % chain.size()]));
    return best;
}

}  // namespace oracle
