// SPDX-License-Identifier: GPL-3.0-or-later
// Line contact of two elastic bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elastic/elasticity.hpp"

namespace hdconj::load {

/// E/(1 - nu^2) [MPa]: plane strain.
[[nodiscard]] inline double plane_strain_modulus(elastic::Elasticity const& material)
{
    return material.youngs_modulus / (1 - material.poissons_ratio * material.poissons_ratio);
}

/// Two bodies that touch along a line.
struct LineContact
{
    elastic::Elasticity first, second;
    double curvature = 0;  ///< relative: 1/R_1 + 1/R_2 [1/mm], positive
    double depth = 0;      ///< below the surface at which the approach is taken [mm]
};

/// 1/E* = 1/E'_1 + 1/E'_2.
[[nodiscard]] inline double contact_modulus(LineContact const& c)
{
    return 1 / (1 / plane_strain_modulus(c.first) + 1 / plane_strain_modulus(c.second));
}

/// Half width of the strip under pressure, a = sqrt(4 q/(pi E* kappa)) [mm], at a line load @p q [N/mm] (Hertz).
[[nodiscard]] inline double half_width(LineContact const& c, double q)
{
    return q <= 0 ? 0 : std::sqrt(4 * q / (std::numbers::pi * contact_modulus(c) * c.curvature));
}

/// Largest pressure, 2 q/(pi a) [MPa].
[[nodiscard]] inline double largest_pressure(LineContact const& c, double q)
{
    return q <= 0 ? 0 : 2 * q / (std::numbers::pi * half_width(c, q));
}

/// Approach of the points `depth` below the surfaces [mm]: q/(pi E') (2 ln(2 d/a) - nu/(1 - nu)) of each body (Johnson,
/// Contact Mechanics, 5.58 with both half-spaces cut at the depth d).
///
/// Where the strip grows as wide as the depth the formula has left its domain (a << d); a is not taken above d/2 there,
/// so that the approach goes on growing. Accuracy of the law itself: a few per cent for a < d/4.
[[nodiscard]] inline double approach(LineContact const& c, double q)
{
    if (q <= 0)
        return 0;
    double const a = std::min(half_width(c, q), 0.5 * c.depth);
    auto const of = [&](elastic::Elasticity const& body) {
        double const nu = body.poissons_ratio;
        return q / (std::numbers::pi * plane_strain_modulus(body)) * (2 * std::log(2 * c.depth / a) - nu / (1 - nu));
    };
    return of(c.first) + of(c.second);
}

/// What one N/mm lets a point of the surfaces approach at the distance @p x beside its line [mm per N/mm]: 1/(pi E')
/// (ln((x^2 + d^2)/x^2) - d^2/((1 - nu) (x^2 + d^2))) of each body, the surface of a half-plane under a line load
/// against the depth d below the point (Flamant; Johnson 2.19 ff).
///
/// Nearer than a/(2 sqrt(e)) to a strip of the half width @p a it is approach()/q of that strip: two strips that meet
/// become one without a jump. Not below 0.
[[nodiscard]] inline double approach_beside(LineContact const& c, double x, double a)
{
    double const strip = std::min(a, 0.5 * c.depth);
    x = std::max(x, 0.5 / std::sqrt(std::numbers::e) * strip);
    double const d2 = c.depth * c.depth, both = x * x + d2;
    auto const of = [&](elastic::Elasticity const& body) {
        double const nu = body.poissons_ratio;
        double const beside = std::log(both / (x * x)) - d2 / ((1 - nu) * both);
        double const under = 2 * std::log(2 * c.depth / strip) - nu / (1 - nu);
        return std::clamp(beside, 0.0, under) / (std::numbers::pi * plane_strain_modulus(body));
    };
    return of(c.first) + of(c.second);
}

}  // namespace hdconj::load
