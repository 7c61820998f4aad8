// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest value of a function beside a place where it falls.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::numeric {

/// A minimum and where it is.
struct BracketedMinimum
{
    double x = 0;
    double value = 0;
};

/// The next place in the bracket a, x, b, whose values are largest at the ends: the vertex of the parabola through
/// them. Where that is x itself, a place so far towards the higher end that the value rises by half of @p enough.
/// Not a number where there is no such parabola.
[[nodiscard]] inline double vertex_in(double a, double x, double b, double at_a, double at_x, double at_b,
                                      double enough)
{
    double const fall_a = (at_a - at_x) / (x - a), fall_b = (at_b - at_x) / (b - x);
    double const bend = (fall_a + fall_b) / (b - a);  // half the second derivative, of either direction of a to b
    double const vertex = 0.5 * (a + x + fall_a / bend);
    double const near = std::sqrt(0.5 * enough / bend);
    if (std::abs(vertex - x) >= near)
        return vertex;
    return at_a > at_b ? x + (a < x ? -near : near) : x + (b < x ? -near : near);
}

/// Smallest value of @p f from @p a towards @p b, f(a) = @p fa given; (a, fa) itself where the function does not fall
/// from there.
///
/// The vertex of the parabola through the bracket, and golden section (Kiefer 1953) where two steps have not halved the
/// bracket: a smooth minimum takes some ten values, the point of a V is found too. No derivative is needed. The search
/// ends where neither end of the bracket lies more than @p enough above the smallest value, or at the last bits of the
/// place. For a function that is convex there, this bounds the error of the value by 3 @p enough. A function with
/// several minima gives one of them.
///
/// (boost::math::tools::brent_find_minima() bounds the place of the minimum and not its value.)
template <class F>
[[nodiscard]] BracketedMinimum minimum_beside(F&& f, double a, double b, double fa, double enough)
{
    // so near that what falls at all falls there
    constexpr double step = 0x1p-10;
    constexpr double golden = 0.38196601125010515;  // (3 - sqrt 5)/2
    double x = a + step * (b - a);
    double at_x = f(x);
    if (!(at_x < fa))
        return {a, fa};
    double const size = std::max(std::abs(a), std::abs(b));
    double at_a = fa, at_b = f(b);
    constexpr std::size_t budget = 200;
    std::array<double, 2> before{};
    for (std::size_t i = 0; i < budget; ++i) {
        if (std::abs(b - a) <= 4 * unit_roundoff * size || std::max(at_a, at_b) - at_x <= enough)
            break;
        double const width = std::abs(b - a);
        bool const slow = i >= 2 && width > 0.5 * before[i % 2];  // two steps ago
        before[i % 2] = width;
        double y = slow ? a : vertex_in(a, x, b, at_a, at_x, at_b, enough);
        if (!((y - a) * (y - b) < 0) || y == x)
            y = std::abs(b - x) > std::abs(x - a) ? x + golden * (b - x) : x - golden * (x - a);
        bool const beyond = (y - x) * (b - a) > 0;
        double const at_y = f(y);
        if (at_y < at_x) {
            (beyond ? a : b) = x;
            (beyond ? at_a : at_b) = at_x;
            x = y;
            at_x = at_y;
        } else {
            (beyond ? b : a) = y;
            (beyond ? at_b : at_a) = at_y;
        }
    }
    return at_b < at_x ? BracketedMinimum{b, at_b} : BracketedMinimum{x, at_x};
}

/// Smallest value of @p f at the whole numbers from @p a to @p b, with f(a) = @p fa given. The function may have
/// several minima. All whole numbers between are evaluated; those that are smaller than their neighbours are refined
/// (minimum_beside()).
template <class F>
[[nodiscard]] BracketedMinimum minimum_of_steps(F&& f, double a, double b, double fa, double enough)
{
    auto const steps = static_cast<int>(std::lround(std::abs(b - a)));
    double const step = b < a ? -1 : 1;
    BracketedMinimum best{a, fa};
    auto const follow = [&](double from, double to, double value) {
        BracketedMinimum const found = minimum_beside(f, from, to, value, enough);
        if (found.value < best.value)
            best = found;
    };
    double before = fa, here = fa;  // of the step before, and of this one
    for (int i = 0; i <= steps; ++i) {
        double const x = a + step * i;
        double const after = i < steps ? f(x + step) : here;
        if (here < best.value)
            best = {x, here};
        if (here <= before && here <= after) {
            if (i > 0)
                follow(x, x - step, here);
            if (i < steps)
                follow(x, x + step, here);
        }
        before = here;
        here = after;
    }
    return best;
}

}  // namespace hdconj::numeric
