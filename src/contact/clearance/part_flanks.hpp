// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Flanks of a part, which reach its tip circle with the side clearance too.
#pragma once

#include <vector>

#include "contact/flank_grid.hpp"
#include "contact/study/case_surface.hpp"

namespace hdconj::contact {

/// Flanks to be moved into the material.
///
/// Moving lifts the land corner off the tip circle: between the two the flank of the part is what of the surface lies
/// beyond that circle before it is moved.
struct PartFlanks
{
    conjugate::MatchedOutline outline;  ///< as far beyond the tip circle as that takes, not moved
    FlankGrid grid;                     ///< the same, with the tip circles of its slices where it may be moved
};

/// @param at_tip    @p surface with the tip circle @p tip
/// @param distance  they may be moved by this much [mm]; 0: nothing lies beyond
[[nodiscard]] PartFlanks part_flanks(CaseSurface const& surface, conjugate::MatchedOutline const& at_tip, double tip,
                                     double distance);

/// How far moving by @p distance lifts the land corners off the tip circles of a grid, of one without them off where
/// they are; the most of all slices [mm].
[[nodiscard]] double lift_of_corners(FlankGrid const& grid, double distance);
/// The same of each slice.
[[nodiscard]] std::vector<double> lifts_of_corners(FlankGrid const& grid, double distance);

/// Length along the flanks of a grid with tip circles that is missing of the part when they are moved by @p distance,
/// where its surface cannot be made so far beyond them; the most of all slices [mm].
[[nodiscard]] double unseen_length(FlankGrid const& grid, double distance);

}  // namespace hdconj::contact
