// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The point of an envelope arc that is nearest to a given one.
#pragma once

#include <algorithm>
#include <cmath>

#include "hdconj/conjugate/crossing.hpp"

namespace hdconj::conjugate {

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
