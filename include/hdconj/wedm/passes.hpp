// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From the path along one pitch to the moves of a whole pass.
#pragma once

#include "hdconj/wedm/faces.hpp"
#include "hdconj/wedm/wire_program.hpp"

namespace hdconj {

/// How a pass begins, ends and goes round. Lengths in mm along the lower face.
struct WireRun
{
    int start = 0;           ///< space whose clockwise tip land the path begins on
    Vec2 hole = Vec2::Zero();///< centre of the start hole
    double overlap = 0;      ///< on beyond the closing point
    double stop_before = 0;  ///< tag a point this far before the closing point; 0: none
    bool reversed = false;   ///< clockwise
};

/// The whole contour: turned copies of the fine pitch thinned to @p indices, as marks for CAM those of @p faces.marks.
[[nodiscard]] PairedContour whole_contour(WireFaces const& faces, std::vector<std::size_t> const& indices);

/// Centre of the start hole: @p lead_in [mm] inside the tip land where tooth space @p start begins. Both faces are asked, and the one that reaches
/// further inward counts.
[[nodiscard]] Vec2 start_hole(WireFaces const& faces, int start, double lead_in);

/// Moves from the start hole, straight to the tip land, around all spaces, over the closing point and back. In the hole the wire is vertical.
/// @param pitch  path of the wire's centre along space 0, from mid-land to mid-land
/// @throws std::invalid_argument when stop or overlap are longer than the path
[[nodiscard]] WirePass wire_pass(PairedPath const& pitch, int teeth, WireRun const& run);

}  // namespace hdconj
