// SPDX-License-Identifier: GPL-3.0-or-later
// Two given teeth whose neutral curve is wanted.
#pragma once

#include "drive.hpp"

namespace hdconj::drive {

/// Both teeth of a scene with Scene::wants_neutral_curve(), and what follows of them without a displacement.
struct GivenPair
{
    profile::Profile flexspline;
    profile::Profile circular_spline;
    PairGeometry geometry;   ///< without w0, r_0
    double seat_height = 0;  ///< radius of the origin of the circular-spline tooth's frame less r_m [mm]
    double rim_limit = 0;    ///< displacement at which the circular spline's tips reach the rim on the major axis [mm]
    double root_limit = 0;   ///< at which the flexspline's tips reach the roots that the circular spline is given with
    double deepest = 0;      ///< the smaller of both
};

/// @returns with empty teeth where @p faults says why
[[nodiscard]] GivenPair given_pair(Scene const& scene, Faults& faults);

}  // namespace hdconj::drive
