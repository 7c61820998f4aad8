// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Polygons of what teeth sweep around a tooth of the other member.
#pragma once

#include <utility>
#include <vector>

#include "hdconj/conjugate/arc_polygons.hpp"
#include "hdconj/conjugate/swept_polygons.hpp"

namespace hdconj::conjugate {

/// A moving tooth with the contact arcs of its envelope.
template <motion::RelativeMotion Motion>
struct SweptTooth
{
    envelope::Envelope<Motion> envelope;
    std::vector<envelope::ContactArc> arcs;
};

/// Polygons of all bounding arcs of @p teeth, chord error <= @p chord, as far as they hang below the height @p tip.
/// @param graded  with vertices crowded towards the arcs' ends
template <motion::RelativeMotion Motion>
[[nodiscard]] SweptPolygons body_polygons(std::vector<SweptTooth<Motion>> const& teeth, double tip, double chord,
                                          bool graded)
{
    SweptPolygons swept(0);
    double const ceiling = tip + 64 * chord;
    auto const low = [&](envelope::EnvelopePoint const& e) { return e.p.y() < ceiling; };
    for (std::size_t j = 0; j < teeth.size(); ++j) {
        envelope::Envelope<Motion> const& envelope = teeth[j].envelope;
        for (std::size_t i = 0; i < teeth[j].arcs.size(); ++i) {
            envelope::ContactArc const& arc = teeth[j].arcs[i];
            if (!arc.bounding)
                continue;
            envelope::SampledArc sampled =
                envelope::sample_arc(envelope, arc, arc.u_begin, arc.u_end, chord, 1, envelope::ChordTest::estimate);
            if (graded)
                crowd_ends(envelope, arc, sampled.points);
            auto const& along = sampled.points;
            std::vector<Vec2> points;
            std::vector<double> u;
            for (std::size_t k = 0; k <= along.size(); ++k) {
                bool const needed = k < along.size() && (low(along[k]) || (k > 0 && low(along[k - 1])) ||
                                                         (k + 1 < along.size() && low(along[k + 1])));
                if (needed) {
                    points.push_back(along[k].p);
                    u.push_back(along[k].u);
                    continue;
                }
                if (points.size() > 1)
                    swept.add_one(static_cast<int>(i), static_cast<int>(j), points, u);
                points.clear();
                u.clear();
            }
        }
    }
    return swept;
}

}  // namespace hdconj::conjugate
