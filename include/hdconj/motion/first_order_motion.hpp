// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' first-order motion, explicit in the undeformed angle.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/numeric/periodic_integral.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::motion {

/// First-order motion of the thesis, (2-16), (2-17), (2-19), with parameter phi and k = z_f/z_c. Let v be -integral of
/// w less its mean; the mean is of second order, and v is then periodic.
///   rho = r_m + w(phi),   phi_1 = phi + v/r_m,   gamma = phi_1 - k phi
///   mu = (v - w')/r_m,    theta = (1 - k) phi + mu
/// The normal is turned by mu against the undeformed radius.
///
/// For the cosine cam mu = (n - 1/n) w0 sin(n phi)/r_m, the 1.5 of (2-16) for n = 2. The printed (2-15) is the angle
/// against the deformed radius, w'/r_m = gamma - theta here; the two must not be mixed. Accuracy: as a model of the
/// inextensible curve, an error of order w0^2/r_m; as arithmetic, a few roundings of r_m.
template <wavegen::WaveShape Shape>
class FirstOrderMotion
{
  public:
    FirstOrderMotion(Shape shape, double r_m, double tooth_ratio)
        : shape_(std::move(shape)),
          r_m_(r_m),
          k_(tooth_ratio),
          w_([this](double phi) { return shape_(phi).w; }, 2 * std::numbers::pi / shape_.waves(), shape_.breaks()),
          mean_(negligible_or(w_.mean()))
    {
        if (!w_.resolved())
            throw NumericalError(ErrorCode::not_smooth, "motion", "tangential displacement",
                                 "the wave generator's shape is not smooth enough to be integrated");
    }

    [[nodiscard]] Shape const& shape() const { return shape_; }
    [[nodiscard]] double half_lobe() const { return std::numbers::pi / shape_.waves(); }
    [[nodiscard]] std::span<double const> breaks() const { return shape_.breaks(); }
    [[nodiscard]] bool symmetric() const { return shape_.even(); }

    /// Tangential displacement of the point at @p phi [mm]; periodic, since w has no mean here.
    [[nodiscard]] double v(double phi) const { return v(phi, shape_(phi)); }

    [[nodiscard]] Pose pose(double phi) const
    {
        wavegen::RadialDisplacement const d = shape_(phi);
        double const gamma = (1 - k_) * phi + v(phi, d) / r_m_;
        double const theta = gamma - d.w1 / r_m_;
        double const rho = r_m_ + d.w;
        return {std::cos(theta), std::sin(theta), {rho * std::sin(gamma), rho * std::cos(gamma)}};
    }

    [[nodiscard]] MotionRates rates(double phi) const
    {
        wavegen::RadialDisplacement const d = shape_(phi);
        double const w = d.w - mean_;
        double const rho = r_m_ + d.w;
        double const tilt = d.w1 / r_m_;  // gamma - theta
        double const tilt1 = d.w2 / r_m_;
        double const gamma1 = 1 - k_ - w / r_m_;
        double const gamma2 = -d.w1 / r_m_;
        double const g = rho * gamma1;
        double const g1 = d.w1 * gamma1 + rho * gamma2;
        double const s = std::sin(tilt);
        double const c = std::cos(tilt);
        Vec2 const q{d.w1 * s + g * c, d.w1 * c - g * s};
        return {{gamma1 - tilt1, q},
                {gamma2 - d.w3 / r_m_, {d.w2 * s + g1 * c + q.y() * tilt1, d.w2 * c - g1 * s - q.x() * tilt1}},
                1 + k_ + (std::abs(w) + std::abs(d.w2)) / r_m_,
                rho * (1 + k_) + std::abs(d.w1),
                (std::abs(d.w1) + std::abs(d.w3)) / r_m_,
                std::abs(d.w2) + std::abs(d.w1) * (2 + k_) + (rho * (1 + k_) + std::abs(d.w1)) * std::abs(tilt1)};
    }

    [[nodiscard]] ToothAngles angles(double phi) const { return {phi + v(phi) / r_m_, phi}; }

  private:
    [[nodiscard]] double v(double phi, wavegen::RadialDisplacement const& d) const
    {
        return mean_ * phi - w_(phi, d.sine, d.cosine);
    }

    /// What is left of a mean that is 0 by its formula is rounding, and would spoil exact symmetry.
    [[nodiscard]] double negligible_or(double mean) const
    {
        return std::abs(mean) <= 8 * unit_roundoff * shape_.amplitude() ? 0.0 : mean;
    }

    Shape shape_;
    double r_m_;
    double k_;
    numeric::PeriodicIntegral w_;
    double mean_;
};

}  // namespace hdconj::motion
