// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From contact arcs to the polygons that are arranged.
#pragma once

#include <cmath>
#include <vector>

#include "hdconj/conjugate/swept_polygons.hpp"
#include "hdconj/envelope/sample.hpp"

namespace hdconj::conjugate {

/// Vertices that crowd towards both ends of an arc: next to a cusp two arcs may cross at any distance, however small.
template <motion::RelativeMotion Motion>
void crowd_ends(envelope::Envelope<Motion> const& envelope, envelope::ContactArc const& arc,
                std::vector<envelope::EnvelopePoint>& points)
{
    constexpr int halvings = 14;
    double const first = points.front().u;
    double const second = points[1].u;
    double const last = points.back().u;
    double const before_last = points[points.size() - 2].u;
    std::vector<envelope::EnvelopePoint> begin, end;
    for (int k = halvings; k >= 1; --k)
        begin.push_back(envelope.point(arc, first + std::ldexp(second - first, -k)));
    for (int k = 1; k <= halvings; ++k)
        end.push_back(envelope.point(arc, last + std::ldexp(before_last - last, -k)));
    if (points.size() == 2)
        begin.pop_back();  // both sides would halve the one chord
    points.insert(points.begin() + 1, begin.begin(), begin.end());
    points.insert(points.end() - 1, end.begin(), end.end());
}

/// Polygons of all bounding arcs, chord error <= @p chord, as far as they rise above the tip circle.
/// @param graded  with vertices crowded towards the arcs' ends
template <motion::RelativeMotion Motion>
[[nodiscard]] SweptPolygons swept_polygons(envelope::Envelope<Motion> const& envelope,
                                           std::vector<envelope::ContactArc> const& arcs, double tip_radius,
                                           double pitch, double chord, bool graded)
{
    SweptPolygons swept(pitch);
    double const floor_margin = 64 * chord;
    auto const high = [&](envelope::EnvelopePoint const& e) { return e.p.norm() > tip_radius - floor_margin; };
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (!arcs[i].bounding)
            continue;
        envelope::SampledArc sampled = envelope::sample_arc(envelope, arcs[i], arcs[i].u_begin, arcs[i].u_end, chord, 1,
                                                            envelope::ChordTest::estimate);
        if (graded)
            crowd_ends(envelope, arcs[i], sampled.points);
        auto const& along = sampled.points;
        std::vector<Vec2> points;
        std::vector<double> u;
        auto const flush = [&] {
            if (points.size() > 1)
                swept.add(static_cast<int>(i), points, u);
            points.clear();
            u.clear();
        };
        for (std::size_t k = 0; k < along.size(); ++k) {
            bool const needed =
                high(along[k]) || (k > 0 && high(along[k - 1])) || (k + 1 < along.size() && high(along[k + 1]));
            if (!needed) {
                flush();
                continue;
            }
            points.push_back(along[k].p);
            u.push_back(along[k].u);
        }
        flush();
    }
    return swept;
}

}  // namespace hdconj::conjugate
