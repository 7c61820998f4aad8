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

/// Of planes that have no tooth in common, and of points that lie all to one side, stand in the file again, or are too
/// few on a flank.
/// @param groups  number of flanks with points
void add_notes_of_points(Inspection& result, std::size_t groups);

}  // namespace hdconj::inspect
