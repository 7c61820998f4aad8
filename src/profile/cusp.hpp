// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs in place of the last nanometre before a cusp, where involutes and cycloids have no radius of curvature.
#pragma once

#include <cmath>

#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj::profile {

/// Point of a flank and the angle of its outward normal [rad].
struct FlankPoint
{
    Vec2 point;
    double normal;
};

/// The arc that leaves @p from along its tangent and ends tangent to the straight line through @p on_line with normal
/// angle @p line_normal. Domain: the two normals differ, by less than half a turn. The sign of the radius follows from
/// the places: convex where the line is met ahead and the normal falls.
[[nodiscard]] inline ArcPiece arc_onto_line(FlankPoint const& from, Vec2 const& on_line, double line_normal)
{
    Vec2 const n = direction(from.normal);
    Vec2 const m = direction(line_normal);
    // tangent lines meet at from + t right_of(n); the tangent lengths of an arc are equal, t = r tan(turn/2)
    double const t = m.dot(on_line - from.point) / m.dot(right_of(n));
    double const radius = t / std::tan(0.5 * (from.normal - line_normal));
    return {from.point - radius * n, radius, from.normal, line_normal};
}

/// A convex and a concave arc of equal radius, tangent to each other, from @p a to @p b with their tangents.
/// With n(angle) the unit normal: r (2 n(mu) - n(a) - n(b)) = b - a, for the radius r and the normal mu where the arcs
/// meet. Domain: both normals tilted up from that of the chord, as on both sides of the cusp of a cycloid. radius 0:
/// there are no such arcs.
struct TwoArcs
{
    ArcPiece convex;
    ArcPiece concave;
};
[[nodiscard]] inline TwoArcs two_arcs(FlankPoint const& a, FlankPoint const& b)
{
    Vec2 const way = b.point - a.point;
    double const chord_normal = std::atan2(way.x(), -way.y());
    // n(mu) - n(a) = 2 sin((a - mu)/2) n'(...): differences of close normals without cancellation
    auto const bend = [&](double mu) {
        auto const step = [&](double from) {
            return Vec2(2 * std::sin(0.5 * (mu - from)) * left_of(direction(0.5 * (mu + from))));
        };
        return Vec2(step(a.normal) + step(b.normal));
    };
    auto const aside = [&](double mu) { return cross(way, bend(mu)); };
    double const smaller = std::min(a.normal, b.normal);
    double const lift = smaller - chord_normal;
    if (!(lift > 0))
        return {};
    numeric::BracketedRoot const mu = numeric::bracketed_root(aside, chord_normal - 3 * lift, smaller - 0x1p-8 * lift);
    if (!mu.found)
        return {};
    double const r = way.norm() / bend(mu.x).norm();
    return {{a.point - r * direction(a.normal), r, a.normal, mu.x},
            {b.point + r * direction(b.normal), -r, mu.x, b.normal}};
}

}  // namespace hdconj::profile
