// SPDX-License-Identifier: GPL-3.0-or-later
// Side clearance and tip circle with which the flanks of a surface clear.
#pragma once

#include <optional>
#include <vector>

#include "contact/study/gaps_at_rest.hpp"
#include "part_flanks.hpp"
#include "slice_clearance.hpp"

namespace hdconj::contact {

/// Side clearance and tip circle of @p spec, whose land is left with a side clearance of @p at_least too [mm].
///
/// Side clearance moves the flanks of neighbouring spaces towards each other: the tip circle may have to follow until a
/// land is left, which never asks for more clearance, so that the loop ends. It also lifts the land corners: the tip
/// circle follows to where the moved flanks begin, since what the surface has beyond them would be entered.
/// @throws NumericalError where they do not settle
[[nodiscard]] Cleared clear_flanks(CaseSurface const& surface, SliceClearances const& clearances, double at_least);

/// Whether the surface can also be made with the tip circle that the scene gives, not only with the one that clears: a
/// case tells of both.
/// @throws NumericalError where not, that of making it
void check_as_made(CaseSurface const& surface, Cleared const& cleared);

/// Offset that leaves no gap below zero where the map is looked at: beside the full turn, with the wall's axial shift.
/// At least @p offset; the flanks of @p cleared then reach as far.
[[nodiscard]] double clearance_for_assembly(CaseSurface const& surface, GapsAtRest& rest, Cleared& cleared,
                                            double offset, std::vector<double> const& phases);

/// The part that the scene gives: side clearance @p given and the tip circle @p tip, which is lifted only where the
/// moved flanks would leave no land.
/// @throws NumericalError where it cannot be made
[[nodiscard]] Cleared nominal_part(CaseSurface const& surface, double given, double tip);

/// nominal_part() with the surface's own tip circle, and what is known of it.
struct MadePart
{
    Cleared part;
    TurnsOfSet at_given;  ///< of its flanks with the scene's side clearance
};

/// Whether the side clearance that the scene gives is no less than that of @p cleared; "auto" gives none.
[[nodiscard]] bool is_enough(ContactContext const& context, Cleared const& cleared);

/// The part with the side clearance that the scene gives, where nothing enters its flanks over a full turn, nor in the
/// map at @p phases: with the surface's own tip circle, larger only where every slice's land and rim ask for it. Absent
/// where @p cleared takes its place, or has the same tip circle.
/// @param made  where it is known
[[nodiscard]] std::optional<Cleared> try_nominal_part(CaseSurface const& surface, SliceClearances const& clearances,
                                                      GapsAtRest& rest, Cleared const& cleared,
                                                      std::vector<double> const& phases, MadePart const* made);

}  // namespace hdconj::contact
