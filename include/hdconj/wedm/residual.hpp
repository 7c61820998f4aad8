// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Material that a round wire leaves where it cannot follow the contour.
#pragma once

#include <vector>

#include "hdconj/geometry/vec2.hpp"

namespace hdconj {

/// Height of what is left on each point of @p nominal, measured along the normals of both its edges into the void; the larger counts [mm].
///
/// Left is what is further than @p offset - @p stock from the path of the wire's centre and lies beyond the stock. Found by steps along the
/// normal that never pass the surface, until they are shorter than a share of @p tolerance; heights within @p tolerance are 0.
/// @param nominal  first and last point only give the direction of their edges: their height is 0
/// @param wire     path of the wire's centre, at least 2 points, reaching beyond both ends of @p nominal
/// A height ends where the normal meets @p nominal again: nothing is cut along it at all.
[[nodiscard]] std::vector<double> uncut_heights(std::vector<Vec2> const& nominal, std::vector<Vec2> const& wire, double offset, double stock,
                                                double tolerance);

}  // namespace hdconj
