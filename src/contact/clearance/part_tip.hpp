// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Flanks of a part down to its tip circle, and the tip circle that leaves it a land.
#pragma once

#include "contact/study/place_teeth.hpp"
#include "part_flanks.hpp"

namespace hdconj::contact {

/// A surface whose flanks clear: what side clearance and tip circle it takes.
struct Cleared
{
    conjugate::MatchedOutline outline;  ///< with that tip circle, without the side clearance
    PartFlanks flanks;                  ///< of it, to be moved by up to `reach`
    double reach = 0;                   ///< [mm]
    double offset = 0;
    double tip = 0;
};

/// The tip circle of z = 0 that leaves every slice of @p outline a land, and that its flanks meet, when these are moved
/// by @p distance; at least @p tip.
[[nodiscard]] double tip_with_land(CaseSurface const& surface, conjugate::MatchedOutline const& outline,
                                   double distance, double tip);

/// To be called before the tip circle is lifted once more, with the number of times that it was.
/// @throws NumericalError after too many
void refuse_to_lift_for_ever(int round, double tip);

/// Has the flanks reach the tip circle when they are moved by @p distance.
void reach(CaseSurface const& surface, Cleared& cleared, double distance);

}  // namespace hdconj::contact
