// SPDX-License-Identifier: GPL-3.0-or-later
#include "moved_outline.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "cone.hpp"
#include "conjugate/plane/root_clearance.hpp"
#include "hdconj/error.hpp"

namespace hdconj::surface {

void move_radially(conjugate::MatchedOutline& outline, std::vector<double> const& z, double tilt)
{
    double const chord = outline.chord;
    for (std::size_t k = 0; k < z.size(); ++k) {
        double const distance = z[k] * std::tan(tilt);
        if (distance != 0)
            outline.chord =
                std::max(outline.chord, conjugate::chord_moved_radially(outline.points[k], chord, distance));
        for (std::size_t i = 0; i < outline.normals[k].size(); ++i)
            outline.normals[k][i] = normal_moved_radially(outline.points[k][i], outline.normals[k][i], distance);
        for (Vec2& p : outline.points[k])
            p = moved_radially(p, distance);
    }
}

void deepen_all(conjugate::MatchedOutline& outline, double clearance)
{
    if (!(clearance > 0))
        return;
    std::size_t const middle = outline.landmarks[2];
    std::vector<conjugate::OutlineStretch> stretches;
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
        conjugate::Outline slice;
        slice.points = outline.points[k];
        slice.stretches = outline.stretches;
        conjugate::deepen(slice, middle, clearance);
        if (k == 0)
            stretches = slice.stretches;
        bool const same = std::equal(stretches.begin(), stretches.end(), slice.stretches.begin(), slice.stretches.end(),
                                     [](conjugate::OutlineStretch const& a, conjugate::OutlineStretch const& b) {
                                         return a.first == b.first && a.last == b.last;
                                     });
        if (!same)
            throw NumericalError(ErrorCode::no_outline, "root clearance", "slices",
                                 "the bottom of the tooth space is widest at different places of different slices; "
                                 "write root_clearance = 0");
        // the walls' ends have the normals of the points they were made from
        auto& normals = outline.normals[k];
        std::size_t const left = std::find_if(stretches.begin(), stretches.end(), [](auto const& s) {
                                     return s.kind == conjugate::OutlineKind::root_wall;
                                 })->first;
        std::size_t const right = std::find_if(stretches.rbegin(), stretches.rend(), [](auto const& s) {
                                      return s.kind == conjugate::OutlineKind::root_wall;
                                  })->last;
        normals.insert(normals.begin() + static_cast<std::ptrdiff_t>(right - 2), normals[right - 2]);
        normals.insert(normals.begin() + static_cast<std::ptrdiff_t>(left), normals[left]);
        outline.points[k] = std::move(slice.points);
    }
    outline.stretches = std::move(stretches);
    for (std::size_t i = 2; i < 5; ++i)
        outline.landmarks[i] += i == 2 ? 1 : 2;
}

double meeting_radius(conjugate::MatchedOutline const& outline, std::size_t k, double distance, double pitch)
{
    auto const angle_left = [&](std::size_t i) {
        Vec2 const p = outline.points[k][i] + distance * outline.normals[k][i];
        return 0.5 * pitch - std::abs(std::atan2(p.x(), p.y()));
    };
    auto const radius = [&](std::size_t i) { return (outline.points[k][i] + distance * outline.normals[k][i]).norm(); };
    double meeting = 0;
    // from the land corners down both flanks
    for (auto const& [from, to, step] : {std::tuple(outline.landmarks[4], outline.landmarks[3], -1),
                                         std::tuple(outline.landmarks[0], outline.landmarks[1], 1)}) {
        for (std::size_t i = from; i != to; i += static_cast<std::size_t>(step)) {
            double const here = angle_left(i);
            if (here > 0)
                continue;
            std::size_t const next = i + static_cast<std::size_t>(step);
            double const there = angle_left(next);
            double const share = there > 0 ? here / (here - there) : 1;
            meeting = std::max(meeting, (1 - share) * radius(i) + share * radius(next));
        }
    }
    return meeting;
}

}  // namespace hdconj::surface
