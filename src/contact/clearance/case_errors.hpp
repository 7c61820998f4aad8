// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated errors of what a case tells of full turns.
#pragma once

#include "clear_flanks.hpp"
#include "hdconj/contact.hpp"
#include "slice_clearance.hpp"

namespace hdconj::contact {

/// The surface as made and cleared, of which errors are asked.
struct Surfaces
{
    Cleared const& cleared;
    conjugate::MatchedOutline const& outline;  ///< as made
    PartFlanks const& flanks;                  ///< of it
    double tip;                                ///< as made
    double given;                              ///< side clearance of the scene
    TurnsOfSet const& flank;                   ///< of the flanks as made and that side clearance
    TurnsOfSet const& root;                    ///< around the bottom
};

/// Errors of all that is told of full turns, and how far a ruled surface deviates, into @p result, which holds the
/// rest.
/// @param errors  false: the deviation alone
void write_errors(CaseSurface const& surface, SliceClearances const& clearances, Surfaces const& made, bool errors,
                  ContactCase& result);

}  // namespace hdconj::contact
