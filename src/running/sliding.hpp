// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities of loaded flanks against each other.
#pragma once

#include <vector>

#include "load/study/load_problem.hpp"

namespace hdconj::running {

/// A contact that carries force, and how its surfaces move against each other for each rad by which the flexspline
/// goes on past the wave generator.
struct SlidingContact
{
    double force = 0;    ///< of all sectors [N]
    double sliding = 0;  ///< speed of sliding, along the flank and the axis together [mm/rad]
    double opening = 0;  ///< by which the gap of both surfaces grows, were the shape and the turn to stay [mm/rad]
};

/// All contacts that carry force.
///
/// A point q of the flank of the circular spline is seen from the frame of the tooth, x(phase): with the tooth's pose
/// as a function of its undeformed angle and the shape at rest against the wave generator, dx/dphase is the velocity of
/// one surface against the other. Its part along the tooth's normal opens the gap, the rest slides. The wall also moves
/// along the axis, by du_z/dphase. Central difference over 1/50 of a pitch: its error is 1e-6 of the velocity and
/// rounding. Errors of the rings, which displace teeth by micrometres, are left out of velocities; so is the lean of
/// the wall, which turns the plane of both parts by a degree.
[[nodiscard]] std::vector<SlidingContact> sliding_contacts(load::LoadProblem const& problem,
                                                           load::LoadedDrive const& loaded);

}  // namespace hdconj::running
