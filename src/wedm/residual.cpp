// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm/residual.hpp"

#include <algorithm>
#include <limits>

#include "segment_grid.hpp"

namespace hdconj {
namespace {

/// Steps are taken until they are shorter than this share of the tolerance.
constexpr double last_step = 1.0 / 16;

/// Where the normal touches the cut from the side, steps shrink slowly; what they have reached by then is a lower bound close to it.
constexpr int most_steps = 400;

/// Height along @p normal from @p p, already at the stock's surface, at which the wire's cut of radius @p reach begins.
/// @param across  way to the other side of the void, asked for only where there is a residual
template<class Across>
double height(detail::SegmentGrid const& wire, Vec2 const& p, Vec2 const& normal, double reach, double tolerance, Across&& across)
{
    double up = wire.distance(p) - reach;
    if (up <= tolerance)
        return 0;
    double const largest = across();
    for (int k = 0; k < most_steps && up < largest; ++k)
    {
        double const step = wire.distance(p + up * normal) - reach;
        if (step <= tolerance * last_step)
            break;
        up += step;
    }
    return std::min(up, largest);
}

/// Way from vertex @p i along @p normal to where it meets another edge of @p line; infinity where it meets none.
double way_across(std::vector<Vec2> const& line, std::size_t i, Vec2 const& normal)
{
    double way = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
    {
        if (k == i || k + 1 == i)
            continue;
        Vec2 const edge = line[k + 1] - line[k];
        Vec2 const to = line[k] - line[i];
        double const area = cross(normal, edge);
        double const along = cross(to, edge) / area;
        double const share = cross(to, normal) / area;
        bool const hit = area != 0 && along > 0 && share >= 0 && share <= 1;
        way = hit ? std::min(way, along) : way;
    }
    return way;
}

}  // namespace

std::vector<double> uncut_heights(std::vector<Vec2> const& nominal, std::vector<Vec2> const& wire, double offset, double stock, double tolerance)
{
    detail::SegmentGrid const grid(wire, false);
    std::vector<double> heights(nominal.size(), 0.0);
    for (std::size_t i = 1; i + 1 < nominal.size(); ++i)
    {
        for (std::size_t const edge : {i - 1, i})
        {
            Vec2 const normal = left_of((nominal[edge + 1] - nominal[edge]).normalized());
            auto const across = [&] { return way_across(nominal, i, normal); };
            heights[i] = std::max(heights[i], height(grid, nominal[i] + stock * normal, normal, offset - stock, tolerance, across));
        }
    }
    return heights;
}

}  // namespace hdconj
