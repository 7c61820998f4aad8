// SPDX-License-Identifier: GPL-3.0-or-later
// Both given teeth on a closed neutral curve: their smallest clearance.
#pragma once

#include "closed_curve.hpp"
#include "drive/wanted_geometry.hpp"

namespace hdconj::cam {

/// The smallest distance between both teeth over half a wave.
struct LeastClearance
{
    double clearance = 0;  ///< [mm], negative: overlap
    double u = 0;          ///< where [rad]
    double error = 0;      ///< by the chords of the circular spline's outline [mm]
};

/// The least distance of points of the circular spline's outline, teeth and bottom of the space, from the exact
/// flexspline tooth at positions between the major and the minor axis.
[[nodiscard]] LeastClearance least_clearance(drive::GivenPair const& given, CurveRule const& rule,
                                             ClosedCurve const& curve, Scene const& scene, int threads);

}  // namespace hdconj::cam
