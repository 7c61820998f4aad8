// SPDX-License-Identifier: GPL-3.0-or-later
#include "ruled_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "hdconj/base/parallel.hpp"
#include "region/segment_tree.hpp"

namespace hdconj::contact {
namespace {

/// Largest distance between two neighbouring points a and b of a flank, a chord that follows it: golden section.
template <class Distance>
double largest_on_chord(Distance const& distance, Vec2 const& a, Vec2 const& b)
{
    constexpr double golden = 0.6180339887498949;
    constexpr int steps = 12;
    double low = 0, high = 1, largest = 0;
    for (int i = 0; i < steps; ++i) {
        double const left = high - golden * (high - low), right = low + golden * (high - low);
        double const at_left = distance(a + left * (b - a)), at_right = distance(a + right * (b - a));
        largest = std::max({largest, at_left, at_right});
        (at_left < at_right ? low : high) = at_left < at_right ? left : right;
    }
    return largest;
}

/// Largest distance of a line of points, and of what lies between those where it is largest and their neighbours.
template <class Distance>
double largest_along(Distance const& distance, std::vector<Vec2> const& line)
{
    std::vector<double> at;
    for (Vec2 const& p : line)
        at.push_back(distance(p));
    double largest = at.empty() ? 0 : std::ranges::max(at);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        // a peak stands out of its neighbours by no more than these differ from theirs
        double const before = i > 0 ? std::abs(at[i] - at[i - 1]) : 0,
                     after = i + 2 < line.size() ? std::abs(at[i + 2] - at[i + 1]) : 0;
        if (std::max(at[i], at[i + 1]) + std::max({before, after, std::abs(at[i + 1] - at[i])}) > largest)
            largest = std::max(largest, largest_on_chord(distance, line[i], line[i + 1]));
    }
    return largest;
}

/// The points of a flank of the outline in plane @p k outside the circle @p tip.
std::vector<Vec2> flank_of(conjugate::MatchedOutline const& outline, std::size_t flank, std::size_t k, double tip)
{
    std::size_t const first = outline.landmarks[flank == 0 ? 0 : 3], last = outline.landmarks[flank == 0 ? 1 : 4];
    std::vector<Vec2> points;
    std::copy_if(outline.points[k].begin() + static_cast<std::ptrdiff_t>(first),
                 outline.points[k].begin() + static_cast<std::ptrdiff_t>(last) + 1, std::back_inserter(points),
                 [tip](Vec2 const& p) { return p.norm() >= tip; });
    return points;
}

}  // namespace

std::vector<double> ruled_deviations(CaseSurface const& surface, PartFlanks const& flanks, double tip)
{
    conjugate::MatchedOutline const outlines = surface.conjugate_outlines(tip);
    FlankGrid const to_tip = moved_into_material(flanks.grid, 0);
    std::vector<double> worst(to_tip.slices(), 0);
    parallel_for(to_tip.slices(), surface.context().threads, 1, [&](std::size_t k) {
        region::SegmentTree const line(outlines.points[k]);
        std::size_t near = 0;
        auto const distance = [&](Vec2 const& p) {
            region::SegmentTree::Nearest const found = line.nearest(p, near);
            near = found.segment;
            return found.distance;
        };
        for (std::size_t flank = 0; flank < 2; ++flank) {
            std::vector<Vec2> const& corners = to_tip.point[flank][k];
            double const tip_here = corners.front().norm();
            worst[k] = std::max({worst[k], distance(corners.front()), distance(corners.back()),
                                 largest_along(distance, flank_of(flanks.outline, flank, k, tip_here))});
        }
    });
    return worst;
}

}  // namespace hdconj::contact
