// SPDX-License-Identifier: GPL-3.0-or-later
// From contact arcs to the polygons that are arranged.
#pragma once

#include <cmath>
#include <vector>

#include "hdconj/conjugate/swept_polygons.hpp"
#include "hdconj/envelope/sample.hpp"

namespace hdconj::conjugate {

/// What to write where curves of contact that bound the solved member do not meet: they hardly touch, or differ by less
/// than what the polygons resolve.
inline constexpr char const* remedy_of_open_boundary =
    "write a wave_generator.radial_deformation nearer to module (z_c - z_f) / 2, or a larger solver.tolerance";

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

/// Calls @p add(points, u) for each stretch of a polygon of @p arc that is @p wanted. The chord error is at most @p
/// chord. An arc that bounds nothing has no stretch.
/// @param graded  with vertices crowded towards the arc's ends
template <motion::RelativeMotion Motion, class Wanted, class Add>
void add_polygons(envelope::Envelope<Motion> const& envelope, envelope::ContactArc const& arc, double chord,
                  bool graded, Wanted const& wanted, Add const& add)
{
    if (!arc.bounding)
        return;
    auto along =
        envelope::sample_arc(envelope, arc, arc.u_begin, arc.u_end, chord, 1, envelope::ChordTest::estimate).points;
    if (graded)
        crowd_ends(envelope, arc, along);
    for_runs(
        along.size(), [&](std::size_t k) { return wanted(along[k].p); },
        [&](std::size_t first, std::size_t end) {
            std::vector<Vec2> points;
            std::vector<double> u;
            for (std::size_t k = first; k < end; ++k) {
                points.push_back(along[k].p);
                u.push_back(along[k].u);
            }
            add(points, u);
        });
}

/// Polygons of all bounding arcs as far as they rise above the tip circle; @p chord and @p graded as above.
template <motion::RelativeMotion Motion>
[[nodiscard]] SweptPolygons swept_polygons(envelope::Envelope<Motion> const& envelope,
                                           std::vector<envelope::ContactArc> const& arcs, double tip_radius,
                                           double pitch, double chord, bool graded)
{
    SweptPolygons swept(pitch);
    double const floor_margin = 64 * chord;
    for (std::size_t i = 0; i < arcs.size(); ++i)
        add_polygons(
            envelope, arcs[i], chord, graded, [&](Vec2 const& p) { return p.norm() > tip_radius - floor_margin; },
            [&](auto const& points, auto const& u) { swept.add(static_cast<int>(i), points, u); });
    return swept;
}

}  // namespace hdconj::conjugate
