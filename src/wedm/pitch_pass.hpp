// SPDX-License-Identifier: GPL-3.0-or-later
// Passes of the wire along one tooth space, and from them the checked programs of all set-ups.
#pragma once

#include <optional>
#include <vector>

#include "residual.hpp"
#include "wire_job.hpp"

namespace hdconj::wedm {

/// Parts of the tolerance: chords of the moves, chords of arcs before thinning. The rest is for the contour, of which
/// the tolerance is at least ten times the error (check_wedm).
inline constexpr double share_of_moves = 0.8;
inline constexpr double share_of_arcs = 1.0 / 16;

/// A pass along tooth space 0.
struct PitchPass
{
    double offset = 0, stock = 0;
    PairedPath path;         ///< centre of the wire from mid-land to mid-land
    double guide_chord = 0;  ///< error of straight moves at the guides
    Uncut uncut;
};

/// The pass of @p job by a wire of @p wire_diameter that leaves @p stock [mm].
[[nodiscard]] PitchPass pitch_pass(WireJob const& job, double wire_diameter, double stock);

/// All passes of @p job.
[[nodiscard]] std::vector<PitchPass> pitch_passes(WireJob const& job);

/// Fewest decimals, more than those of @p job, with which no move of its pass at @p offset is shorter than
/// least_block(); nothing where there are none.
[[nodiscard]] std::optional<int> fitting_decimals(WireJob job, double offset);

/// Whether @p pass may leave more than wedm.residual_limit: with the error of what is left.
[[nodiscard]] bool leaves_too_much(WireJob const& job, PitchPass const& pass);

/// The thickest wire on sale [mm], thinner than the one of @p job, whose last pass does not; nothing where none is so
/// thin.
[[nodiscard]] std::optional<double> fitting_wire(WireJob const& job);

/// Whether the last pass of @p job keeps the limit wherever within the tolerance its path runs. Cheaper than the pass.
[[nodiscard]] bool fits_well(WireJob const& job);

/// What is wrong where the last of @p passes does. Names the thickest wire on sale that leaves no more than the limit,
/// the limit that would do, and how far the teeth stay clear of what is left.
/// @param reached  the faces that the teeth of the unloaded flexspline reach, if they are known
[[nodiscard]] Fault residual_fault(WireJob const& job, std::vector<PitchPass> const& passes,
                                   std::optional<WireFaces> const& reached);

/// The program of one set-up, checked.
/// @throws NumericalError  a check failed: all failures in one message
[[nodiscard]] WireProgram set_up_program(WireJob const& job, std::vector<PitchPass> const& passes,
                                         WireSetUp const& set_up);

/// The two set-ups, half the spaces each, of a part that a wire around it would cut off. Errors as above.
[[nodiscard]] WireSetUps half_programs(WireJob const& job, std::vector<PitchPass> const& passes);

}  // namespace hdconj::wedm
