// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the neutral curve from a place where the flanks touch until they part.
#pragma once

#include <vector>

#include "curve_rule.hpp"

namespace hdconj::cam {

/// The curve at one angle.
struct MeshPoint
{
    double x = 0;      ///< u, in the first-order model phi [rad]
    CurveState state;  ///< there
    double slope = 0;  ///< rho'
    Tangency contact;  ///< of the flanks
};

/// What a march finds.
struct MarchedCurve
{
    std::vector<MeshPoint> points;  ///< at the angles that were asked for, as far as the flanks touch
    MeshPoint last;                 ///< the farthest point at which they touch
    bool lost = false;              ///< whether they part before the last angle
    double end_error = 0;           ///< of last.x where they part [rad]
};

/// Integrates the equations of @p rule with the tangency of @p pair: Runge and Kutta's rule of order 8 by Fehlberg
/// (Boost.Numeric.Odeint), the difference of one step and two of half the length held below @p tolerance. Where several
/// tangencies exist, the tooth leans on the one that it meets first. A step that leaves the flanks is halved until it
/// is 2^-40 of a radian.
/// @param begin      where the march begins; `contact.theta` is where tangencies are looked for
/// @param angles     increasing, from begin.x on
/// @param tolerance  [mm]
/// @returns no points where the flanks do not touch at the beginning
[[nodiscard]] MarchedCurve march(FlankPair const& pair, CurveRule const& rule, MeshPoint const& begin,
                                 std::vector<double> const& angles, double tolerance);

}  // namespace hdconj::cam
