// SPDX-License-Identifier: GPL-3.0-or-later
// Where the flanks begin to touch, and the stretch from the major axis to there.
#pragma once

#include <cmath>

#include "even_polynomial.hpp"
#include "march.hpp"

namespace hdconj::cam {

/// A ring bends no more than this many times as a cosine of the same displacement does.
inline constexpr double most_bending = 3;

/// Whether the ring may be bent like this.
class BendingLimit
{
  public:
    BendingLimit(CurveRule const& rule, int waves, double major)
        : rule_(rule), most_(most_bending * major * (waves * waves - 1.0) / (rule.r_m * rule.r_m))
    {
        // one wave bends no ring to first order
        if (waves == 1)
            most_ = most_bending * major / (rule.r_m * rule.r_m);
    }
    [[nodiscard]] bool keeps(double w, double slope, double bend) const
    {
        double const curvature = CurveRule::curvature(rule_.r_m + w, slope, bend);
        return curvature > 0 && std::abs(curvature - 1 / rule_.r_m) <= most_;
    }
    [[nodiscard]] bool keeps(EvenPolynomial const& curve) const
    {
        constexpr int probes = 64;
        for (int i = 0; i <= probes; ++i) {
            EvenPolynomial::Value const at = curve(curve.scale * i / probes);
            if (!keeps(at.value, at.slope, at.bend))
                return false;
        }
        return true;
    }

  private:
    CurveRule rule_;
    double most_;
};

/// Beginning of the mesh.
struct MeshBegin
{
    MeshPoint point;         ///< from which the march goes on; on the axis x = 0
    double first = 0;        ///< the smallest angle at which they touch on to_axis continued [rad]
    double first_error = 0;  ///< of it [rad]
    EvenPolynomial to_axis;  ///< displacement between the axis and there; no coefficients where they touch on the axis
    CurveState shift{};      ///< error of the states at point: a cam that breaks near the axis is no even polynomial
    EvenPolynomial to_axis_shift{};  ///< error of to_axis

    /// The beginning moved by @p share of its error.
    [[nodiscard]] MeshBegin shifted(double share) const;
};

/// Finds where the flanks begin to touch on a curve that is symmetric about the major axis and has the displacement
/// @p major there.
///
/// Flanks that touch on the axis begin there. Others begin at x1, and two conditions of symmetry, w(0) = major and a
/// tangential state that vanishes on the axis, determine both states at x1: the even polynomial that goes through the
/// solution beyond x1 continues it to the axis. Newton's method solves for them. A cam of rows or rollers breaks on the
/// axis or between its rows: what a polynomial with a break on the axis and one of a power less change tells the error.
/// @param reach  the angle by which the flanks must have begun [rad]
/// @param tolerance  of the march [mm]
/// The polynomial has to keep BendingLimit.
/// @throws NumericalError where flanks overlap on the axis, or do not begin to touch
[[nodiscard]] MeshBegin mesh_begin(FlankPair const& pair, CurveRule const& rule, int waves, double major, double reach,
                                   double tolerance);

/// The deepest displacement on the major axis with which the flanks do not overlap there.
/// @param deepest  limit of it, where the tips reach the bottom [mm]
[[nodiscard]] double deepest_displacement(FlankPair const& pair, CurveRule const& rule, double deepest);

}  // namespace hdconj::cam
