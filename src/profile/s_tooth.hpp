// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "s-tooth": half the path that a tooth describes.
#pragma once

#include <cmath>
#include <optional>

#include "hdconj/profile/builder.hpp"
#include "hdconj/profile/polynomial_curve.hpp"

namespace hdconj::profile {

/// The S-tooth after Ishikawa ("IH"): a tooth of the flexspline moves along the locus (rack limit: many teeth, no
/// rotation)
///
///   L(eta) = m D (eta/n - (kappa/n) sin eta, kappa cos eta) / 2,   D = z_c - z_f, eta = n phi, kappa = 2 w0 / (m D)
///   the deflection coefficient
///
/// and the flank is this locus halved, from the datum point M up to the tip:  P(eta) = M + (L(eta_M) - L(eta))/2, eta_M
/// < eta < pi. A flank of the circular spline M - (L(eta_M) - L(eta))/2 then touches it at every eta at once with
/// parallel tangents, in the rack limit. eta_M is where the flank has the pressure angle alpha: tan(alpha) = (1 - kappa
/// cos eta)/(n kappa sin eta); for kappa < 1 (negative deviation) the least is sqrt(1 - kappa^2)/(n kappa), at the
/// locus's point of inflexion. Below M the flank is straight, along the tangent at M, with continuous curvature when
/// alpha is that least angle. Source: the definitions of eta, kappa and M of EP 0266972 and US 5,458,023; equations
/// derived from the drive's own kinematics. Accuracy: curve_accuracy of the height. Refused: an addendum above the
/// locus's end at eta = pi, a pressure angle that no point has, the cusp of kappa = 1 at eta = 0 for M.
struct STooth
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {"s-tooth",
                "half the locus of a tooth (Ishikawa's S-tooth), straight below its datum point",
                {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
                 {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
                 {"deflection",
                  number,
                  "deflection coefficient kappa = 2 w0 / (m (z_c - z_f)); below 1: negative deviation",
                  true,
                  {},
                  0.2,
                  1.5},
                 {"pressure_angle_deg",
                  angle_deg,
                  "of the straight part and at the datum point, alpha; default: the least there is, which deflection 1 "
                  "or more does not have",
                  false,
                  {},
                  0,
                  45},
                 {"thickness", positive_length, "tooth thickness at the pitch line, s; default pi module / 2", false},
                 {"datum_rise", length, "height of the datum point above the pitch line; default 0", false}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

/// The halved locus from its datum point, by eta - eta_M.
struct HalvedLocus
{
    double size;   ///< m D / 2
    double waves;  ///< n
    double kappa;
    double eta_datum;  ///< eta_M
    Vec2 datum;        ///< M

    [[nodiscard]] CurveJet operator()(double e) const
    {
        double const eta = eta_datum + e;
        double const middle = eta_datum + 0.5 * e;
        double const turn = std::sin(0.5 * e);
        Vec2 const from_datum{-0.5 * size / waves * (e - 2 * kappa * std::cos(middle) * turn),
                              kappa * size * std::sin(middle) * turn};
        return {datum + from_datum,
                {-0.5 * size / waves * (1 - kappa * std::cos(eta)), 0.5 * kappa * size * std::sin(eta)}};
    }
};

/// Least pressure angle of the locus [rad]; 0 for kappa >= 1.
[[nodiscard]] inline double least_locus_angle(double kappa, double waves)
{
    return kappa < 1 ? std::atan(std::sqrt(1 - kappa * kappa) / (waves * kappa)) : 0;
}

/// eta_M: the last eta with pressure angle @p alpha >= the least. From n kappa tan(alpha) sin eta + kappa cos eta = 1.
[[nodiscard]] inline double eta_of_angle(double kappa, double waves, double alpha)
{
    double const k = waves * std::tan(alpha);
    return std::atan(k) + std::acos(std::min(1.0, 1 / (kappa * std::hypot(1.0, k))));
}

}  // namespace hdconj::profile
