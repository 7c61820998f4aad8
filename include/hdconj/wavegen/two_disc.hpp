// SPDX-License-Identifier: GPL-3.0-or-later
// Wave generator "two-disc": the ring lies on eccentric discs and is free between them.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// n discs (n = 2: the two-disc generator), each touched by the ring over the wrap angle beta on either side of the
/// major axis.
///
/// On a disc, |u| <= beta, the neutral curve is exactly a circle of radius R about a centre at distance e from the
/// axis:
///   rho(u) = e cos u + sqrt(R^2 - e^2 sin^2 u),  e + R = r_m + w0.
/// Between the discs the ring carries no load. Its bending moment goes as c + d cos y, y = u - pi/n, and ring theory
/// gives
///   rho(u) = C + A cos y + D y sin y.
/// C, A, D make rho, rho' and rho'' (position, tangent, bending moment) continuous at beta; R makes the curve as long
/// as the ring, 2 pi r_m. The disc presses with a line force at beta: w''' jumps there, which makes +-beta the breaks.
/// Domain: n >= 2, 0 < beta < pi/n, w0 small against r_m. The displacement is measured from r_m. Accuracy: a few
/// roundings of r_m; as a model, the free part is that of a thin ring to first order in w0/r_m.
class TwoDisc
{
  public:
    TwoDisc() = default;
    /// @throws NumericalError when no disc radius closes the curve
    TwoDisc(double w0, double beta, int n, double r_m);

    [[nodiscard]] int waves() const { return n_; }
    [[nodiscard]] double amplitude() const { return w0_; }
    [[nodiscard]] bool even() const { return true; }
    [[nodiscard]] std::span<double const> breaks() const { return breaks_; }
    [[nodiscard]] double disc_radius() const { return disc_; }  ///< R, of the neutral curve on the disc
    [[nodiscard]] double eccentricity() const { return eccentricity_; }

    [[nodiscard]] RadialDisplacement operator()(double u) const
    {
        double const h = std::numbers::pi / n_;
        double const v = u < -h || u > h ? u - 2 * h * std::round(u / (2 * h)) : u;
        RadialDisplacement d = v >= breaks_[0] && v < breaks_[1] ? on_disc(v) : between(v > 0 ? v - h : v + h);
        d.w -= r_m_;
        return d;
    }

    [[nodiscard]] static scene::FamilyDescription describe()
    {
        return {"two-disc",
                "ring on two eccentric discs (n = 2), free between them",
                {radial_deformation_key(),
                 {"wrap_angle_deg", scene::Quantity::angle_deg,
                  "the ring touches a disc this far on either side of the major axis, beta", true, 0.1, 89}}};
    }

    [[nodiscard]] static TwoDisc build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place,
                                       Faults& faults);

  private:
    [[nodiscard]] RadialDisplacement on_disc(double u) const
    {
        double const s = std::sin(u);
        double const c = std::cos(u);
        double const e = eccentricity_;
        double const root = std::sqrt((disc_ - e * s) * (disc_ + e * s));
        // r^2 = R^2 - e^2 sin^2 u: r r' = -e^2 s c, and twice more
        double const r1 = -e * e * s * c / root;
        double const r2 = (-e * e * (c - s) * (c + s) - r1 * r1) / root;
        double const r3 = (4 * e * e * s * c - 3 * r1 * r2) / root;
        return {e * c + root, -e * s + r1, -e * c + r2, e * s + r3};
    }

    [[nodiscard]] RadialDisplacement between(double y) const
    {
        double const s = std::sin(y);
        double const c = std::cos(y);
        return {c_ + a_ * c + d_ * y * s, -a_ * s + d_ * (s + y * c), -a_ * c + d_ * (2 * c - y * s),
                a_ * s - d_ * (3 * s + y * c)};
    }

    void fit(double disc);
    [[nodiscard]] double mean_length() const;

    double w0_ = 0;
    int n_ = 2;
    double r_m_ = 1;
    double disc_ = 1, eccentricity_ = 0;
    double c_ = 1, a_ = 0, d_ = 0;
    std::array<double, 2> breaks_{-0.5, 0.5};
};

}  // namespace hdconj::wavegen
