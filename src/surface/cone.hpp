// SPDX-License-Identifier: GPL-3.0-or-later
// Tilt of kind "radial": the outline moved along its own radii.
#pragma once

#include "hdconj/base/vec2.hpp"

namespace hdconj::surface {

/// @p p moved outward along its radius by @p distance [mm]: one outline makes a ring that closes at every height.
/// For distance 0 the same bits. Domain: distance > -|p|.
[[nodiscard]] inline Vec2 moved_radially(Vec2 const& p, double distance)
{
    return p * (1 + distance / p.norm());
}

/// Unit normal there of a curve that had normal @p n at @p p: the radial part of a tangent stays, the other grows by 1
/// + distance/|p|.
[[nodiscard]] inline Vec2 normal_moved_radially(Vec2 const& p, Vec2 const& n, double distance)
{
    Vec2 const out = p.normalized();
    double const stretch = 1 + distance / p.norm();
    Vec2 const radial = n.dot(out) * out;
    return (stretch * radial + (n - radial)).normalized();
}

}  // namespace hdconj::surface
