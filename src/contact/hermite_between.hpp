// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A smooth curve between two of its points.
#pragma once

#include <cmath>

#include "hdconj/base/vec2.hpp"

namespace hdconj::contact {

/// The cubic from @p a to @p b with the tangents that the normals @p at_a and @p at_b tell (Hermite), at @p t of the
/// chord, 0 ... 1.
///
/// A smooth curve has about opposite slopes against its chord at both ends. Beside a corner, where only one branch's
/// tangent is known, one of them is several times the other: then the smaller one stands for both.
[[nodiscard]] inline Vec2 hermite_between(Vec2 const& a, Vec2 const& at_a, Vec2 const& b, Vec2 const& at_b, double t)
{
    Vec2 const chord = b - a;
    auto const slope_at = [&](Vec2 const& n) { return n.dot(chord) / cross(n, chord); };
    double begin = slope_at(at_a);
    double end = slope_at(at_b);
    constexpr double corner = 4;
    if (!(std::abs(begin) <= corner * std::abs(end)))
        begin = -end;
    else if (!(std::abs(end) <= corner * std::abs(begin)))
        end = -begin;
    double const bulge = t * (1 - t) * ((1 - t) * begin - t * end);
    return a + t * chord + (std::isfinite(bulge) ? bulge : 0) * left_of(chord);
}

}  // namespace hdconj::contact
