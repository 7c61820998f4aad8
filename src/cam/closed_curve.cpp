// SPDX-License-Identifier: GPL-3.0-or-later
#include "closed_curve.hpp"

#include <numbers>

namespace hdconj::cam {

std::pair<std::vector<double>, std::vector<double>> whole_wave(std::vector<double> const& half, int waves)
{
    std::size_t const n = half.size() - 1;
    double const step = std::numbers::pi / waves / static_cast<double>(n);
    std::vector<double> angles, values;
    for (std::size_t i = 0; i < 2 * n; ++i) {
        angles.push_back(step * static_cast<double>(i));
        values.push_back(half[i <= n ? i : 2 * n - i]);
    }
    return {angles, values};
}

namespace {

wavegen::AnyWaveShape table_of(std::vector<double> const& half, int waves)
{
    auto const [angles, values] = whole_wave(half, waves);
    return wavegen::AnyWaveShape(wavegen::TableCam(angles, values, waves));
}

}  // namespace

ClosedCurve::ClosedCurve(CurveRule const& rule, int waves, std::vector<double> const& displacement)
    : rule_(rule),
      shape_(table_of(displacement, waves)),
      curve_(shape_, rule.r_m),
      linear_(shape_, rule.r_m, rule.tooth_ratio),
      r_0_(rule.exact ? curve_.r_0() : rule.r_m)
{
}

ClosedCurve::Place ClosedCurve::operator()(double x) const
{
    wavegen::RadialDisplacement const d = shape_(x);
    double const along = rule_.exact ? rule_.r_m * (curve_.phi(x) - x) : linear_.v(x);
    return {{r_0_ - rule_.r_m + d.w, along}, d.w1, d.w2};
}

double ClosedCurve::curvature(double x) const
{
    wavegen::RadialDisplacement const d = shape_(x);
    return CurveRule::curvature(r_0_ + d.w, d.w1, d.w2);
}

std::vector<Vec2> ClosedCurve::outline(int points, double inside) const
{
    std::vector<Vec2> outline;
    for (int i = 0; i < points; ++i) {
        double const u = 2 * std::numbers::pi * i / points;
        Place const at = (*this)(u);
        double const polar = rule_.exact ? u : u + at.state[1] / rule_.r_m;
        double const rho = rule_.r_m + at.state[0];
        double const normal = polar - (rule_.exact ? std::atan2(at.slope, rho) : at.slope / rule_.r_m);
        outline.push_back(rho * Vec2(std::sin(polar), std::cos(polar)) -
                          inside * Vec2(std::sin(normal), std::cos(normal)));
    }
    return outline;
}

std::optional<double> gap_at(FlankPair const& pair, CurveRule const& rule, double u, ClosedCurve::Place const& at)
{
    ToothOrigin const origin = rule.origin(u, at.state);
    double const theta = rule.theta(origin, at.slope);
    std::vector<Tangency> const found = pair.tangencies(origin, theta);
    if (found.empty())
        return std::nullopt;
    return (found.front().theta - theta) * found.front().lever;
}

}  // namespace hdconj::cam
