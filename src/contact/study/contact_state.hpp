// SPDX-License-Identifier: GPL-3.0-or-later
// Contact and play of one surface at one angle of the wave generator.
#pragma once

#include <cmath>

#include "gaps_at_rest.hpp"
#include "hdconj/contact.hpp"
#include "refined_flanks.hpp"

namespace hdconj::contact {

/// Everything at one phase.
struct PhaseWork
{
    ContactContext const& context;
    RefinedFlanks& finer;
    GapsAtRest& rest;
    double phase;
    double off;          ///< how far the side clearance may be from the least that clears [mm]
    double clear;        ///< no gap of a full turn is smaller with these flanks [mm]
    double lever;        ///< no gap changes faster with the turn [mm/rad]
    bool errors = true;  ///< estimated too

    /// No gap at @p turn is smaller [mm].
    [[nodiscard]] double floor(double turn) const { return clear - lever * std::abs(turn); }
};

/// Play with some flanks at one phase, and its error.
struct PlayEstimate
{
    double turn = 0, error = 0;
};

/// Play with the flanks @p grid; of @p work the finer surface is that of these flanks.
[[nodiscard]] PlayEstimate play(PhaseWork const& work, FlankGrid const& grid);

/// Contact of @p grid; of @p work the finer surface is the same. @p map, where given, gets the gaps after take-up.
[[nodiscard]] ContactState contact_state(PhaseWork const& work, FlankGrid const& grid, std::shared_ptr<GapMap>* map);

}  // namespace hdconj::contact
