// SPDX-License-Identifier: GPL-3.0-or-later
// Where a piece of the tooth touches its envelope at one instant: the meshing condition n.v = 0, solved in closed form
// on arcs and lines.
#pragma once

#include <algorithm>
#include <cmath>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/numeric/bernstein_roots.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj::envelope {

/// One contact of the tooth (offset outward by d) with its envelope, in the tooth frame.
struct Contact
{
    double t = 0;           ///< local parameter of the piece, 0 ... 1 inside it
    Vec2 x = Vec2::Zero();  ///< point of the offset profile [mm]
    Vec2 n = Vec2::Zero();  ///< outward unit normal
    /// Velocity of the envelope point along right_of(n), per unit of the motion's parameter, times `slowness`.
    /// It is written as a quotient because it has a pole at a double root of the meshing condition.
    double advance = 0;
    double slowness = 1;
    /// Positive: nearby positions of the tooth stay behind this point, so that it can bound the swept region.
    /// Zero: cusp of the envelope. Scaled by a positive factor.
    double bound = 0;
    double bound_size = 0;  ///< size of the terms of `bound`, cancellations undone: its error is some roundings of this
    double turning = 0;     ///< df/du at the contact: zero where the contact reverses along the profile
    double turning_size = 0;  ///< the same for `turning`
    /// Error of the point along its tangent per unit of roundoff [mm]: large where the contact runs fast along the
    /// profile.
    double rounding = 0;
};

/// Contact of a circular arc or corner, offset by @p d.
///
/// The meshing condition is f = n.V with V the velocity of the arc's centre, so n = sign * V turned by +90 degrees /
/// |V|. Let a' = cross(V, V')/|V|^2 be the turning rate of V, and r = radius + d. The envelope point then moves along
/// right_of(n) at
///   sign |V| + r (omega - a')
/// It bounds the swept region locally if and only if
///   sgn(r) (|V|^3 + sign r (omega |V|^2 - cross(V, V'))) > 0
/// Degenerate: V = 0, where the whole arc touches: n is not finite.
[[nodiscard]] inline Contact arc_contact(profile::ArcPiece const& arc, motion::MotionRates const& rates, int sign,
                                         double d)
{
    Vec2 const v = rates.twist(arc.centre);
    Vec2 const v1 = rates.change(arc.centre);
    double const speed2 = v.squaredNorm();
    double const speed = std::sqrt(speed2);
    double const s = sign;
    double const r = arc.radius + d;
    double const side = r < 0 ? -1 : 1;
    double const bend = cross(v, v1);
    Contact c;
    c.n = (s / speed) * left_of(v);
    c.x = arc.centre + r * c.n;
    double const angle = std::atan2(cross(direction(arc.from), c.n), direction(arc.from).dot(c.n));
    c.t = angle / (arc.to - arc.from);
    c.slowness = speed2;
    c.advance = s * speed * speed2 + r * (rates.twist.omega * speed2 - bend);
    c.bound = side * s * c.advance;
    // first-order error propagation through the expressions above
    double const v_size = rates.velocity_size(arc.centre);
    double const bend_size = v1.norm() * v_size + speed * rates.velocity_change_size(arc.centre);
    double const turn_size = 2 * std::abs(rates.twist.omega) * speed * v_size + rates.omega_size * speed2;
    c.bound_size = 3 * speed2 * v_size + std::abs(r) * (turn_size + bend_size);
    c.turning = s * bend / speed;
    c.turning_size = bend_size / speed;
    c.rounding = std::abs(r) * v_size / speed;
    return c;
}

/// Contact of an arc whose centre stands still to roundoff while the contact runs from t_begin at u_begin to t_end at
/// u_end. All normals between touch at once, and t is taken as linear in u. The contact bounds the swept region locally
/// if and only if sign (turn of the normal) < 0, the limit of arc_contact() for V -> 0.
[[nodiscard]] inline Contact resting_contact(profile::ArcPiece const& arc, ContactArc const& along, double u, double d)
{
    double const share = (u - along.u_begin) / (along.u_end - along.u_begin);
    double const turn = (arc.to - arc.from) * (along.t_end - along.t_begin) / (along.u_end - along.u_begin);
    Contact c;
    c.t = along.t_begin + share * (along.t_end - along.t_begin);
    c.n = direction(arc.from + c.t * (arc.to - arc.from));
    c.x = arc.centre + (arc.radius + d) * c.n;
    c.advance = -(arc.radius + d) * turn;
    c.bound = along.candidate * turn < 0 ? 1 : -1;
    c.bound_size = 1;
    c.turning = c.bound;
    c.turning_size = 1;
    return c;
}

