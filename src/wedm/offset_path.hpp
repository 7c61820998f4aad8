// SPDX-License-Identifier: GPL-3.0-or-later
// The path of the wire's centre along a contour, in both faces with one topology.
#pragma once

#include <limits>

#include "paired_path.hpp"

namespace hdconj::wedm {

/// A path whose loops are removed.
struct TrimmedPath
{
    PairedPath path;
    std::vector<double> at;  ///< (n) number of the vertex of each point; negative: a crossing
};

/// @p path without the loops where it crosses itself, over the same vertices in both faces; the points of crossing
/// stay. Where the loop is longer in one face, points that the other face still needs are matched with points on the
/// other face's last step to its crossing, so that each face keeps its own exact line. First crossings are taken with
/// their return: right for a path that begins and ends outside of any loop.
[[nodiscard]] TrimmedPath without_loops(PairedPath const& path);

/// Parallel of @p nominal at @p offset to its left, in each face's own plane, point for point (notes: offset per pass
/// and per plane).
///
/// Gentle vertices move to where the parallels of their two edges meet. At sharper ones that stick into the void the
/// wire rolls around: an arc of radius offset, in as many chords in both faces. Where the parallel crosses itself the
/// wire cannot follow, and the loop is removed (without_loops). Where the wire leans, the offset is its distance from
/// the contour square to the wire (Lean): the lean of a place is that of the points of @p nominal there.
///
/// @param nominal  first and last point only give the direction of their edges; the path is that of the points between
/// @param offset   [mm], > 0
/// @param sagitta  of the chords of arcs [mm], > 0
/// @param height   of the upper face above the lower one [mm]; infinity: the wire leans nowhere
/// @return at least 2 points. Accuracy: sagitta, and that of the points given. Equal faces give equal paths bit for
/// bit.
[[nodiscard]] PairedPath offset_path(PairedPath const& nominal, double offset, double sagitta,
                                     double height = std::numeric_limits<double>::infinity());

}  // namespace hdconj::wedm
