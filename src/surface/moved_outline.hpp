// SPDX-License-Identifier: GPL-3.0-or-later
// Matched outlines moved: outward by a tilt, at the bottom by root clearance, and where flanks that are moved into the
// material meet.
#pragma once

#include <vector>

#include "conjugate/chord_moved.hpp"
#include "conjugate/matched_outline.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::surface {

/// Tilt of kind "radial": moves every point of slice k outward by z_k tan(tilt), and turns the normals where the
/// outline has any. The chord error grows with the outline.
void move_radially(conjugate::MatchedOutline& outline, std::vector<double> const& z, double tilt);

/// Root clearance: the bottom between the same two points in every slice, moved outward by up to @p clearance.
/// @throws NumericalError where the bottom is widest at different points of different slices, or as deepen() does
void deepen_all(conjugate::MatchedOutline& outline, double clearance);

/// Radius at which the two flanks beside a tip land of @p outline's slice @p k meet when both are moved by @p distance
/// into the material; 0 where they do not meet on the flanks that are there. @p pitch of the circular spline [rad].
[[nodiscard]] double meeting_radius(conjugate::MatchedOutline const& outline, std::size_t k, double distance,
                                    double pitch);

}  // namespace hdconj::surface