/// The part common to lines and curves: profile point @p x, unit normal, curvature @p k (convex positive).
[[nodiscard]] inline Contact smooth_contact(Vec2 const& x, Vec2 const& n, double k, motion::MotionRates const& rates,
                                            double d)
{
    Vec2 const tangent = right_of(n);
    double const omega = rates.twist.omega;
    double const slide = tangent.dot(rates.twist(x));
    double const f_s = k * slide - omega;
    double const slide_d = slide + d * omega;
    double const stretch = 1 + k * d;
    Contact c;
    c.x = x + d * n;
    c.n = n;
    c.turning = n.dot(rates.change(x));
    c.turning_size = rates.velocity_change_size(x);
    c.advance = f_s * slide_d - stretch * c.turning;
    c.slowness = f_s;
    c.bound = stretch > 0 ? c.advance : -std::abs(c.advance);
    double const v_size = rates.velocity_size(x) + std::abs(d) * rates.omega_size;
    // at a double root the error is that of a square root
    constexpr double square_root = 0x1p26;
    c.rounding = std::min(v_size / std::abs(f_s), square_root * x.norm());
    c.bound_size = (std::abs(k) * v_size + rates.omega_size) * std::abs(slide_d) + std::abs(f_s) * v_size +
                   std::abs(stretch) * c.turning_size;
    return c;
}

/// Contact of a straight line: f is linear along it. Outside the line t is outside 0 ... 1.
/// Degenerate: theta' = 0 gives t = +-infinity (or NaN where the whole line touches).
[[nodiscard]] inline Contact line_contact(profile::LinePiece const& line, motion::MotionRates const& rates, double d)
{
    Vec2 const n = line.normal();
    double const f_a = n.dot(rates.twist(line.a));
    double const s = f_a / rates.twist.omega;  // f(s) = f_a - omega s
    Vec2 const x = line.a + s * line.tangent();
    Contact c = smooth_contact(x, n, 0, rates, d);
    c.t = s / line.length();
    return c;
}

/// Contact of a curve at its parameter @p t, which must be a root of the meshing condition.
[[nodiscard]] inline Contact curve_contact(profile::CurvePiece const& curve, motion::MotionRates const& rates, double t,
                                           double d)
{
    Vec2 const x1 = curve.first(t);
    double const speed = x1.norm();
    double const k = -cross(x1, curve.second(t)) / (speed * speed * speed);
    Contact c = smooth_contact(curve.point(t), left_of(x1) / speed, k, rates, d);
    c.t = t;
    return c;
}

/// Bernstein coefficients in t of f(., u) = theta' A + q_x B + q_y C. Returns how far rounding may move them from those
/// of the exact curve under the exact @p twist.
inline double meshing_polynomial(profile::CurvePiece const& curve, PlanarVelocity const& twist, std::span<double> out)
{
    double size = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        double const a = twist.omega * curve.a()[i];
        double const b = twist.q.x() * curve.b()[i];
        double const c = twist.q.y() * curve.c()[i];
        out[i] = a + b + c;
        size = std::max(size, std::abs(a) + std::abs(b) + std::abs(c));
    }
    double const stored =
        std::abs(twist.omega) * curve.a_error() + (std::abs(twist.q.x()) + std::abs(twist.q.y())) * curve.b_error();
    return 4 * unit_roundoff * size + stored;
}

/// All parameters at which the curve touches its envelope now; see bernstein_roots for what is proved.
[[nodiscard]] inline numeric::BernsteinRoots curve_contacts(profile::CurvePiece const& curve,
                                                            PlanarVelocity const& twist)
{
    numeric::BernsteinWork work{};
    std::span<double> const f(work.data(), curve.a().size());
    double const noise = meshing_polynomial(curve, twist, f);
    return numeric::bernstein_roots(f, noise);
}

}  // namespace hdconj::envelope
