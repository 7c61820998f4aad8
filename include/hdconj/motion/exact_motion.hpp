// SPDX-License-Identifier: GPL-3.0-or-later
// Exact motion: the neutral curve does not stretch, the tooth stands on its normal.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/wavegen/neutral_curve.hpp"

namespace hdconj::motion {

/// Exact motion with parameter u, the polar angle on the deformed neutral curve (docs/explanation/theory.md, section
/// 1):
///   gamma = u - (z_f/z_c) phi(u),   theta = gamma - atan(rho'/rho),   origin rho (sin gamma, cos gamma)
///
/// With S = sqrt(rho^2 + rho'^2) and k = z_f/z_c the velocity needs neither arc length nor sines of gamma:
///   theta' = 1 - k S/r_m - (rho rho'' - rho'^2)/S^2,
///   q_x = S - k rho^2/r_m,   q_y = k rho rho'/r_m.
///
/// This follows from q = R^T P' with sin(gamma - theta) = rho'/S, cos(gamma - theta) = rho/S, phi' = S/r_m. Accuracy:
/// pose to a few roundings of r_m; q_x loses the two digits of S - k rho^2/r_m ~ r_m (1 - k).
template <wavegen::WaveShape Shape>
class ExactMotion
{
  public:
    ExactMotion(wavegen::NeutralCurve<Shape> curve, double tooth_ratio) : curve_(std::move(curve)), k_(tooth_ratio) {}

    [[nodiscard]] wavegen::NeutralCurve<Shape> const& curve() const { return curve_; }
    [[nodiscard]] double tooth_ratio() const { return k_; }
    [[nodiscard]] double half_lobe() const { return std::numbers::pi / curve_.shape().waves(); }
    [[nodiscard]] std::span<double const> breaks() const { return curve_.shape().breaks(); }
    [[nodiscard]] bool symmetric() const { return curve_.shape().even(); }

    [[nodiscard]] Pose pose(double u) const { return pose(u, curve_.shape()(u)); }
    [[nodiscard]] MotionRates rates(double u) const { return rates(curve_.shape()(u)); }
    /// Both, from one evaluation of the wave.
    [[nodiscard]] MotionState state(double u) const
    {
        wavegen::RadialDisplacement const d = curve_.shape()(u);
        return {pose(u, d), rates(d)};
    }

    [[nodiscard]] ToothAngles angles(double u) const { return {u, curve_.phi(u)}; }

  private:
    [[nodiscard]] Pose pose(double u, wavegen::RadialDisplacement const& d) const
    {
        double const rho = curve_.r_0() + d.w;
        double const gamma = u - k_ * curve_.phi(u, d);
        double const s = std::sin(gamma);
        double const c = std::cos(gamma);
        double const length = std::sqrt(rho * rho + d.w1 * d.w1);
        double const cos_tilt = rho / length;
        double const sin_tilt = d.w1 / length;
        return {c * cos_tilt + s * sin_tilt, s * cos_tilt - c * sin_tilt, {rho * s, rho * c}};
    }

    [[nodiscard]] MotionRates rates(wavegen::RadialDisplacement const& d) const
    {
        double const rho = curve_.r_0() + d.w;
        double const k = k_ / curve_.r_m();
        double const s2 = rho * rho + d.w1 * d.w1;
        double const s = std::sqrt(s2);
        double const s1 = d.w1 * (rho + d.w2) / s;
        double const bend = rho * d.w2 - d.w1 * d.w1;
        double const bend1 = rho * d.w3 - d.w1 * d.w2;
        double const w1 = std::abs(d.w1);
        return {{1 - k * s - bend / s2, {s - k * rho * rho, k * rho * d.w1}},
                {-k * s1 - bend1 / s2 + 2 * bend * s1 / (s2 * s),
                 {s1 - 2 * k * rho * d.w1, k * (d.w1 * d.w1 + rho * d.w2)}},
                1 + k * s + std::abs(bend) / s2,
                s + k * rho * rho + k * rho * w1,
                k * std::abs(s1) + std::abs(bend1) / s2 + 2 * std::abs(bend * s1) / (s2 * s),
                std::abs(s1) + 2 * k * rho * w1 + k * (d.w1 * d.w1 + rho * std::abs(d.w2))};
    }

    wavegen::NeutralCurve<Shape> curve_;
    double k_;  ///< z_f / z_c
};

}  // namespace hdconj::motion
