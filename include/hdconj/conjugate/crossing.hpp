// SPDX-License-Identifier: GPL-3.0-or-later
// Where two envelope arcs cross, and where one crosses a circle: solved on the arcs, not on their polygons.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/envelope/envelope.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::conjugate {

/// A place as messages name it.
[[nodiscard]] inline std::string near_text(Vec2 const& p)
{
    return "near (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ") mm";
}

/// An envelope arc of the tooth some pitches away.
template <motion::RelativeMotion Motion>
struct TurnedArc
{
    envelope::Envelope<Motion> const& envelope;
    envelope::ContactArc const& arc;
    double angle;  ///< clockwise [rad]

    [[nodiscard]] envelope::EnvelopePoint point(double u) const
    {
        envelope::EnvelopePoint e = envelope.point(arc, u);
        if (angle != 0) {
            e.p = turned_clockwise(e.p, angle);
            e.n = turned_clockwise(e.n, angle);
        }
        return e;
    }

    /// dp/du.
    [[nodiscard]] Vec2 velocity(double u) const
    {
        envelope::Contact const c = envelope.contact(arc, u);
        Vec2 const along = envelope.motion().pose(u).rotate(right_of(c.n)) * (c.advance / c.slowness);
        return angle != 0 ? turned_clockwise(along, angle) : along;
    }
};

/// Parameters at which arcs @p a and @p b cross, from guesses that are within about @p chord of the crossing.
///
/// Newton on a(u_a) - b(u_b). Nothing when it leaves the arcs, wanders off or the arcs are parallel there.
/// Accuracy: the two points agree to the roundoff of the coordinates; the corner itself to that divided by the sine of
/// the angle.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::optional<std::array<double, 2>> crossing_of_arcs(TurnedArc<Motion> const& a, double u_a,
                                                                    TurnedArc<Motion> const& b, double u_b,
                                                                    double chord, Tolerance const& tolerance)
{
    Vec2 const start = a.point(u_a).p;
    constexpr int budget = 40;
    double last = tolerance.scale;
    for (int k = 0; k < budget; ++k) {
        Vec2 const pa = a.point(u_a).p;
        Vec2 const gap = pa - b.point(u_b).p;
        double const size = gap.norm();
        // where the contact runs fast along its profile, its rounding is a multiple of that of the coordinates: the end
        // is reached when a step no longer halves a gap that is no gap any more
        if (size <= tolerance.roundoff() / 8 || (size <= tolerance.coincidence() && size >= last / 2)) {
            // two polygons within `chord` of their arcs cross no farther from the arcs' crossing than this
            constexpr double shallow = 4096;
            if ((pa - start).norm() > shallow * chord)
                return std::nullopt;
            return std::array<double, 2>{u_a, u_b};
        }
        last = size;
        Eigen::Matrix2d slope;
        slope.col(0) = a.velocity(u_a);
        slope.col(1) = -b.velocity(u_b);
        Eigen::FullPivLU<Eigen::Matrix2d> const lu(slope);
        if (!slope.allFinite() || lu.rank() < 2)
            return std::nullopt;
        Vec2 const step = lu.solve(gap);
        u_a = std::clamp(u_a - step.x(), a.arc.u_begin, a.arc.u_end);
        u_b = std::clamp(u_b - step.y(), b.arc.u_begin, b.arc.u_end);
    }
    return std::nullopt;
}

/// Parameter at which @p height_of the arc's point is zero, nearest to the guess @p u.
///
/// Brackets outward from the guess in doubling steps, at last as far as both ends of the arc, then bisects and
/// interpolates: never a lost sign.
/// @param height_of  a smooth function of a point, its slope about 1
template <motion::RelativeMotion Motion, class Height>
[[nodiscard]] std::optional<double> crossing_at_height(TurnedArc<Motion> const& a, Height const& height_of, double u,
                                                       double chord)
{
    auto const height = [&](double at) { return height_of(a.point(at).p); };
    double const h = height(u);
    if (h == 0)
        return u;
    double const speed = a.velocity(u).norm();
    double const first = chord / (std::isfinite(speed) && speed > 0 ? speed : 1), all = a.arc.u_end - a.arc.u_begin;
    for (double step = std::min(first, all);; step = std::min(2 * step, all)) {
        for (double side : {-1.0, 1.0}) {
            double const other = std::clamp(u + side * step, a.arc.u_begin, a.arc.u_end);
            double const h_other = height(other);
            if (std::signbit(h_other) == std::signbit(h) && h_other != 0)
                continue;
            numeric::BracketedRoot const root = numeric::bracketed_root(height, std::min(u, other), std::max(u, other));
            if (root.found)
                return root.x;
        }
        if (step >= all)
            return std::nullopt;
    }
}

/// Parameter at which the arc crosses the circle of @p radius about the origin, nearest to the guess @p u.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::optional<double> crossing_with_circle(TurnedArc<Motion> const& a, double radius, double u,
                                                         double chord)
{
    return crossing_at_height(
        a, [radius](Vec2 const& p) { return p.norm() - radius; }, u, chord);
}

/// A point of an arc and its distance from the point it was sought for [mm].
struct NearestOnArc
{
    double u;
    double gap;
};

/// Nearest point of @p arc to @p p, from the guess @p u: some steps of Newton's method along the arc, kept inside it.
template <motion::RelativeMotion Motion>
[[nodiscard]] NearestOnArc nearest_on(TurnedArc<Motion> const& arc, Vec2 const& p, double u)
{
    constexpr int steps = 4;
    for (int i = 0; i < steps; ++i) {
        Vec2 const v = arc.velocity(u);
        double const step = (p - arc.point(u).p).dot(v) / v.squaredNorm();
        if (!std::isfinite(step))
            break;
        u = std::clamp(u + step, arc.arc.u_begin, arc.arc.u_end);
    }
    return {u, (arc.point(u).p - p).norm()};
}

}  // namespace hdconj::conjugate
