// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the planes of a gap field leave open about the gaps between them.
#pragma once

#include <cstddef>
#include <vector>

#include "gap_field.hpp"

namespace hdconj::contact {

/// One flank of one space at one turn.
struct OpenGap
{
    double lowest = 0;  ///< smallest gap in any plane, between the points too [mm]
    double second = 0;  ///< the same of every second plane [mm]
    double least = 0;   ///< estimated: no smaller than this between the planes either [mm]
    double lever = 0;   ///< how fast the gap changes there with the turn [mm/rad]
    double missed = 0;  ///< area of the patches within the limit that no plane shows [mm^2]
};

/// The flank @p flank of the spaces @p spaces at @p turn, in this order.
///
/// Between planes the smallest gap follows parabolas whose curvature the planes show (between_places()). Where such a
/// parabola falls below @p limit between two planes that are above it, a patch of contact may lie there that no plane
/// meets: as wide across as the parabola is below the limit, as long as the flank in the nearer plane is within the
/// same depth of its own smallest gap. The lever is that of the normal in the place of the smallest gap, no less than a
/// twentieth of the radius. Same bits for any number of threads.
[[nodiscard]] std::vector<OpenGap> open_gaps(GapField const& field, std::vector<std::size_t> const& spaces, int flank,
                                             double turn, double limit, int threads);

}  // namespace hdconj::contact
