// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader should know of a placement and of the points beyond the intervals.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "ring_figures.hpp"

namespace hdconj::inspect {

/// Whether the teeth hardly tell a shift from errors that all flanks share.
/// @param known    errors that the registration knows
/// @param inverse  covariance of the unknowns beside common errors
/// @param rows     derivatives of the deviations
void add_note_of_sector(Inspection& result, CommonErrorsKnown known, Eigen::MatrixXd const& inverse,
                        Eigen::MatrixXd const& rows);

/// Whether a shift takes up the places of single teeth, and what this makes of the figures. Intervals do not contain
/// it: they hold the figure of the same part without noise, which is laid by the same places. The places are taken to
/// be independent of tooth and tooth; both flanks of a tooth may stand off together, or apart as of a thick tooth. How
/// far they do is what shift, turn and thickness leave of the measured positions, so that a figure divided by what the
/// places make of it follows Student's distribution.
/// @param result  with its placement and its figures
void add_note_of_places(Inspection& result, RingData const& data);

/// Of planes that have no tooth in common, and of points that lie all to one side, stand in the file again, or are too
/// few on a flank.
/// @param groups  number of flanks with points
void add_notes_of_points(Inspection& result, std::size_t groups);

}  // namespace hdconj::inspect
