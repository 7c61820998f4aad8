// SPDX-License-Identifier: GPL-3.0-or-later
// Wave generator "ellipse": the neutral curve is an ellipse.
#pragma once

#include <cmath>

#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// Neutral curve rho(u) = a b / sqrt(a^2 sin^2 u + b^2 cos^2 u) with a = r_m + w0. The circumference is 2 pi r_m
/// exactly, and this fixes b: 4 a E(sqrt(1 - b^2/a^2)) = 2 pi r_m. Yao et al. 2025 approximate this b by Ramanujan's
/// formula. The displacement is measured from r_m: w = rho - r_m.
///
/// Derivatives: with g = a^2 sin^2 u + b^2 cos^2 u, rho' = -rho g'/(2 g), and so on. Domain: 0 < w0 < (pi/2 - 1) r_m,
/// where b reaches 0; two waves. Accuracy: a few roundings of r_m; b to 2 units in its last place.
class EllipseCam
{
  public:
    EllipseCam() = default;
    EllipseCam(double w0, double r_m);

    [[nodiscard]] int waves() const { return 2; }
    [[nodiscard]] double amplitude() const { return w0_; }
    [[nodiscard]] bool even() const { return true; }
    [[nodiscard]] std::span<double const> breaks() const { return {}; }
    [[nodiscard]] double minor_semi_axis() const { return b_; }

    [[nodiscard]] RadialDisplacement operator()(double u) const
    {
        double const s = std::sin(2 * u);
        double const c = std::cos(2 * u);
        double const sin_u = std::sin(u);
        double const half = 0.5 * (a_ * a_ - b_ * b_);
        double const g = b_ * b_ + 2 * half * sin_u * sin_u;
        double const rho = a_ * b_ / std::sqrt(g);
        double const p1 = -half * s / g;      // -g'/(2 g), g' = (a^2 - b^2) sin 2u
        double const p2 = -2 * half * c / g;  // -g''/(2 g)
        double const p3 = 4 * half * s / g;   // -g'''/(2 g)
        // rho'/rho = p1, p1' = p2 + 2 p1^2, p2' = p3 + 2 p1 p2
        double const p1_u = p2 + 2 * p1 * p1;
        double const rho1 = rho * p1;
        double const rho2 = rho1 * p1 + rho * p1_u;
        double const p1_uu = p3 + 2 * p1 * p2 + 4 * p1 * p1_u;
        double const rho3 = rho2 * p1 + 2 * rho1 * p1_u + rho * p1_uu;
        // w without the cancellation of rho - r_m: rho = a sqrt(b^2/g), a = r_m + w0
        double const drop = -2 * half * sin_u * sin_u / (g + b_ * std::sqrt(g));  // sqrt(b^2/g) - 1
        return {w0_ + a_ * drop, rho1, rho2, rho3, s, c};
    }

    [[nodiscard]] static scene::FamilyDescription describe()
    {
        return {
            "ellipse", "elliptic neutral curve, semi-axis r_m + w0, as long as the ring", {radial_deformation_key()}};
    }

    [[nodiscard]] static EllipseCam build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place,
                                          Faults& faults);

  private:
    double w0_ = 0;
    double a_ = 1;
    double b_ = 1;
};

}  // namespace hdconj::wavegen
