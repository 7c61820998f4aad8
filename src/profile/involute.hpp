// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "involute": flanks unwound from a base circle.
#pragma once

#include <cmath>

#include "hdconj/profile/builder.hpp"
#include "hdconj/profile/polynomial_curve.hpp"

namespace hdconj::profile {

/// Right flank: involute of the circle r_b = r cos(alpha) about the undeformed gear's centre, r = m z / 2 the pitch
/// circle, which the pitch line y = 0 touches at x = 0; r < 0 on the circular spline, whose centre is on the other side
/// and whose flanks are concave. Rolled by t from the pitch point (string of length r_b (tan alpha + t)) its tangent
/// stands at beta(t) = s/(2 r) - alpha - t clockwise from y, and
///
///   P(t) = P(0) + r_b integral_0^t (tan alpha + tau) (sin beta(tau), cos beta(tau)) dtau,   P(0) = r (sin, cos -
///   1)(s/(2 r))
///
/// Cut flat at y = h_a and at y = -h_f; where the root lies below the base circle the flank goes on along the radius.
/// At the base circle the involute has no radius of curvature: within 1e-12 of the tooth's height it is replaced by a
/// small arc. Accuracy: curve_accuracy of the height. Refused: flanks that cross below the tip; on the circular spline
/// a tip beyond the base circle.
struct Involute
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {
            "involute",
            "involutes of a base circle about the undeformed gear's centre",
            {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
             {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
             {"pressure_angle_deg",
              angle_deg,
              "pressure angle on the pitch circle of radius module * teeth / 2, alpha",
              true,
              {},
              1,
              60},
             {"thickness", positive_length, "tooth thickness on the pitch circle, s; default pi module / 2", false}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

/// The right flank's involute by the angle rolled from the pitch point.
struct InvoluteCurve
{
    double pitch_radius;  ///< r
    double alpha;
    double half_angle;  ///< s/(2 r)

    [[nodiscard]] double base_radius() const { return pitch_radius * std::cos(alpha); }
    /// Where the string has length 0.
    [[nodiscard]] double base() const { return -std::tan(alpha); }
    [[nodiscard]] double beta(double t) const { return half_angle - alpha - t; }
    /// Angle of the outward normal: the tangent stands at beta clockwise from y, so the normal at -beta from x.
    [[nodiscard]] double normal(double t) const { return -beta(t); }

    [[nodiscard]] CurveJet operator()(double t) const
    {
        double const half = std::sin(0.5 * half_angle);
        double const b = beta(t);
        // sin b - sin beta(0) and cos b - cos beta(0) as products: no difference of close numbers of size r_b
        double const turn = 2 * std::sin(0.5 * t);
        double const mean = b + 0.5 * t;
        double const sine = -turn * std::cos(mean);
        double const cosine = turn * std::sin(mean);
        double const x = t * std::cos(b) - base() * cosine + sine;
        double const y = -t * std::sin(b) + base() * sine + cosine;
        Vec2 const pitch_point{pitch_radius * std::sin(half_angle), -2 * pitch_radius * half * half};
        return {pitch_point + base_radius() * Vec2(x, y),
                base_radius() * (t - base()) * Vec2(std::sin(b), std::cos(b))};
    }
};

}  // namespace hdconj::profile
