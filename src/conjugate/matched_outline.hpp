// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of several slices with the same number of points, point for point of the same origin.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "outline.hpp"

namespace hdconj::conjugate {

class ToothSpaceBoundary;

/// Matched outlines, left mid-land to right mid-land.
struct MatchedOutline
{
    std::vector<std::vector<Vec2>> points;  ///< (k,n)
    std::vector<std::vector<Vec2>>
        normals;  ///< (k,n) into the material; at a corner of the piece before it, at both ends of a flank of the flank
    /// Indices: left land corner, left flank end, middle, right flank end, right land corner.
    std::array<std::size_t, 5> landmarks{};
    std::vector<OutlineStretch>
        stretches;  ///< common to all slices; between landmarks that were matched by length one of kind flank or bottom
    bool by_origin = true;  ///< every slice is made of the same stretches, in the same order
    double chord = 0;       ///< largest chord error in any slice [mm]
};

/// Samples @p slices to a chord error at common stations (design 3.4).
///
/// Between two landmarks where all slices have the same stretches, each stretch is matched by its share of the profile
/// parameter (on flanks where that is monotone), or of its length (paths of corners, lands). Elsewhere the whole
/// interval is matched by its share of length, and every joint of every slice is a station, so that no ruling cuts
/// across a corner. Both measures grow along the outline in every slice, so rulings do not cross. Every point is an
/// exact contact; the chord error holds in every slice.
/// @param flank_intervals  at least about this many along each flank, evenly by share: for maps over the flank, which
/// must not depend on how
///                         few points the chord error needs
/// @param rulings  points of the slices are to be joined by straight lines: shares of length are met to roundoff, so
/// that the lines between do not depend on the chord error
/// @throws NumericalError when a slice has no landmarks or cannot be sampled to the chord error
[[nodiscard]] MatchedOutline matched_outline(std::vector<ToothSpaceBoundary const*> const& slices, double chord,
                                             int flank_intervals, int threads, bool rulings = false);

}  // namespace hdconj::conjugate
