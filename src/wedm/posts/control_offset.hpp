// SPDX-License-Identifier: GPL-3.0-or-later
// A contour that a control offsets by the radius which the wire cuts (G41, G42), and the path that it makes of it.
#pragma once

#include <vector>

#include "hdconj/wedm.hpp"

namespace hdconj::wedm {

/// What a file of a control with an offset says: start hole, a place half way in, the contour, a place half way out,
/// and the end. The offset comes on over the first move and goes off over the last one.
struct OffsetContour
{
    std::vector<Vec2> points;
    std::vector<std::size_t> stops;  ///< numbers of the points behind which the program stops
    double deviation = 0;            ///< largest distance of the path that the control makes from the wire's path [mm]
};

/// The wire's path offset back by the offset of @p pass: the contour that the wire can cut.
///
/// Each move of the wire becomes the parallel at the offset, on the side of the part. Two parallels meet in a corner,
/// of which the control makes the wire's corner again where the wire is inside of it; around others the wire rolls.
/// There moves may be left out if the path around the new corner stays within @p allowed of the wire's: as many as it
/// takes that the fewest are shorter than @p least, and then that the path is off the wire's by the least.
/// @throws NumericalError with ErrorCode::no_room where no such contour exists, or half of a lead is too short to
/// switch the offset on
[[nodiscard]] OffsetContour offset_contour(WirePass const& pass, double least, double allowed);

/// The path of the wire between the leads that a control makes of @p points of an OffsetContour: parallels of the
/// moves, shortened to where they meet if the wire is inside of a corner, and joined by arcs about it if not.
/// @param wire_left  of the direction of travel (G41)
/// @param sagitta    of chords in place of arcs [mm]
/// @throws NumericalError with ErrorCode::no_room where a move would turn backwards: controls stop there
[[nodiscard]] std::vector<Vec2> path_of_control(std::vector<Vec2> const& points, double offset, bool wire_left,
                                                double sagitta);

/// Largest distance of a point of one of two lines, or of the middle between two, from the other line [mm].
[[nodiscard]] double distance_of_lines(std::vector<Vec2> const& a, std::vector<Vec2> const& b);

}  // namespace hdconj::wedm
