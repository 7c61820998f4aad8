// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Side clearance and tip circle with which the flanks of a surface clear.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/contact/flank_grid.hpp"
#include "part_flanks.hpp"
#include "slice_turns.hpp"

namespace hdconj::detail {

/// A surface whose flanks clear: what side clearance and tip circle it takes.
struct Cleared
{
    MatchedOutline outline;   ///< with that tip circle, without the side clearance
    PartFlanks flanks;        ///< of it, to be moved by up to `reach`
    double reach = 0;         ///< [mm]
    double offset = 0;
    double tip = 0;
};

/// Side clearance and tip circle of @p choice, whose land is left with a side clearance of @p at_least too [mm].
///
/// Side clearance moves the flanks of neighbouring spaces towards each other, so the tip circle may have to follow until a land is left; what then
/// is no flank any more needs no clearing. A larger tip circle never asks for more clearance: the loop ends. It also lifts the land corners: the tip circle follows to where the
/// moved flanks begin, since what the surface has beyond them would be entered and ask for far more clearance, and that for more of it again.
/// @throws NumericalError where they do not settle
[[nodiscard]] Cleared clear_flanks(ContactBench const& bench, SliceTurns const& turns, SurfaceChoice const& choice, double at_least);

/// The part that the scene gives: side clearance @p given and the tip circle @p tip, which is lifted only where the moved flanks would leave no land.
/// @throws NumericalError where it cannot be made
[[nodiscard]] Cleared part_as_given(ContactBench const& bench, SurfaceChoice const& choice, double given, double tip);

/// part_as_given() with the surface's own tip circle, and what is known of it.
struct MadePart
{
    Cleared part;
    TurnMinima at_given;   ///< of its flanks with the scene's side clearance
};

/// Whether the side clearance that the scene gives is no less than that of @p cleared; "auto" gives none.
[[nodiscard]] bool is_enough(ContactBench const& bench, Cleared const& cleared);

/// The part with the side clearance that the scene gives, where nothing enters its flanks over a full turn, nor in the map at @p phases: with the surface's own tip circle, larger only where
/// every slice's land and rim ask for it. Absent where @p cleared takes its place, or has the same tip circle.
/// @param made  where it is known
[[nodiscard]] std::optional<Cleared> kept_as_given(ContactBench const& bench, SliceTurns const& turns, SurfaceChoice const& choice, Cleared const& cleared, std::vector<double> const& phases,
                                                   MadePart const* made);

/// Whether the surface can also be made with the tip circle that the scene gives, not only with the one that clears: a case tells of both.
/// @throws NumericalError where not, that of making it
void check_as_made(ContactBench const& bench, SurfaceChoice const& choice, Cleared const& cleared);

/// Offset that leaves no gap below zero where the map is looked at: beside the full turn, with the wall's axial shift. At least @p offset; the flanks of @p cleared then reach as far.
[[nodiscard]] double raised_for_map(ContactBench const& bench, SurfaceChoice const& choice, Cleared& cleared, double offset, std::vector<double> const& phases);

}  // namespace hdconj::detail
