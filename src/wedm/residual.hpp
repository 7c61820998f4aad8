// SPDX-License-Identifier: GPL-3.0-or-later
// Material that a round wire leaves where it cannot follow the contour.
#pragma once

#include <vector>

#include "faces.hpp"
#include "hdconj/wedm.hpp"
#include "lean.hpp"

namespace hdconj::wedm {

/// Distance of each point of @p nominal from what the wire cuts, less the stock that it is to leave there [mm].
///
/// The cut is all within @p offset - stock of the path, so that a point p is dist(p, path) - (offset - stock) away from
/// it: the height is dist(p, path) - offset, exact to the error of the path. In a corner of the void where the contour
/// turns by the angle a, between sides longer than offset tan(a/2), it is offset (1/cos(a/2) - 1).
/// @param nominal    first and last point belong to the neighbours: their height is 0
/// @param wire       path of the wire's centre, at least 2 points, reaching beyond both ends of @p nominal
/// @param offset     of the path from @p nominal: wire radius, spark gap and stock
/// @param tolerance  heights within it are 0
/// @param leans      of the wire at the points of @p nominal: distances are those seen along it; empty: it is upright
[[nodiscard]] std::vector<double> uncut_heights(std::vector<Vec2> const& nominal, std::vector<Vec2> const& wire,
                                                double offset, double tolerance, std::vector<Lean> const& leans = {});

/// Least distance of what is left, where @p heights are not 0, from the line @p reached [mm]: a lower bound. Infinity
/// where nothing is left, not above 0 where they may meet.
///
/// What is left at a point lies within its height of it, as each point of the cut's arc in a corner is the nearest one
/// of some point of the contour.
/// @param heights  of @p nominal, as uncut_heights finds them
[[nodiscard]] double way_to_residual(std::vector<Vec2> const& nominal, std::vector<double> const& heights,
                                     std::vector<Vec2> const& reached);

/// What a pass leaves on one pitch.
struct Uncut
{
    std::vector<char> at;             ///< (n) 1: material is left in either face
    std::vector<Residual> residuals;  ///< of space 0, one for each run of points

    /// The highest residual; null: none.
    [[nodiscard]] Residual const* highest() const;
};

/// What uncut_heights() asks of a pass. Lengths in mm.
struct CutRadius
{
    double offset = 0;     ///< of the path from the part
    double tolerance = 0;  ///< heights within it are 0
    double height = 0;     ///< of the upper face above the lower one
};

/// What a wire leaves whose centre runs along @p wire, one pitch of @p faces.
[[nodiscard]] Uncut uncut_of(WireFaces const& faces, PairedPath const& wire, CutRadius const& cut);

/// Least distance of that from the faces @p reached [mm], as way_to_residual().
[[nodiscard]] double way_to_uncut(WireFaces const& faces, PairedPath const& wire, CutRadius const& cut,
                                  WireFaces const& reached);

}  // namespace hdconj::wedm
