// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The smallest gap of a whole map, between its points too.
#pragma once

#include "gap_field.hpp"

namespace hdconj::contact {

/// A gap and the point of the map it is at or beside.
struct SmallestGap
{
    double gap = 0;  ///< [mm]
    GapField::Index where{};
};

/// How far a smallest gap may be from the true one beside the rounding of coordinates: golden section ends there [mm].
[[nodiscard]] double smallest_gap_accuracy(GapField const& field);

/// The smallest gap of @p map, which holds the gaps of @p field at @p turn, with the minima between its points.
///
/// A gap falls no faster than the flank goes on, which drops the points beside which there can be no smaller one; about
/// the others that are smaller than their neighbours the exact gap is followed to its minimum
/// (GapField::lowest_about()). A dip between two points that neither of them falls towards is not seen: its depth is
/// less than what the gap changes over half their distance.
/// @param flank  GapMap::left or GapMap::right; below 0: both
[[nodiscard]] SmallestGap smallest_gap(GapField const& field, GapMap const& map, double turn, int flank, int threads);

/// The same on one flank in one slice, whose points have the gaps @p gap; minima between points where they may lie
/// below @p below. Of @p line the point does not count.
[[nodiscard]] SmallestGap smallest_on_line(GapField const& field, GapField::Index const& line, double const* gap,
                                           double turn, double below);

}  // namespace hdconj::contact
