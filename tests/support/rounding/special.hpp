// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Positions at which something about a contact vanishes: folds and cusps, to 50 digits.
#pragma once

#include <optional>
#include <stdexcept>

#include "study.hpp"

namespace rounding {

/// Root of @p f in [a, b] by bisection; nothing when there is no change of sign.
template <class T, class F>
std::optional<T> root(F const& f, T a, T b)
{
    bool const negative = f(a) < T(0);
    if ((f(b) < T(0)) == negative)
        return std::nullopt;
    for (int step = 0; step < 400; ++step) {
        T const middle = a + (b - a) / T(2);
        if (!(middle > a && middle < b))
            break;
        ((f(middle) < T(0)) == negative ? a : b) = middle;
    }
    return a;
}

/// The first position in the lobe after @p from where @p what of a piece's contact changes sign with the contact inside
/// the piece.
template <class What>
Fifty special_position(FourTypes const& drive, std::size_t piece, int sign, double from, What const& what)
{
    double const step = drive.in_double().motion.half_lobe() / 20000;
    auto const in_double = [&](double u) {
        return what(steps(drive.in_double().inputs(piece, 0.5, u, sign)),
                    drive.in_double().inputs(piece, 0.5, u, sign));
    };
    for (double u = from; u < drive.in_double().motion.half_lobe(); u += step) {
        Inputs<double> const in = drive.in_double().inputs(piece, 0.5, u, sign);
        auto const& p = drive.in_double().tooth.flank[piece];
        Point<double> const low = p.normal(0), high = p.normal(1), n = steps(in).normal;
        bool const inside = (low.x * n.y - low.y * n.x) * (n.x * high.y - n.y * high.x) > 0 && dot(low, n) > 0;
        if (!inside || (in_double(u) < 0) == (in_double(u + step) < 0))
            continue;
        auto const f = [&](Fifty const& at) {
            Inputs<Fifty> exact = drive.in_fifty().inputs(piece, 0.5, 0, sign);
            exact.u = at;
            exact.phi = drive.in_fifty().motion.phi(at);
            return what(steps(exact), exact);
        };
        if (auto const found = root(f, Fifty(u), Fifty(u + step)))
            return *found;
    }
    throw std::runtime_error("rounding study: no such position");
}

/// Turning rate of V: zero at a fold.
template <class T>
T turning(Steps<T> const& s, Inputs<T> const& in)
{
    return s.turn - (s.speed - T(in.sign) * length(s.velocity)) / in.radius;
}

}  // namespace rounding
