// SPDX-License-Identifier: GPL-3.0-or-later
// Material motion: the displacement of each point of the ring is given, the tooth stands on the displaced curve's
// normal.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wavegen/material_displacement.hpp"

namespace hdconj::motion {

/// Material motion with parameter phi, the undeformed angle, of the point P = R e_r + v e_t, R = r_m + w(phi)
/// (docs/explanation/theory.md, section 1).
///
/// P' = A e_r + B e_t with A = w' - v, B = R + v'; S = sqrt(A^2 + B^2). The normal is tilted against e_r by atan2(A,
/// B). With k = z_f/z_c the frame of the circular spline has turned by k phi, and there
///
///   gamma = (1 - k) phi,   theta = gamma - tilt,   origin R (sin gamma, cos gamma) + v (cos gamma, -sin gamma)
///
///   theta' = 1 - k - (A' B - A B')/S^2,   q_x = S + k (A v - B R)/S,   q_y = k (B v + A R)/S
///
/// This follows from q = R^T P' with A/S and B/S for sine and cosine of the tilt. The displacement may stretch the
/// curve or not. Domain: R > 0 and B > 0 for every phi, so that the curve goes round the axis and does not fold back.
/// Accuracy: pose to a few roundings of r_m; q_x loses the two digits of S - k B R/S ~ r_m (1 - k).
class MaterialMotion
{
  public:
    /// @param r_m          radius of the undeformed neutral curve [mm]
    /// @param tooth_ratio  z_f/z_c
    /// @throws NumericalError outside the domain, or so near its limit that it cannot be told
    MaterialMotion(wavegen::MaterialDisplacement displacement, double r_m, double tooth_ratio)
        : displacement_(std::move(displacement)),
          r_m_(r_m),
          k_(tooth_ratio),
          bound_(wavegen::displacement_bounds(displacement_)),
          symmetric_(wavegen::is_symmetric(displacement_))
    {
        require_graph();
    }

    [[nodiscard]] wavegen::MaterialDisplacement const& displacement() const { return displacement_; }
    [[nodiscard]] double half_lobe() const { return std::numbers::pi / displacement_.waves; }
    [[nodiscard]] static std::span<double const> breaks() { return {}; }
    [[nodiscard]] bool symmetric() const { return symmetric_; }

    [[nodiscard]] Pose pose(double phi) const { return pose_of(displacement_at(phi), phi); }
    [[nodiscard]] MotionRates rates(double phi) const { return rates_of(displacement_at(phi)); }
    [[nodiscard]] MotionState state(double phi) const
    {
        wavegen::PointDisplacement const at = displacement_at(phi);
        return {pose_of(at, phi), rates_of(at)};
    }

    [[nodiscard]] ToothAngles angles(double phi) const
    {
        wavegen::PointDisplacement const at = displacement_at(phi);
        return {phi + std::atan2(at.v[0], r_m_ + at.w[0]), phi};
    }

  private:
    [[nodiscard]] wavegen::PointDisplacement displacement_at(double phi) const
    {
        return symmetric_ ? wavegen::symmetric_displacement_at(displacement_, phi)
                          : wavegen::displacement_at(displacement_, phi);
    }

    [[nodiscard]] Pose pose_of(wavegen::PointDisplacement const& at, double phi) const
    {
        auto const& [w, v] = at;
        double const radius = r_m_ + w[0];
        double const a = w[1] - v[0];
        double const b = radius + v[1];
        double const length = std::hypot(a, b);
        double const s = std::sin((1 - k_) * phi);
        double const c = std::cos((1 - k_) * phi);
        return {(c * b + s * a) / length, (s * b - c * a) / length, {radius * s + v[0] * c, radius * c - v[0] * s}};
    }

    [[nodiscard]] MotionRates rates_of(wavegen::PointDisplacement const& at) const
    {
        auto const& [w, v] = at;
        double const radius = r_m_ + w[0];
        double const a = w[1] - v[0], a1 = w[2] - v[1], a2 = w[3] - v[2];
        double const b = radius + v[1], b1 = w[1] + v[2], b2 = w[2] + v[3];
        double const s2 = a * a + b * b;
        double const s = std::sqrt(s2);
        double const s1 = (a * a1 + b * b1) / s;
        double const bend = a1 * b - a * b1;
        double const bend1 = a2 * b - a * b2;
        double const x = (a * v[0] - b * radius) / s;
        double const y = (b * v[0] + a * radius) / s;
        double const x1 = (a1 * v[0] + a * v[1] - b1 * radius - b * w[1] - x * s1) / s;
        double const y1 = (b1 * v[0] + b * v[1] + a1 * radius + a * w[1] - y * s1) / s;
        MotionRates rates{{1 - k_ - bend / s2, {s + k_ * x, k_ * y}},
                          {2 * bend * s1 / (s2 * s) - bend1 / s2, {s1 + k_ * x1, k_ * y1}}};
        set_sizes(rates, radius, b, s);
        return rates;
    }

    /// Sizes of the terms, each factor that may vanish by its bound.
    void set_sizes(MotionRates& rates, double radius, double b, double s) const
    {
        auto const& [w, v] = bound_;
        double const a = w[1] + v[0], a1 = w[2] + v[1], a2 = w[3] + v[2];
        double const b1 = w[1] + v[2], b2 = w[2] + v[3];
        double const s1 = (a * a1 + b * b1) / s;
        double const bend = (a1 * b + a * b1) / (s * s);
        double const arm = (a + b) * (v[0] + radius) / s;
        rates.omega_size = 1 + k_ + bend;
        rates.q_size = s + k_ * arm;
        rates.omega_change_size = (a2 * b + a * b2) / (s * s) + 2 * bend * s1 / s;
        rates.q_change_size = s1 + k_ * ((a1 + b1) * (v[0] + radius) + (a + b) * (v[1] + w[1]) + arm * s1) / s;
    }

    /// R and B between two samples differ from the nearer one by no more than their largest slopes allow.
    void require_graph() const
    {
        constexpr int fewest = 64, most = 1 << 16;
        double const steepest = bound_.w[1] + bound_.v[2];
        // most displacements are so small against the ring that none of their values has to be looked at
        if (r_m_ - bound_.w[0] - bound_.v[1] > steepest * half_lobe() / most)
            return;
        for (int points = fewest; points <= most; points *= 2) {
            double least = r_m_;
            for (int i = 0; i < points; ++i) {
                double const phi = half_lobe() * (2.0 * i / points - 1);
                wavegen::PointDisplacement const at = displacement_at(phi);
                least = std::min(least, r_m_ + at.w[0] + std::min(0.0, at.v[1]));
                // a NaN too is outside
                if (!(r_m_ + at.w[0] > 0 && r_m_ + at.w[0] + at.v[1] > 0))
                    throw NumericalError(ErrorCode::no_solution, "motion",
                                         "displacement at phi = " + std::to_string(phi * per_deg) + " deg",
                                         "the displaced neutral curve folds back or reaches the axis",
                                         "make the displacement smaller");
            }
            if (least > steepest * half_lobe() / points)
                return;
        }
        throw NumericalError(ErrorCode::no_solution, "motion", "displacement of the neutral curve",
                             "cannot be told from one that folds back or reaches the axis",
                             "make the displacement smaller or smoother");
    }

    wavegen::MaterialDisplacement displacement_;
    double r_m_;
    double k_;
    wavegen::PointDisplacement bound_;
    bool symmetric_;
};

}  // namespace hdconj::motion
