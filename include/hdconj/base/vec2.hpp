// SPDX-License-Identifier: GPL-3.0-or-later
// Plane vectors [mm] and the three products used everywhere.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace hdconj {

/// A point or vector in the plane, [mm] unless said otherwise.
using Vec2 = Eigen::Vector2d;

/// z component of a x b: positive when b is counter-clockwise of a.
inline double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Turned by +90 degrees (counter-clockwise).
inline Vec2 left_of(Vec2 const& a)
{
    return {-a.y(), a.x()};
}

/// Turned by -90 degrees (clockwise).
inline Vec2 right_of(Vec2 const& a)
{
    return {a.y(), -a.x()};
}

/// Unit vector at @p angle [rad], counter-clockwise from +x.
inline Vec2 direction(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace hdconj
