// SPDX-License-Identifier: GPL-3.0-or-later
// One root between two arguments where a function has opposite signs.
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::numeric {

/// A root with the bracket that proves it.
struct BracketedRoot
{
    double x = 0;      ///< the end of the bracket with the smaller |f|
    double width = 0;  ///< of the final bracket
    std::size_t evaluations = 0;
    bool found = false;  ///< false: no sign change on the interval given, or no convergence
};

/// What is left of the bracket a ... b of a root of @p f when it is no wider than @p width, and the evaluations spent.
/// TOMS algorithm 748 (Alefeld, Potra, Shi 1995) through Boost.Math.
struct ShrunkBracket
{
    double low, high;  ///< above a
    std::uintmax_t used;
};
template <class F>
[[nodiscard]] ShrunkBracket shrunk_bracket(F& f, double a, double b, double fa, double fb, double width,
                                           std::uintmax_t budget)
{
    std::uintmax_t used = budget;
    // two last bits of the larger end; not of the root: a root at zero has no last bit
    double const last_bits = 4 * unit_roundoff * std::max(std::abs(a), std::abs(b));
    double const goal = std::max(width, last_bits);
    auto const narrow = [&](double x, double y) { return std::abs(y - x) <= goal; };
    // measured from the lower end: Boost's steps next to a negative end can stall one bit before the goal
    auto const from_a = [&](double y) { return f(a + y); };
    auto const [low, high] = boost::math::tools::toms748_solve(from_a, 0.0, b - a, fa, fb, narrow, used);
    return {low, high, used};
}

/// Root of @p f between @p a and @p b, f(a) = @p fa and f(b) = @p fb given, to the last bits of the larger end.
///
/// A zero at an end is returned at once.
/// No sign change: found = false, never an invented root.
template <class F>
[[nodiscard]] BracketedRoot bracketed_root(F&& f, double a, double b, double fa, double fb)
{
    if (fa == 0)
        return {a, 0, 0, true};
    if (fb == 0)
        return {b, 0, 0, true};
    if (!(std::signbit(fa) != std::signbit(fb)) || !std::isfinite(fa) || !std::isfinite(fb))
        return {};
    constexpr std::uintmax_t budget = 200;
    ShrunkBracket const last = shrunk_bracket(f, a, b, fa, fb, 0, budget);
    double const f_low = std::abs(f(a + last.low));
    double const f_high = std::abs(f(a + last.high));
    return {a + (f_low <= f_high ? last.low : last.high), std::abs(last.high - last.low),
            static_cast<std::size_t>(last.used) + 2, last.used < budget};
}

template <class F>
[[nodiscard]] BracketedRoot bracketed_root(F&& f, double a, double b)
{
    return bracketed_root(f, a, b, f(a), f(b));
}

}  // namespace hdconj::numeric
