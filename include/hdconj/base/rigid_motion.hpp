// SPDX-License-Identifier: GPL-3.0-or-later
// Position and velocity of a body in the plane, in the gear convention: angles clockwise from +y.
#pragma once

#include <cmath>

#include "hdconj/base/vec2.hpp"

namespace hdconj {

/// Position of a body: x -> R x + origin with R = [cos, sin; -sin, cos], a clockwise turn by theta.
struct Pose
{
    double cosine = 1;  ///< of theta
    double sine = 0;
    Vec2 origin = Vec2::Zero();  ///< [mm]

    [[nodiscard]] Vec2 rotate(Vec2 const& v) const
    {
        return {cosine * v.x() + sine * v.y(), -sine * v.x() + cosine * v.y()};
    }
    [[nodiscard]] Vec2 rotate_back(Vec2 const& v) const
    {
        return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
    }
    [[nodiscard]] Vec2 operator()(Vec2 const& x) const { return rotate(x) + origin; }
    [[nodiscard]] Vec2 inverse(Vec2 const& p) const { return rotate_back(p - origin); }
};

/// Velocity field of a body in its own frame, per unit of the motion's parameter:
/// v(x, y) = omega (y, -x) + q, omega = dtheta/du clockwise.
struct PlanarVelocity
{
    double omega = 0;       ///< [1]
    Vec2 q = Vec2::Zero();  ///< velocity of the body's origin [mm]

    [[nodiscard]] Vec2 operator()(Vec2 const& x) const { return omega * right_of(x) + q; }
};

/// Turned clockwise by @p angle about the origin.
[[nodiscard]] inline Vec2 turned_clockwise(Vec2 const& p, double angle)
{
    double const c = std::cos(angle);
    double const s = std::sin(angle);
    return {c * p.x() + s * p.y(), -s * p.x() + c * p.y()};
}

}  // namespace hdconj
