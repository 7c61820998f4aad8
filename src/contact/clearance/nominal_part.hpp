// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part that a scene gives, with its side clearance and its own tip circle.
#pragma once

#include <optional>
#include <vector>

#include "part_tip.hpp"
#include "slice_clearance.hpp"

namespace hdconj::contact {

/// The part that the scene gives: side clearance @p given and the tip circle @p tip, which is lifted only where the
/// moved flanks would leave no land.
/// @throws NumericalError where it cannot be made
[[nodiscard]] Cleared nominal_part(CaseSurface const& surface, double given, double tip);

/// nominal_part() with the surface's own tip circle, and what is known of it.
struct MadePart
{
    Cleared part;
    TurnMinima at_given;  ///< of its flanks with the scene's side clearance
};

/// Whether the side clearance that the scene gives is no less than that of @p cleared; "auto" gives none.
[[nodiscard]] bool is_enough(ContactContext const& context, Cleared const& cleared);

/// The part with the side clearance that the scene gives, where nothing enters its flanks over a full turn, nor in the
/// map at @p phases: with the surface's own tip circle, larger only where every slice's land and rim ask for it. Absent
/// where @p cleared takes its place, or has the same tip circle.
/// @param made  where it is known
[[nodiscard]] std::optional<Cleared> try_nominal_part(CaseSurface const& surface, SliceClearances const& clearances,
                                                      Cleared const& cleared, std::vector<double> const& phases,
                                                      MadePart const* made);

}  // namespace hdconj::contact
