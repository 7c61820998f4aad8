// SPDX-License-Identifier: GPL-3.0-or-later
// Flanks of a part down to its tip circle, and the tip circle that leaves it a land.
#pragma once

#include <optional>
#include <vector>

#include "contact/flank_grid.hpp"
#include "contact/study/case_surface.hpp"
#include "contact/study/place_teeth.hpp"
#include "slice_clearance.hpp"

namespace hdconj::contact {

/// Flanks to be moved into the material.
///
/// Moving lifts the land corner off the tip circle: between the two the flank of the part is what of the surface lies
/// beyond that circle before it is moved.
struct PartFlanks
{
    conjugate::MatchedOutline outline;  ///< as far beyond the tip circle as that takes, not moved
    FlankGrid grid;                     ///< the same, with the tip circles of its slices where it may be moved; slices
                                        ///< with a draft have the side clearance already
};

/// @param at_tip    @p surface with the tip circle @p tip
/// @param distance  side clearance that they may be moved by [mm]; 0: nothing lies beyond
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

/// A tip circle from which a side clearance lifted land corners, so that it was widened [mm].
struct LiftedTip
{
    double tip = 0;
    double side_clearance = 0;
};

/// A surface whose flanks clear: what side clearance and tip circle it takes.
struct Cleared
{
    conjugate::MatchedOutline outline;  ///< with that tip circle, without the side clearance
    PartFlanks flanks;                  ///< of it, to be moved by up to `reach`
    double reach = 0;                   ///< [mm]
    double offset = 0;
    double tip = 0;
    std::optional<LiftedTip> lifted;
    TurnsOfSet at_zero;  ///< of the flanks without side clearance; empty: not known
};

/// The tip circle of z = 0 that leaves every slice of @p outline a land, and that its flanks meet, when these are moved
/// by @p distance; at least @p tip.
[[nodiscard]] double tip_with_land(CaseSurface const& surface, conjugate::MatchedOutline const& outline,
                                   double distance, double tip);
/// The same of flanks that reach that far; also where what is missing of them would meet.
[[nodiscard]] double tip_with_land(CaseSurface const& surface, PartFlanks const& flanks, double distance, double tip);

/// To be called before the tip circle is lifted once more, with the number of times that it was.
/// @throws NumericalError after too many
void refuse_to_lift_for_ever(int round, double tip);

/// Has the flanks reach the tip circle when they are moved by @p distance.
void reach(CaseSurface const& surface, Cleared& cleared, double distance);

}  // namespace hdconj::contact
