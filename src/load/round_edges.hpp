// SPDX-License-Identifier: GPL-3.0-or-later
// Rounds the edges of the circular spline's lands.
#pragma once

#include "contact/flank_grid.hpp"

namespace hdconj::load {

/// The flanks of @p grid with land corners rounded by @p radius [mm], as centres of the circles that roll within the
/// material: FlankGrid::radius.
///
/// Between a sharp corner and a sharp edge the normal is undefined, and inside a sharp corner the distance has a
/// crease, along which forces have no equilibrium. For circles in the material both are smooth at every gap above
/// -radius, and the curvature of the gap is that of a body with an edge of this radius, so that Hertz' formulas hold.
///
/// The last circle touches flank and land, and where the land is too narrow for two, or the flanks meet before it, both
/// flanks: its centre is then in the middle of the tooth. Points before it are moved there. Flanks with convex edges of
/// their own lose what the circles do not reach.
/// @param half_pitch  angle from the middle of a tooth space to that of a land [rad]
/// Accuracy: centres at the grid's points are exact, the one at the edge lies between two of them, to the square of
/// their distance times the curvature.
/// @throws NumericalError for a tooth into which no circle fits
[[nodiscard]] contact::FlankGrid with_round_edges(contact::FlankGrid grid, double radius, double half_pitch);

}  // namespace hdconj::load
