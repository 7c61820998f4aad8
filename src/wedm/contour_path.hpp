// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of a pass that goes along the workpiece; private to src/wedm.
#pragma once

#include <vector>

#include "hdconj/geometry/vec2.hpp"
#include "hdconj/wedm/paired_path.hpp"
#include "hdconj/wedm/wire_program.hpp"

namespace hdconj::detail {

/// Lead-in point, contour and stop: the path along the part; where it closes, its closing point is repeated.
[[nodiscard]] std::vector<WireMove> contour_path(WirePass const& pass);

/// The same without the point that only the stop put there, and turned round where the pass is reversed.
/// @throws std::invalid_argument when the moves are not those of @p spaces equal tooth spaces
[[nodiscard]] std::vector<WireMove> even_path(WirePass const& pass, int spaces);

/// The wire at a height: @p share of the workpiece's thickness above the lower face.
[[nodiscard]] std::vector<Vec2> section(PairedPath const& path, WireMachine const& machine, double share);

}  // namespace hdconj::detail
