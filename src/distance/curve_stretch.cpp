// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/distance/curve_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "hdconj/numeric/bernstein.hpp"

namespace hdconj::distance {
namespace {

/// The control points of a vector-valued polynomial in Bernstein form, and of what a cut leaves of it.
struct Controls
{
    std::vector<double> x, y;

    Controls upper_half()
    {
        Controls right{std::vector<double>(x.size()), std::vector<double>(y.size())};
        constexpr double cut = 0.5;
        numeric::bernstein_split(x, right.x, cut);
        numeric::bernstein_split(y, right.y, cut);
        return right;
    }
    [[nodiscard]] Controls derivative() const
    {
        return {numeric::bernstein_derivative(x), numeric::bernstein_derivative(y)};
    }
    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Vec2 operator[](std::size_t i) const { return {x[i], y[i]}; }
};

Vec2 middle_of(Controls const& c)
{
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = 0; i < c.size(); ++i)
        sum += c[i];
    return sum / static_cast<double>(c.size());
}

/// All of the polynomial lies as near to @p centre as its control points; a little more for the roundings of the cuts.
double reach_from(Controls const& c, Vec2 const& centre)
{
    constexpr double roundings = 1 + 0x1p-40;
    double reach = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
        reach = std::max(reach, (c[i] - centre).norm());
    return roundings * reach;
}

/// Power series in s about t = @p middle, where s = 1 is @p half further on. Differences lose some hundred roundings of
/// a coordinate, so that more digits are carried.
std::vector<double> series(std::vector<double> const& controls, double middle, double half)
{
    std::vector<long double> c(controls.begin(), controls.end());
    std::vector<double> sum;
    long double factor = 1;
    for (std::size_t k = 0; !c.empty(); ++k) {
        std::vector<long double> w = c;
        for (std::size_t r = w.size() - 1; r > 0; --r)
            for (std::size_t i = 0; i < r; ++i)
                w[i] += static_cast<long double>(middle) * (w[i + 1] - w[i]);
        sum.push_back(static_cast<double>(factor * w[0]));
        // the next derivative with respect to s, over k + 1
        factor *=
            static_cast<long double>(half) * static_cast<long double>(c.size() - 1) / static_cast<long double>(k + 1);
        for (std::size_t i = 0; i + 1 < c.size(); ++i)
            c[i] = c[i + 1] - c[i];
        c.pop_back();
    }
    return sum;
}

/// How many terms of both series say all but less than a rounding of @p size.
std::size_t terms_that_matter(std::vector<double> const& x, std::vector<double> const& y, double size)
{
    constexpr double share = 0x1p-55;
    double rest = 0;
    std::size_t terms = x.size();
    while (terms > 0 && rest + std::abs(x[terms - 1]) + std::abs(y[terms - 1]) <= share * size) {
        rest += std::abs(x[terms - 1]) + std::abs(y[terms - 1]);
        --terms;
    }
    return terms;
}

/// Derivatives are with respect to the whole curve's parameter, of which the stretch is @p width wide.
CurveStretch stretch(profile::CurvePiece const& curve, double from, double width, Controls const& at,
                     Controls const& slope, Controls const& bend)
{
    CurveStretch made;
    made.curve = &curve;
    made.from = from;
    made.to = from + width;
    made.first = curve.point(made.from);
    made.last = curve.point(made.to);
    made.slope_first = curve.first(made.from);
    made.slope_last = curve.first(made.to);
    made.bend_first = curve.second(made.from);
    made.bend_last = curve.second(made.to);
    made.low = made.first.cwiseMin(made.last);
    made.high = made.first.cwiseMax(made.last);
    for (std::size_t i = 0; i < at.size(); ++i) {
        made.low = made.low.cwiseMin(at[i]);
        made.high = made.high.cwiseMax(at[i]);
    }
    made.centre = 0.5 * (made.low + made.high);
    made.reach = reach_from(at, made.centre);
    made.bend = bend.size() > 0 ? middle_of(bend) : Vec2::Zero();
    made.bend_reach = bend.size() > 0 ? reach_from(bend, made.bend) : 0;
    Vec2 const mean = middle_of(slope);
    double const slowest = mean.norm() - reach_from(slope, mean);
    made.slowest = slowest > 0 ? slowest * slowest : 0;
    std::vector<double> const x = series(curve.x(), from + 0.5 * width, 0.5 * width),
                              y = series(curve.y(), from + 0.5 * width, 0.5 * width);
    made.terms = terms_that_matter(x, y, made.low.norm() + made.high.norm());
    if (made.terms > CurveStretch::most_terms) {
        made.slowest = 0;  // nothing is proved here
        made.terms = 0;
    }
    std::copy_n(x.begin(), made.terms, made.x.begin());
    std::copy_n(y.begin(), made.terms, made.y.begin());
    return made;
}

void cut(std::vector<CurveStretch>& stretches, profile::CurvePiece const& curve, double from, double width, Controls at,
         Controls slope, Controls bend)
{
    // directions within about as many radians, and no shorter than what the bounds gain by
    constexpr double straight = 0.125;
    constexpr double shortest = 0x1p-6;
    Vec2 const mean = middle_of(slope);
    if (width <= shortest || reach_from(slope, mean) <= straight * mean.norm()) {
        CurveStretch const made = stretch(curve, from, width, at, slope, bend);
        if (made.terms > 0 || width <= shortest) {
            stretches.push_back(made);
            return;
        }
    }
    Controls const at_right = at.upper_half(), slope_right = slope.upper_half(), bend_right = bend.upper_half();
    cut(stretches, curve, from, 0.5 * width, at, slope, bend);
    cut(stretches, curve, from + 0.5 * width, 0.5 * width, at_right, slope_right, bend_right);
}

/// x and its first two derivatives with respect to s.
struct Jet
{
    double x, y, x1, y1, x2, y2;
};

Jet jet(CurveStretch const& stretch, double s)
{
    Jet j{0, 0, 0, 0, 0, 0};
    for (std::size_t k = stretch.terms; k-- > 0;) {
        j.x2 = j.x2 * s + j.x1;
        j.y2 = j.y2 * s + j.y1;
        j.x1 = j.x1 * s + j.x;
        j.y1 = j.y1 * s + j.y;
        j.x = j.x * s + stretch.x[k];
        j.y = j.y * s + stretch.y[k];
    }
    j.x2 *= 2;
    j.y2 *= 2;
    return j;
}

/// The share of the stretch at which the cubic through both ends, with their derivatives, falls through 0.
double root_of_cubic(double g0, double change0, double g1, double change1)
{
    double share = g0 / (g0 - g1);
    for (int i = 0; i < 2; ++i) {
        double const s = share, r = 1 - s;
        double const value = r * r * (g0 * (1 + 2 * s) + change0 * s) + s * s * (g1 * (1 + 2 * r) - change1 * r);
        double const slope = 6 * s * r * (g1 - g0) + change0 * r * (1 - 3 * s) + change1 * s * (3 * s - 2);
        double const next = slope < 0 ? s - value / slope : s;
        share = next > 0 && next < 1 ? next : s;
    }
    return share;
}

}  // namespace

