// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Matched outlines moved: outward by a tilt, at the bottom by root clearance, and where flanks that are moved into the material meet.
#pragma once

#include <vector>

#include "hdconj/conjugate/matched_outline.hpp"

namespace hdconj::detail {

/// Tilt of kind "radial": every point of slice k moved outward by z_k tan(tilt).
void move_radially(MatchedOutline& outline, std::vector<double> const& z, double tilt);

/// Root clearance: the bottom between the same two points in every slice, moved outward by up to @p clearance.
/// @throws NumericalError where the bottom is widest at different points of different slices, or as deepen() does
void deepen_all(MatchedOutline& outline, double clearance);

/// Radius at which the two flanks beside a tip land of @p outline's slice @p k meet when both are moved by @p distance into the material; 0 where
/// they do not meet on the flanks that are there. @p pitch of the circular spline [rad].
[[nodiscard]] double meeting_radius(MatchedOutline const& outline, std::size_t k, double distance, double pitch);

}  // namespace hdconj::detail
