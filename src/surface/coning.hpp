// SPDX-License-Identifier: GPL-3.0-or-later
// Coning "linear": the inextensional mode of a cup whose wall stays straight along the axis.
#pragma once

#include <cmath>
#include <numbers>

#include "hdconj/error.hpp"
#include "hdconj/numeric/periodic_integral.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::surface {

/// Amplitude along the axis, w(phi, z) = f(z) w(phi), f(z) = (z - z_a)/(0 - z_a): 1 in the middle of the bearing, 0 at
/// the apex (design 3.4; Rayleigh's inextensional mode).
struct ConingMode
{
    double apex = 0;  ///< z_a < 0 [mm]

    /// f(z). Domain: z > z_a; a slice behind the apex would be deformed the other way round.
    [[nodiscard]] double factor(double z) const { return z == 0 ? 1.0 : (z - apex) / -apex; }
    /// df/dz [1/mm].
    [[nodiscard]] double slope() const { return -1 / apex; }
};

/// The apex lies `apex_height` above the cup's bottom, which is `bottom_to_middle` behind z = 0.
[[nodiscard]] inline ConingMode coning_mode(Coning const& coning)
{
    return {coning.apex_height - coning.bottom_to_middle.value_or(0)};
}

/// Axial displacement and its derivative of one point of the wall.
struct AxialDisplacement
{
    double u_z = 0;    ///< [mm], positive towards the open end
    double slope = 0;  ///< du_z/dphi [mm/rad]
};

/// Axial displacement of the same mode: no shear between axis and circumference, dv/dz + (1/r) du_z/dphi = 0 with
/// v = -f(z) V(phi), V the integral of w less its mean, so du_z/dphi = r f' V(phi), and u_z has no mean.
/// For the cosine cam u_z = -(r f' w0/n^2) cos(n phi): -0.18 mm at the major axis of type-50.
/// Accuracy: that of PeriodicIntegral. @p Shape as in FirstOrderMotion: the first order of the mode.
template <wavegen::WaveShape Shape>
class LinearAxialShift
{
  public:
    /// @param r  radius of the undeformed neutral curve [mm]
    LinearAxialShift(Shape const& shape, double r, ConingMode const& mode)
        : shape_(shape),
          strength_(r * mode.slope()),
          period_(2 * std::numbers::pi / shape.waves()),
          w_([this](double phi) { return shape_(phi).w; }, period_, shape.breaks()),
          v_([this](double phi) { return integral_of_w(phi); }, period_, shape.breaks()),
          level_(numeric::PeriodicIntegral([this](double phi) { return double_integral(phi); }, period_, shape.breaks())
                     .mean())
    {
        if (!w_.resolved() || !v_.resolved())
            throw NumericalError(ErrorCode::not_smooth, "coning", "axial displacement",
                                 "the wave generator's shape is not smooth enough to be integrated");
    }

    [[nodiscard]] AxialDisplacement operator()(double phi) const
    {
        return {strength_ * (double_integral(phi) - level_), strength_ * (integral_of_w(phi) - v_.mean())};
    }

  private:
    [[nodiscard]] double integrate(numeric::PeriodicIntegral const& f, double phi) const
    {
        double const x = 2 * std::numbers::pi / period_ * phi;
        return f(phi, std::sin(x), std::cos(x)) - f.mean() * phi;
    }
    [[nodiscard]] double integral_of_w(double phi) const { return integrate(w_, phi); }
    [[nodiscard]] double double_integral(double phi) const { return integrate(v_, phi); }

    Shape shape_;
    double strength_;
    double period_;
    numeric::PeriodicIntegral w_;
    numeric::PeriodicIntegral v_;
    double level_;
};

}  // namespace hdconj::surface
