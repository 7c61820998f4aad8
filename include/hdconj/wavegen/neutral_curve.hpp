// SPDX-License-Identifier: GPL-3.0-or-later
// The deformed neutral curve: rho(u) = r_0 + w(u), as long as the undeformed circle of radius r_m.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/numeric/periodic_integral.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// Closed inextensible neutral curve.
///
/// The length over one turn fixes r_0, and the arc length gives the undeformed angle of a point:
///   integral_0^{2 pi} sqrt(rho^2 + rho'^2) du = 2 pi r_m
///   phi(u) = (1/r_m) integral_0^u sqrt(rho^2 + rho'^2) du
/// This is (2-18) of the thesis without its first-order approximation. The line element is integrated as a Fourier
/// series, or panel by panel where the shape has breaks. Accuracy: relative error below 1e-14. Domain: rho > 0
/// everywhere.
/// @throws NumericalError otherwise, or when the line element is not resolved to roundoff.
template <WaveShape Shape>
class NeutralCurve
{
  public:
    NeutralCurve(Shape shape, double r_m)
        : shape_(std::move(shape)), r_m_(r_m), r_0_(closed_radius()), line_(series(r_0_))
    {
        if (!line_.resolved())
            throw NumericalError(ErrorCode::not_smooth, "neutral curve", "arc length",
                                 "the wave generator's shape is not smooth enough for its series");
    }

    [[nodiscard]] Shape const& shape() const { return shape_; }
    [[nodiscard]] double r_m() const { return r_m_; }
    [[nodiscard]] double r_0() const { return r_0_; }
    [[nodiscard]] double relative_error() const { return line_.relative_error(); }
    /// Integral of the line element from 0: r_m phi.
    [[nodiscard]] numeric::PeriodicIntegral const& length() const { return line_; }

    /// Undeformed angle phi of the point at polar angle @p u, phi(0) = 0. @p d is shape()(u).
    [[nodiscard]] double phi(double u, RadialDisplacement const& d) const { return line_(u, d.sine, d.cosine) / r_m_; }
    [[nodiscard]] double phi(double u) const { return phi(u, shape_(u)); }

  private:
    [[nodiscard]] numeric::PeriodicIntegral series(double r_0) const
    {
        auto const element = [&](double u) {
            RadialDisplacement const d = shape_(u);
            return std::hypot(r_0 + d.w, d.w1);
        };
        return numeric::PeriodicIntegral(element, 2 * std::numbers::pi / shape_.waves(), shape_.breaks());
    }

    /// Newton on mean length: its slope with respect to r_0 is the mean of rho / sqrt(rho^2 + rho'^2), close to 1.
    [[nodiscard]] double closed_radius() const
    {
        if (!(r_m_ > shape_.amplitude()))
            throw NumericalError(ErrorCode::no_solution, "neutral curve", "radial deformation",
                                 "is not smaller than the neutral radius");
        constexpr int budget = 60;
        double r_0 = r_m_;
        double last_step = r_m_;
        for (int i = 0; i < budget; ++i) {
            double const excess = series(r_0).mean() - r_m_;
            double const h = r_m_ * slope_step;
            double const slope = (series(r_0 + h).mean() - series(r_0 - h).mean()) / (2 * h);
            double const step = excess / slope;
            r_0 -= step;
            if (!(r_0 > shape_.amplitude()))
                throw NumericalError(ErrorCode::no_solution, "neutral curve", "closed length",
                                     "no base radius closes a curve that is deformed this much");
            if (std::abs(step) <= 4 * unit_roundoff * r_m_ ||
                (std::abs(step) >= std::abs(last_step) && std::abs(step) < noise * r_m_))
                return r_0;
            last_step = step;
        }
        throw NumericalError(ErrorCode::not_converged, "neutral curve", "closed length",
                             "the base radius did not converge");
    }

    static constexpr double slope_step = 0x1p-12;
    static constexpr double noise = 64 * unit_roundoff;

    Shape shape_;
    double r_m_;
    double r_0_;
    numeric::PeriodicIntegral line_;
};

}  // namespace hdconj::wavegen
