// SPDX-License-Identifier: GPL-3.0-or-later
// From the path along one pitch to the moves of a whole pass, and back.
#pragma once

#include <cmath>

#include "faces.hpp"
#include "hdconj/wedm.hpp"
#include "planes.hpp"

namespace hdconj::wedm {

/// Shortest block that is wanted, in units of the last digit: rounding turns it by 4 degrees at most.
inline constexpr double least_units = 20;

/// The same in mm.
[[nodiscard]] inline double least_block(int decimals)
{
    return least_units * std::pow(10.0, -decimals);
}

/// Length of the move from @p a to @p b in that of both faces and both guides where it is shortest [mm].
[[nodiscard]] double shortest_plane(WireMachine const& machine, WirePoints const& a, WirePoints const& b);

/// The point on the way from @p a to @p b at @p share of it.
[[nodiscard]] WireMove between(WireMove const& a, WireMove const& b, double share);

/// How a pass begins, ends and goes round. Lengths in mm along the lower face.
struct WireRun
{
    int start = 0;             ///< first space with the void on the left; the path begins on the tip land before it
    Vec2 hole = Vec2::Zero();  ///< centre of the start hole
    double overlap = 0;        ///< on beyond the closing point
    double stop_before = 0;    ///< tag a point this far before the closing point; 0: none
    bool reversed = false;     ///< the other way round, void on the right
    int spaces = 0;            ///< that are cut, from `start`; 0: all of them, and the path closes
    Vec2 end = Vec2::Zero();   ///< where a path that does not close ends, or begins if reversed
    double least = 0;          ///< stop and overlap move by up to this to end no block that is shorter
};

/// The whole contour: turned copies of the fine pitch thinned to @p indices, as marks for CAM those of @p faces.marks.
[[nodiscard]] PairedContour whole_contour(WireFaces const& faces, std::vector<std::size_t> const& indices);

/// Centre of the start hole: @p lead_in [mm] off the tip land where tooth space @p space begins, in the void; with
/// @p at_end off that where it ends, where a path that does not close leaves the part. Both faces are asked, and the
/// one that reaches further into the void counts.
[[nodiscard]] Vec2 hole_beside(WireFaces const& faces, int space, bool at_end, double lead_in);

/// Moves from the start hole, straight to the tip land, along all spaces of @p run, on for the overlap, and straight
/// back, or out where the path does not close. At both ends the wire is vertical.
/// @param pitch  path of the wire's centre along space 0 of @p faces, from mid-land to mid-land
/// @throws std::invalid_argument when stop or overlap are longer than the path, or the overlap than the spaces left
/// over
[[nodiscard]] WirePass wire_pass(PairedPath const& pitch, WireFaces const& faces, WireRun const& run);

/// Lead-in point, contour and stop: the path along the part; where it closes, its closing point is repeated.
[[nodiscard]] std::vector<WireMove> contour_path(WirePass const& pass);

/// The same without the point that only the stop put there, and turned round where the pass is reversed.
/// @throws std::invalid_argument when the moves are not those of @p spaces equal tooth spaces
[[nodiscard]] std::vector<WireMove> even_path(WirePass const& pass, int spaces);

/// The points of @p moves but for the last @p left_out.
[[nodiscard]] PairedPath points_of(std::vector<WireMove> const& moves, std::size_t left_out);

/// The wire at a height: @p share of the workpiece's thickness above the lower face.
[[nodiscard]] std::vector<Vec2> section(PairedPath const& path, WireMachine const& machine, double share);

/// Path of the wire's centre along tooth space 0, from mid-land to mid-land, turned back from the first space of @p
/// pass.
/// @throws std::invalid_argument when the moves are not those of as many equal spaces as the program cuts
[[nodiscard]] PairedPath pitch_of(WirePass const& pass, WireProgram const& program);

}  // namespace hdconj::wedm
