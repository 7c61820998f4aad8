// SPDX-License-Identifier: GPL-3.0-or-later
// How the wire leans, and lengths as they are seen along it.
#pragma once

#include <cmath>

#include "hdconj/base/vec2.hpp"

namespace hdconj::wedm {

/// The direction of a wire, q sideways for each unit of length along the axis.
///
/// A plane across the axis cuts the cylinder of radius r around the wire in the ellipse of all points x about its
/// centre with |seen(x)| = r: half axes r across q, and r sqrt(1 + q^2) along it. Its support along a normal n is
/// r |cast(n)|. An upright wire changes no vector, bit for bit.
class Lean
{
  public:
    Lean() = default;
    /// Of the wire from @p lower to @p upper, planes that are @p height apart; infinity: upright.
    Lean(Vec2 const& lower, Vec2 const& upper, double height)
        : q_((upper - lower) / height), secant_(std::sqrt(1 + q_.squaredNorm()))
    {
    }

    /// 1/cos of the angle between wire and axis.
    [[nodiscard]] double secant() const { return secant_; }
    /// @p v in a plane across the axis, projected along the wire: its length is the distance from the wire.
    [[nodiscard]] Vec2 seen(Vec2 const& v) const { return v - q_.dot(v) / (secant_ * (1 + secant_)) * q_; }
    /// The inverse, and as it is symmetric what it makes of normals.
    [[nodiscard]] Vec2 cast(Vec2 const& v) const { return v + q_.dot(v) / (1 + secant_) * q_; }

  private:
    Vec2 q_ = Vec2::Zero();
    double secant_ = 1;
};

}  // namespace hdconj::wedm
