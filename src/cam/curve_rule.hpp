// SPDX-License-Identifier: GPL-3.0-or-later
// What both motion models say of a neutral curve that is not known yet.
#pragma once

#include <array>
#include <cmath>

#include "tangency.hpp"

namespace hdconj::cam {

/// w = rho - r_m and the tangential state at one angle x: r_m (phi - u) in the exact model, where x = u; v in the
/// first-order one, where x = phi. Both [mm], small, and periodic.
using CurveState = std::array<double, 2>;

/// The differential equations of the neutral curve, with the inclination theta of the tooth that tangency gives.
///
/// Exact: gamma = u - k phi and theta = gamma - atan(rho'/rho), so rho' = rho tan(gamma - theta); the curve does not
/// stretch, so (r_m phi)' = sqrt(rho^2 + rho'^2). On the closed curve phi = u after half a wave. First order: gamma =
/// (1 - k) phi + v/r_m and theta = gamma - w'/r_m, so w' = r_m (gamma - theta) with w = rho - r_m; v' = -w, with w that
/// has no mean (docs/explanation/theory.md).
struct CurveRule
{
    double r_m = 0;
    double tooth_ratio = 0;  ///< k = z_f/z_c
    bool exact = true;

    [[nodiscard]] ToothOrigin origin(double x, CurveState const& state) const
    {
        double const turn = state[1] / r_m;
        return {r_m, state[0], (1 - tooth_ratio) * x + (exact ? -tooth_ratio * turn : turn)};
    }
    /// rho' where the tooth stands at @p theta.
    [[nodiscard]] double slope(ToothOrigin const& origin, double theta) const
    {
        double const lean = origin.gamma - theta;
        return exact ? origin.rho() * std::tan(lean) : r_m * lean;
    }
    /// theta of the tooth where rho' is @p slope.
    [[nodiscard]] double theta(ToothOrigin const& origin, double slope) const
    {
        return origin.gamma - (exact ? std::atan2(slope, origin.rho()) : slope / r_m);
    }
    /// Rate of the tangential state.
    [[nodiscard]] double tangential_rate(double w, double slope) const
    {
        double const rho = r_m + w;
        return exact ? w + slope * slope / (std::hypot(rho, slope) + rho) : -w;
    }
    /// Signed curvature of the curve, positive where it is convex, of its second derivative @p bend.
    [[nodiscard]] static double curvature(double rho, double slope, double bend)
    {
        double const s2 = rho * rho + slope * slope;
        return (s2 + slope * slope - rho * bend) / (s2 * std::sqrt(s2));
    }
};

}  // namespace hdconj::cam
