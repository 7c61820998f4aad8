// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/base/stop.hpp"

namespace hdconj::wedm {

double seen_distance(region::SegmentTree const& line, Vec2 const& p, Lean const& lean)
{
    end_if_stopped();
    double const widest = lean.secant() * lean.secant();  // how much longer a square is than it is seen
    std::vector<Vec2> const& points = line.points();
    double best = std::numeric_limits<double>::infinity();
    line.approach(p, best, [&](std::size_t i) {
        Vec2 const &a = points[i], &b = points[i + 1];
        best = std::min(best, region::segment_foot(lean.seen(p - a), Vec2::Zero(), lean.seen(b - a)).squared);
        return best * widest;
    });
    return std::sqrt(best);
}

}  // namespace hdconj::wedm
