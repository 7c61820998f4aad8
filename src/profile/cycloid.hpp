// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "cycloid": epicycloid above the pitch circle, hypocycloid below.
#pragma once

#include <cmath>

#include "hdconj/profile/builder.hpp"
#include "hdconj/profile/polynomial_curve.hpp"

namespace hdconj::profile {

/// Right flank: a point of a circle of radius rho_a that rolls on the outside of the pitch circle (radius R = m z / 2,
/// which the pitch line touches at x = 0), and of one of radius rho_f that rolls inside, both from the pitch point at
/// the polar angle s/(2 R). With rho = rho_a or -rho_f and the circle turned by t against its line of centres,
///
///   P(t) = P(0) + 2 rho (1 + rho/R) integral_0^t sin(tau/2) (sin beta, cos beta) dtau,   beta(tau) = s/(2 R) - (1/2 +
///   rho/R) tau
///
/// Cut flat at y = h_a and y = -h_f. R < 0 on the circular spline. At the pitch point both curves are radial, with no
/// radius of curvature: the flank is tangent-continuous there, and within rho/1e12 of the cycloids a convex and a
/// concave arc stand in for them. Degenerate: rho_f = R/2 gives a radial dedendum. Accuracy elsewhere: curve_accuracy
/// of the height.
struct Cycloid
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {
            "cycloid",
            "epicycloid above the pitch circle of radius module * teeth / 2, hypocycloid below",
            {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
             {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
             {"addendum_rolling_radius", positive_length,
              "radius of the circle that rolls outside of the pitch circle, rho_a; above addendum / 2"},
             {"dedendum_rolling_radius", positive_length,
              "radius of the circle that rolls inside, rho_f; above dedendum / 2"},
             {"thickness", positive_length, "tooth thickness on the pitch circle, s; default pi module / 2", false}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

/// One of the two curves from the pitch point, by the angle t.
struct CycloidCurve
{
    double pitch_radius;  ///< R
    double rolling;       ///< rho: > 0 outside of the pitch circle, < 0 inside
    double half_angle;    ///< s/(2 R)

    [[nodiscard]] double beta(double t) const { return half_angle - (0.5 + rolling / pitch_radius) * t; }
    /// Angle of the outward normal.
    [[nodiscard]] double normal(double t) const { return -beta(t); }

    [[nodiscard]] CurveJet operator()(double t) const
    {
        double const share = rolling / pitch_radius;
        double const p = 1 + share;
        double const q = -share;
        // the product of sines is a sum: frequencies p = 1 + rho/R and q = -rho/R, the latter next to nothing
        double const fast = std::sin(0.5 * p * t) / p;
        double const slow = 0.5 * t * (q * t == 0 ? 1.0 : std::sin(0.5 * q * t) / (0.5 * q * t));
        double const fast_at = 0.5 * p * t - half_angle;
        double const slow_at = 0.5 * q * t + half_angle;
        Vec2 const sum{fast * std::cos(fast_at) - slow * std::cos(slow_at),
                       fast * std::sin(fast_at) + slow * std::sin(slow_at)};
        double const half = std::sin(0.5 * half_angle);
        Vec2 const pitch_point{pitch_radius * std::sin(half_angle), -2 * pitch_radius * half * half};
        double const b = beta(t);
        return {pitch_point + 2 * rolling * p * sum,
                2 * rolling * p * std::sin(0.5 * t) * Vec2(std::sin(b), std::cos(b))};
    }

    /// Where the curve has turned by a right angle, or the circle by half a turn: it reaches no further from the pitch
    /// circle.
    [[nodiscard]] double last() const;
};

}  // namespace hdconj::profile
