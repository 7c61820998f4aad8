// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Polylines and texts as pictures need them; private to src/io.
#pragma once

#include <string>
#include <vector>

#include "hdconj/geometry/vec2.hpp"

namespace hdconj {

/// Fewer points: none is further than @p tolerance [mm] from the polyline that is left. Ends are kept.
[[nodiscard]] std::vector<Vec2> thinned(std::vector<Vec2> const& polyline, double tolerance);

/// Squared distance of @p point from the segment a b.
[[nodiscard]] double squared_distance(Vec2 const& point, Vec2 const& a, Vec2 const& b);

/// A text in gnuplot's single quotes, without control characters.
[[nodiscard]] std::string gnuplot_quoted(std::string text);

}  // namespace hdconj
