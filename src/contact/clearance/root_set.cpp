// SPDX-License-Identifier: GPL-3.0-or-later
// The bottom of the space as a set of points.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "contact/parallel_trim.hpp"
#include "slice_clearance.hpp"

namespace hdconj::contact {
namespace {

/// The outline of a slice after its points between the land corners were moved by one distance into the material.
struct MovedSpace
{
    std::vector<Vec2> point;
    std::vector<Vec2> normal;  ///< of the curve that each point belongs to, into the material
    double distance;           ///< [mm]

    /// The place between point @p i and the next, at the share @p t of the way. A corner that moving has opened is
    /// bridged by an arc.
    [[nodiscard]] Vec2 between(std::size_t i, double t) const
    {
        if (distance == 0)
            return (1 - t) * point[i] + t * point[i + 1];
        auto const bare = [&](std::size_t j) -> Vec2 { return point[j] - distance * normal[j]; };
        Vec2 const way = ((1 - t) * normal[i] + t * normal[i + 1]).normalized();
        return (1 - t) * bare(i) + t * bare(i + 1) + distance * way;
    }
};

/// Slice @p k of @p outline, moved by @p distance [mm]. Where two moved branches cross, what lies behind the crossing
/// is cut off. Points outside the land corners stay.
MovedSpace moved_space(conjugate::MatchedOutline const& outline, std::size_t k, double distance)
{
    MovedSpace space{outline.points[k], outline.normals[k], distance};
    if (distance == 0)
        return space;
    auto const first = static_cast<std::ptrdiff_t>(outline.landmarks[0]),
               end = static_cast<std::ptrdiff_t>(outline.landmarks[4]) + 1;
    std::vector<Vec2> const bare(space.point.begin() + first, space.point.begin() + end);
    std::vector<Vec2> normal(space.normal.begin() + first, space.normal.begin() + end), moved = bare;
    for (std::size_t i = 0; i < bare.size(); ++i)
        moved[i] += distance * normal[i];
    trim_overlaps(bare, moved, normal);
    std::ranges::copy(moved, space.point.begin() + first);
    std::ranges::copy(normal, space.normal.begin() + first);
    return space;
}

/// First and last point of the bottom, without walls on the ends of the flanks.
std::pair<std::size_t, std::size_t> ends_of_bottom(conjugate::MatchedOutline const& outline)
{
    std::size_t first = outline.landmarks[1], last = outline.landmarks[3];
    for (conjugate::OutlineStretch const& stretch : outline.stretches)
        if (stretch.kind == conjugate::OutlineKind::root_wall) {
            if (stretch.first == outline.landmarks[1])
                first = stretch.last;
            if (stretch.last == outline.landmarks[3])
                last = stretch.first;
        }
    return {first, last};
}

}  // namespace

/// Flat stretches of an outline have no points between their ends, so the bottom is divided anew.
ClearanceSet root_set(conjugate::MatchedOutline const& outline, double given, Tolerance const& tolerance)
{
    constexpr std::size_t intervals = 96;
    auto const [first, last] = ends_of_bottom(outline);
    ClearanceSet set;
    set.known = 2 * tolerance.length;  // that of the outline, and that of the one that it was made to clear
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
        MovedSpace const space = moved_space(outline, k, given);
        std::vector<Vec2> const& points = space.point;
        std::vector<double> length{0};
        for (std::size_t i = first; i < last; ++i)
            length.push_back(length.back() + (points[i + 1] - points[i]).norm());
        set.point.emplace_back();
        std::size_t at = 0;
        for (std::size_t j = 0; j <= intervals; ++j) {
            double const wanted = length.back() * static_cast<double>(j) / intervals;
            while (at + 2 < length.size() && length[at + 1] < wanted)
                ++at;
            double const step = length[at + 1] - length[at];
            double t = step > 0 ? std::clamp((wanted - length[at]) / step, 0.0, 1.0) : 0.0;
            // a curve is what its points are, and a flat what is between them
            if (step < length.back() / intervals)
                t = t < 0.5 ? 0 : 1;
            set.point.back().push_back(space.between(first + at, t));
        }
        // the middle of the bottom is where the tip goes deepest
        set.point.back().push_back(points[outline.landmarks[2]]);
        set.way.emplace_back(set.point.back().size(), Vec2{0, 1});
    }
    return set;
}

}  // namespace hdconj::contact
