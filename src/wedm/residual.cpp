// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm/residual.hpp"

#include <algorithm>
#include <limits>

#include "segment_grid.hpp"

namespace hdconj {

std::vector<double> uncut_heights(std::vector<Vec2> const& nominal, std::vector<Vec2> const& wire, double offset, double tolerance)
{
    detail::SegmentGrid const grid(wire, false);
    std::vector<double> heights(nominal.size(), 0.0);
    for (std::size_t i = 1; i + 1 < nominal.size(); ++i)
    {
        double const height = grid.distance(nominal[i]) - offset;
        heights[i] = height > tolerance ? height : 0;
    }
    return heights;
}

double way_to_residual(std::vector<Vec2> const& nominal, std::vector<double> const& heights, std::vector<Vec2> const& reached)
{
    detail::SegmentGrid const grid(reached, false);
    double way = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < nominal.size(); ++i)
        if (heights[i] > 0)
            way = std::min(way, grid.distance(nominal[i]) - heights[i]);
    return way;
}

}  // namespace hdconj
