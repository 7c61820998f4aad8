// SPDX-License-Identifier: GPL-3.0-or-later
// Line contact of two elastic bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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
    /// Mean over the strip under which the softer body flows [MPa]; infinite: it never does.
    double flow_pressure = std::numeric_limits<double>::infinity();
};

/// 1/E* = 1/E'_1 + 1/E'_2.
[[nodiscard]] inline double contact_modulus(LineContact const& c)
{
    return 1 / (1 / plane_strain_modulus(c.first) + 1 / plane_strain_modulus(c.second));
}

/// Half width of the strip of elastic bodies, a = sqrt(4 q/(pi E* kappa)) [mm], at a line load @p q [N/mm] (Hertz).
[[nodiscard]] inline double elastic_half_width(LineContact const& c, double q)
{
    return q <= 0 ? 0 : std::sqrt(4 * q / (std::numbers::pi * contact_modulus(c) * c.curvature));
}

/// Half width of the strip under pressure [mm]: that of elastic bodies or, where their mean pressure would exceed the
/// flow pressure p, q/(2 p).
[[nodiscard]] inline double half_width(LineContact const& c, double q)
{
    return std::max(elastic_half_width(c, q), 0.5 * std::max(q, 0.0) / c.flow_pressure);
}

/// Whether a body flows under the line load @p q, from 16 p^2/(pi E* kappa) on.
[[nodiscard]] inline bool flows(LineContact const& c, double q)
{
    return half_width(c, q) > elastic_half_width(c, q);
}

/// How far the surface of a body that flows gives way [mm]: as much as parabolas of the relative curvature overlap
/// between the strip's own half width and the elastic one, kappa (a^2 - a_el^2)/2. 0 where none flows.
[[nodiscard]] inline double indentation(LineContact const& c, double q)
{
    double const elastic = elastic_half_width(c, q), flown = half_width(c, q);
    return 0.5 * c.curvature * (flown * flown - elastic * elastic);
}

/// d indentation/dq [mm per N/mm].
[[nodiscard]] inline double indentation_slope(LineContact const& c, double q)
{
    return flows(c, q) ? 0.25 * c.curvature * q / (c.flow_pressure * c.flow_pressure) -
                             2 / (std::numbers::pi * contact_modulus(c))
                       : 0;
}

/// Largest pressure 2 q/(pi a) [MPa] of the ellipse (Hertz) over the strip. Where a body flows it is 4/pi of the flow
/// pressure, its value at the first flow. There the pressure flattens towards its mean, which is the flow pressure: the
/// result is an upper bound.
[[nodiscard]] inline double largest_pressure(LineContact const& c, double q)
{
    return q <= 0 ? 0 : 2 * q / (std::numbers::pi * half_width(c, q));
}

/// Approach of the points `depth` below the surfaces [mm]: q/(pi E') (2 ln(2 d/a) - nu/(1 - nu)) of each body (Johnson,
/// Contact Mechanics, 5.58 with both half-spaces cut at the depth d).
///
/// Where a body flows, indentation() is added: continuous with its first load, and quadratic in q. The loading is the
/// first; what is left after it is not told.
///
/// Where the strip grows as wide as the depth the formula has left its domain (a << d); a is not taken above d/2 there,
/// so that the approach goes on growing. Accuracy of the law itself: a few per cent for a < d/4.
[[nodiscard]] inline double approach(LineContact const& c, double q)
{
    if (q <= 0)
        return 0;
    double const a = std::min(elastic_half_width(c, q), 0.5 * c.depth);
    auto const of = [&](elastic::Elasticity const& body) {
        double const nu = body.poissons_ratio;
        return q / (std::numbers::pi * plane_strain_modulus(body)) * (2 * std::log(2 * c.depth / a) - nu / (1 - nu));
    };
    return of(c.first) + of(c.second) + indentation(c, q);
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
