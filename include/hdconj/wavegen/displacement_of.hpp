// SPDX-License-Identifier: GPL-3.0-or-later
// The exact inextensible deformation as a displacement of material points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "hdconj/error.hpp"
#include "hdconj/numeric/fourier.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "hdconj/wavegen/neutral_curve.hpp"

namespace hdconj::wavegen {

/// d = u - phi of the point of @p curve whose undeformed angle is @p phi, by Newton: dphi/du = sqrt(rho^2 +
/// rho'^2)/r_m.
template <WaveShape Shape>
[[nodiscard]] double angle_gained(NeutralCurve<Shape> const& curve, double phi)
{
    constexpr int budget = 60;
    double u = phi;
    double last_step = std::numeric_limits<double>::infinity();
    for (int i = 0; i < budget; ++i) {
        RadialDisplacement const d = curve.shape()(u);
        double const step = (curve.phi(u, d) - phi) * curve.r_m() / std::hypot(curve.r_0() + d.w, d.w1);
        // steps that no longer fall are the rounding of phi(u)
        if (std::abs(step) >= last_step && last_step <= 16 * unit_roundoff * std::numbers::pi)
            return u - phi;
        u -= step;
        last_step = std::abs(step);
        if (step == 0)
            return u - phi;
    }
    throw NumericalError(ErrorCode::not_converged, "neutral curve", "point at phi = " + std::to_string(phi),
                         "its polar angle did not converge");
}

/// w and v of @p curve. The point rho(u) e_r(u), rho = r_0 + w_u(u), that stood at phi(u) has with d = u - phi
///
///   w = r_0 - r_m + w_u - 2 rho sin^2(d/2),   v = rho sin d.
///
/// A MaterialMotion of it is the ExactMotion of the curve, with phi for parameter.
///
/// Accuracy: coefficients to some roundings of r_m (those of phi(u)), and below them 0. A derivative of order j has the
/// error of the last coefficient times the j-th power of its order. Domain: shapes without breaks.
/// @throws NumericalError otherwise, or when a series is not resolved.
template <WaveShape Shape>
[[nodiscard]] MaterialDisplacement displacement_of(NeutralCurve<Shape> const& curve)
{
    Shape const& shape = curve.shape();
    if (!shape.breaks().empty())
        throw NumericalError(ErrorCode::not_smooth, "neutral curve", "series in the undeformed angle",
                             "the wave generator's third derivative jumps, which a series does not follow");
    double const period = 2 * std::numbers::pi / shape.waves();
    numeric::FourierSeries const w(
        [&](double phi) {
            double const d = angle_gained(curve, phi);
            double const displaced = shape(phi + d).w;
            double const half = std::sin(d / 2);
            return curve.r_0() - curve.r_m() + displaced - 2 * (curve.r_0() + displaced) * half * half;
        },
        period);
    // on top of r_m, whose roundings v has
    numeric::FourierSeries const v(
        [&](double phi) {
            double const d = angle_gained(curve, phi);
            return curve.r_m() + (curve.r_0() + shape(phi + d).w) * std::sin(d);
        },
        period);
    if (!w.resolved() || !v.resolved())
        throw NumericalError(ErrorCode::not_smooth, "neutral curve", "series in the undeformed angle",
                             "the wave generator's shape is not smooth enough for it");
    auto const above = [](double noise, double coefficient) {
        return std::abs(coefficient) > noise ? coefficient : 0.0;
    };
    MaterialDisplacement result{shape.waves(), {}};
    for (std::size_t k = 0; k < std::max(w.terms(), v.terms()); ++k) {
        double const v_cosine = v.cosine(k) - (k == 0 ? curve.r_m() : 0);
        DisplacementHarmonic h{above(w.noise(), w.cosine(k)), above(w.noise(), w.sine(k)), above(v.noise(), v_cosine),
                               above(v.noise(), v.sine(k))};
        // what the sums leave of them is rounding and would spoil exact symmetry
        if (shape.even())
            h.w_sine = h.v_cosine = 0;
        result.harmonics.push_back(h);
    }
    drop_empty_tail(result);
    return result;
}

}  // namespace hdconj::wavegen
