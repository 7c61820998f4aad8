// SPDX-License-Identifier: GPL-3.0-or-later
// Wave generator "four-roller": a ring under point forces from pairs of rollers.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// Thin inextensible ring under radial forces at +-beta about each of its n ends of the major axis (n = 2: four
/// rollers; beta = 0: two).
///
/// Let G be the ring under one force a wave, G(x) = sum_{k = n, 2n, ...} cos(k x)/(k^2 - 1)^2. Then
///   w(u) = w0 S(u)/S(0),   S(u) = (G(u - beta) + G(u + beta))/2.
/// With h = pi/n and y = (x mod 2h) - h the sum is
///   G = -1/2 + E ((1 + h cot h) cos y + y sin y),   E = h/(4 sin h),
/// the periodic solution of (D^2 + 1)^2 G = (pi/n) delta - 1/2. For n = 2, beta = 0: w(90 deg)/w0 = -0.91828, the ring
/// under two opposite forces. The mean of w is 0 to first order. w''' jumps at the forces: these are the breaks.
/// The largest w is w0, at u = 0, where G''(beta) < 0: up to beta = 40.70 deg for n = 2 and 26.18 deg for n = 3. With
/// rollers farther apart the ring sinks in between them.
/// Domain: n >= 2 (one force moves a ring as a whole), beta >= 0, G''(beta) < 0. Accuracy: a few roundings of w0.
class FourRoller
{
  public:
    FourRoller() = default;
    FourRoller(double w0, double beta, int n);

    [[nodiscard]] int waves() const { return n_; }
    [[nodiscard]] double amplitude() const { return w0_; }
    [[nodiscard]] bool even() const { return true; }
    [[nodiscard]] std::span<double const> breaks() const { return {breaks_.data(), beta_ > 0 ? 2u : 1u}; }

    [[nodiscard]] RadialDisplacement operator()(double u) const
    {
        RadialDisplacement const a = one_force(u - beta_);
        RadialDisplacement const b = one_force(u + beta_);
        double const f = 0.5 * scale_;
        return {f * (a.w + b.w), f * (a.w1 + b.w1), f * (a.w2 + b.w2), f * (a.w3 + b.w3)};
    }

    [[nodiscard]] static scene::FamilyDescription describe()
    {
        return {"four-roller",
                "ring under four roller forces (n = 2), w from ring theory",
                {radial_deformation_key(),
                 {"roller_angle_deg", scene::Quantity::angle_deg,
                  "rollers this far on either side of the major axis, beta; 0: two rollers", true, 0, 90}}};
    }

    [[nodiscard]] static FourRoller build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place,
                                          Faults& faults);

  private:
    /// Whether w has its maximum at u = 0: G bends outwards up to a place on either side of a force and inwards from
    /// there on, so that S, which is even, is largest at 0 where G''(beta) < 0, and nowhere else.
    [[nodiscard]] bool is_largest_on_axis() const;

    /// G and its derivatives.
    [[nodiscard]] RadialDisplacement one_force(double x) const
    {
        double const period = 2 * h_;
        // x = 0 belongs to the side of larger u, and just below it rounding may give y = h: the side of smaller u
        double const y = x - period * std::floor(x / period) - h_;
        double const s = std::sin(y);
        double const c = std::cos(y);
        return {-0.5 + e_ * (bend_ * c + y * s), e_ * (s * (1 - bend_) + y * c), e_ * (c * (2 - bend_) - y * s),
                e_ * (s * (bend_ - 3) - y * c)};
    }

    double w0_ = 0;
    double beta_ = 0;
    int n_ = 2;
    double h_ = std::numbers::pi / 2;
    double e_ = 0;      ///< E
    double bend_ = 1;   ///< 1 + h cot h
    double scale_ = 0;  ///< w0 / S(0)
    std::array<double, 2> breaks_{};
};

}  // namespace hdconj::wavegen
