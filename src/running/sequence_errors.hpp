// SPDX-License-Identifier: GPL-3.0-or-later
// What the figures of a sequence owe to grids, to places between its positions, and to the shape.
#pragma once

#include "running_motion.hpp"
#include "span_plan.hpp"

namespace hdconj::running {

/// Adds the error of the grid: what peak to peak and rms of the difference of both grids come to, times @p safety. Two
/// grids may agree by chance in a single position or order: these get no less than what is usual, with a larger factor.
/// Nothing where the coarse grid has less than half of the positions.
/// @param coarse  the same positions on the coarse grid
void add_grid_error(RunSequence& sequence, RunSequence const& coarse, double safety);

/// Adds the error of the grid to a sequence that is too long for a second one: its positions are as far off as the
/// worst of @p like, first contacts of the same rings at fewer whole pitches. Nothing where that has no estimate.
void add_error_of(RunSequence& sequence, RunSequence const& like);

/// Adds what lies between positions at whole pitches, where other teeth of a ring with errors touch: how far
/// @p between is off the straight lines through the positions. Peak to peak and ripple may be off by the range of that,
/// the rms by its root mean square, an order k by its amplitude there and by what these lines lack of it with N
/// positions, 1 - (sin(x)/x)^2 with x = pi k/N. Where less than half of the places have a result, the errors of
/// @p sequence are not known.
/// @param between  places_between() the positions
/// @param plan     of the positions
void add_places_between(RunSequence& sequence, RunSequence const& between, SpanPlan const& plan,
                        RunningMotion const& motion);

/// Adds what an error of the shape of up to @p angle at each position comes to [rad].
void add_shape_error(RunSequence& sequence, double angle);

}  // namespace hdconj::running
