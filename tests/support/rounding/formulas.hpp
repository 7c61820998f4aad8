// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The contact of one arc or line with its envelope, step by step, as the formulas of docs/explanation/theory.md stand
/// there and in any number type: what is lost where can be seen by comparing types.
#pragma once

#include <array>
#include <cmath>

#include "support/oracle/motion.hpp"
#include "support/oracle/number.hpp"
#include "support/oracle/tooth.hpp"

namespace rounding {

using oracle::Point;

/// What the formulas start from. Each number is right to the roundoff of its type.
template <class T>
struct Inputs
{
    T u{}, phi{};                   ///< position, and its arc length over r_m
    T r_m{}, r_0{}, w0{}, ratio{};  ///< ratio = z_f / z_c
    int waves = 2;
    bool arc = true;
    Point<T> a, b;  ///< arc: centre, unused; line: its ends (tooth frame)
    T radius{};     ///< arc: positive convex, negative concave
    int sign = 1;   ///< arc: which of the two normals
    Point<T> x, n;  ///< a point of the piece and its normal, for the condition n.v = 0 there
};

/// What comes out, in the order of computation.
template <class T>
struct Steps
{
    T phi{};            ///< arc length over r_m
    T element{};        ///< S = sqrt(rho^2 + rho'^2)
    T turn{};           ///< theta'
    T q_x{};            ///< S - k rho^2 / r_m
    Point<T> velocity;  ///< of the arc's centre, or of the line's lower end
    Point<T> normal;    ///< at the contact
    T place{};          ///< line: contact's distance from its lower end
    Point<T> contact;   ///< tooth frame
    Point<T> point;     ///< circular-spline frame
    Point<T> across;    ///< the normal in the circular-spline frame
    T speed{};          ///< of the envelope point along its tangent; 0 at a cusp
    T condition{};      ///< n.v at Inputs::x
    T slope{};          ///< d(n.v)/du there; 0 where the contact turns back (fold)
};

template <class T>
Point<T> left_of(Point<T> const& a)
{
    return {-a.y, a.x};
}

template <class T>
Steps<T> steps(Inputs<T> const& in)
{
    using std::cos;
    using std::sin;
    using std::sqrt;
    T const n(in.waves), c = cos(n * in.u), s = sin(n * in.u);
    T const w = in.w0 * c, w1 = -n * in.w0 * s, w2 = -n * n * in.w0 * c, w3 = n * n * n * in.w0 * s;
    T const rho = in.r_0 + w, k = in.ratio / in.r_m;
    Steps<T> out;
    out.phi = in.phi;
    T const s2 = rho * rho + w1 * w1;
    out.element = sqrt(s2);
    T const bend = rho * w2 - w1 * w1;
    out.turn = T(1) - k * out.element - bend / s2;
    out.q_x = out.element - k * rho * rho;
    T const q_y = k * rho * w1;
    // and their derivatives
    T const element1 = w1 * (rho + w2) / out.element;
    T const turn1 = -k * element1 - (rho * w3 - w1 * w2) / s2 + T(2) * bend * element1 / (s2 * out.element);
    T const q_x1 = element1 - T(2) * k * rho * w1, q_y1 = k * (w1 * w1 + rho * w2);

    auto const velocity = [&](Point<T> const& x) -> Point<T> {
        return {out.turn * x.y + out.q_x, q_y - out.turn * x.x};
    };
    auto const change = [&](Point<T> const& x) -> Point<T> { return {turn1 * x.y + q_x1, q_y1 - turn1 * x.x}; };
    out.condition = dot(in.n, velocity(in.x));
    out.slope = dot(in.n, change(in.x));
    out.velocity = velocity(in.a);
    if (in.arc) {
        T const fast = length(out.velocity);
        Point<T> const v1 = change(in.a);
        out.normal = (T(in.sign) / fast) * left_of(out.velocity);
        out.contact = in.a + in.radius * out.normal;
        T const turning = (out.velocity.x * v1.y - out.velocity.y * v1.x) / (fast * fast);
        out.speed = T(in.sign) * fast + in.radius * (out.turn - turning);
    } else {
        Point<T> const along = in.b - in.a;
        T const size = length(along);
        // up the right flank: the body lies on the left
        Point<T> const tangent = (T(1) / size) * along;
        out.normal = {tangent.y, -tangent.x};
        // n.v falls by theta' per unit of length along the normal turned by -90 degrees, which is against `tangent`
        out.place = -dot(out.normal, out.velocity) / out.turn;
        out.contact = in.a + out.place * tangent;
        Point<T> const clockwise{out.normal.y, -out.normal.x};
        out.speed = dot(clockwise, velocity(out.contact)) + dot(out.normal, change(out.contact)) / out.turn;
    }

    // pose: gamma = u - (z_f/z_c) phi, theta = gamma - atan(rho'/rho)
    T const gamma = in.u - in.ratio * in.phi, sg = sin(gamma), cg = cos(gamma);
    T const ct = rho / out.element, st = w1 / out.element;
    T const cos_theta = cg * ct + sg * st, sin_theta = sg * ct - cg * st;
    auto const turned = [&](Point<T> const& p) -> Point<T> {
        return {p.x * cos_theta + p.y * sin_theta, p.y * cos_theta - p.x * sin_theta};
    };
    out.point = turned(out.contact) + Point<T>{rho * sg, rho * cg};
    out.across = turned(out.normal);
    return out;
}

/// What is judged, each as a relative error.
enum Judged
{
    judged_phi,       ///< of phi
    judged_element,   ///< of S
    judged_turn,      ///< of theta'
    judged_q_x,       ///< of q_x
    judged_velocity,  ///< |error| / |V|
    judged_normal,    ///< arc: angle of the normal [rad]; line: place over the tooth's height
    judged_along,     ///< point, along the envelope, over the tooth's height
    judged_across,    ///< point, across the envelope, over the tooth's height: what the outline is wrong by
    judged_speed,     ///< of the envelope's speed
    judged_position,  ///< u for a given profile point [rad]
    judged_count
};

inline constexpr std::array<char const*, judged_count> judged_names{"arc length phi",
                                                                    "line element S",
                                                                    "theta'",
                                                                    "q_x",
                                                                    "velocity V",
                                                                    "contact normal or place",
                                                                    "point along the envelope",
                                                                    "point across the envelope",
                                                                    "envelope speed",
                                                                    "position of a profile point"};

using Losses = std::array<double, judged_count>;

/// Errors of @p got against @p right, relative to the size named above. Sizes are those of @p right.
template <class T>
Losses errors(Steps<T> const& got, Steps<oracle::Fifty> const& right, Inputs<oracle::Fifty> const& in,
              oracle::Fifty const& height)
{
    using oracle::Fifty;
    auto const scalar = [](T const& a, Fifty const& b) -> Fifty {
        return abs(Fifty(a) - b) / (b == 0 ? Fifty(1) : Fifty(abs(b)));
    };
    auto const apart = [](Point<T> const& a, Point<Fifty> const& b) { return oracle::as<Fifty>(a) - b; };
    Point<Fifty> const shift = apart(got.point, right.point);
    Point<Fifty> const along{right.across.y, -right.across.x};
    std::array<Fifty, judged_count> const all{
        scalar(got.phi, right.phi),
        scalar(got.element, right.element),
        scalar(got.turn, right.turn),
        scalar(got.q_x, right.q_x),
        length(apart(got.velocity, right.velocity)) / length(right.velocity),
        in.arc ? length(apart(got.normal, right.normal)) : Fifty(abs(Fifty(got.place) - right.place) / height),
        abs(dot(shift, along)) / height,
        abs(dot(shift, right.across)) / height,
        scalar(got.speed, right.speed),
        abs(Fifty(got.condition) - right.condition) / abs(right.slope)};
    Losses out{};
    for (int i = 0; i < judged_count; ++i)
        out[static_cast<std::size_t>(i)] = static_cast<double>(all[static_cast<std::size_t>(i)]);
    return out;
}

}  // namespace rounding
