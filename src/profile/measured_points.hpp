// SPDX-License-Identifier: GPL-3.0-or-later
// The cubic spline of the tooth families "points" and "b-spline".
#pragma once

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// The interpolating spline as one Bernstein piece per interval between its knots.
/// @param points  (n,2), n >= 4, neighbours distinct
[[nodiscard]] std::vector<CurvePiece> spline_through(std::vector<Vec2> const& points);

}  // namespace hdconj::profile