std::vector<CurveStretch> stretches_of(profile::CurvePiece const& curve)
{
    Controls const at{curve.x(), curve.y()};
    Controls const slope = at.derivative();
    std::vector<CurveStretch> stretches;
    cut(stretches, curve, 0, 1, at, slope, slope.derivative());
    return stretches;
}

StretchFoot foot_on(CurveStretch const& stretch, Vec2 const& p)
{
    Vec2 const from_centre = p - stretch.centre;
    double const bound = stretch.bend.dot(from_centre) + stretch.bend.norm() * stretch.reach +
                         stretch.bend_reach * (from_centre.norm() + stretch.reach);
    if (!(bound < stretch.slowest))
        return {.certain = false};
    Vec2 const first = p - stretch.first, last = p - stretch.last;
    double const g0 = first.dot(stretch.slope_first), g1 = last.dot(stretch.slope_last);
    if (!(g0 > 0 && g1 <= 0))
        return {};
    double const width = stretch.to - stretch.from;
    double const change0 = width * (first.dot(stretch.bend_first) - stretch.slope_first.squaredNorm());
    double const change1 = width * (last.dot(stretch.bend_last) - stretch.slope_last.squaredNorm());
    double low = -1, high = 1;
    double s = 2 * root_of_cubic(g0, change0, g1, change1) - 1;
    // Newton doubles the digits: a step of the square root of a rounding is the last, and the point moves along with it
    // to second order
    constexpr double half_the_digits = 0x1p-27;
    constexpr int budget = 60;
    for (int i = 0;; ++i) {
        Jet const at = jet(stretch, s);
        double const away_x = p.x() - at.x, away_y = p.y() - at.y;
        double const g = away_x * at.x1 + away_y * at.y1;
        double const change = away_x * at.x2 + away_y * at.y2 - at.x1 * at.x1 - at.y1 * at.y1;
        (g > 0 ? low : high) = s;
        double next = s - g / change;
        if (!(next >= low && next <= high))
            next = 0.5 * (low + high);
        double const step = next - s;
        if (std::abs(step) <= half_the_digits || i == budget)
            return {true, true, Vec2(at.x + step * at.x1, at.y + step * at.y1),
                    left_of(Vec2(at.x1 + step * at.x2, at.y1 + step * at.y2)).normalized()};
        s = next;
    }
}

}  // namespace hdconj::distance
