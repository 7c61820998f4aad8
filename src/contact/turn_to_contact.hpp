// SPDX-License-Identifier: GPL-3.0-or-later
// How far the circular spline turns against the teeth, wave generator and flexspline held, until they touch.
#pragma once

#include "gap_field.hpp"

namespace hdconj::contact {

/// First contact of the flanks on one side.
struct TurnToContact
{
    double turn = 0;  ///< of the teeth against the spaces, clockwise for GapMap::right; negative: out of interference
    GapField::Index where{};  ///< the point that touches, or beside which the flank does
    double gap = 0;           ///< smallest gap there: zero to roundoff [mm]
    SmallestGap at_rest{};    ///< smallest gap of these flanks at turn 0
};

/// The turn at which the smallest gap of the flanks @p flank is zero.
///
/// Gaps count between the points of the map too (smallest_gap()). No gap changes faster than the reach of the flanks
/// times the turn, so points that cannot become zero between the bracket's ends are dropped, and the smallest gap of
/// the rest is closed in on (false position, Illinois). The bracket decides which points are evaluated, so that the
/// function changes from step to step: a solver that owns the bracket, as boost::math::tools::toms748_solve(), cannot
/// do this.
/// @param at_rest  gaps at turn 0
/// @param limit    largest turn looked at, either way [rad]
/// @param touches  smallest gaps at rest of no more than this, either way, are contact: no turn [mm]
/// Accuracy: the gap at the result is zero to some roundings of the reach.
/// @throws NumericalError where nothing touches within the limit
[[nodiscard]] TurnToContact turn_to_contact(GapField const& field, GapMap const& at_rest, int flank, double limit,
                                            int threads, double touches = 0);

}  // namespace hdconj::contact
