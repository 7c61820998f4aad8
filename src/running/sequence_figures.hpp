// SPDX-License-Identifier: GPL-3.0-or-later
// What the positions of a sequence come to, and how sure it is.
#pragma once

#include <optional>

#include "running_motion.hpp"
#include "span_plan.hpp"

namespace hdconj::running {

/// Enters orders, peak to peak, rms, and the figures of the torque. Errors are those of the positions: how peak to peak
/// and rms change at most where either half of them, every second one, is left out; of an order, what higher ones look
/// like it. Those of the torque are the differences of both of its ways, that of its mean also the difference from T/i.
/// @param drift  of the error over a span that does not repeat, taken out of the orders [rad]; nothing: it is not
/// known,
///               and there are no orders
void enter_figures(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion,
                   std::optional<double> drift = 0.0);

/// Of fewer than three positions nothing is known: all figures and their errors are NaN.
void leave_undetermined(RunSequence& sequence);

/// Adds the error of the grid: what peak to peak and rms of the difference of both grids come to, times @p safety. Two
/// grids may agree by chance in a single position or order: these get no less than what is usual, with a larger factor.
/// Nothing where the coarse grid has less than half of the positions.
/// @param coarse  the same positions on the coarse grid
void add_grid_error(RunSequence& sequence, RunSequence const& coarse, double safety);

/// Adds the error of the grid to a sequence that is too long for a second one: its positions are as far off as the
/// worst of @p like, first contacts of the same rings at fewer whole pitches. Nothing where that has no estimate.
void add_error_of(RunSequence& sequence, RunSequence const& like);

/// Adds what lies between the positions of a sequence at whole pitches where an eccentricity or a wobble moves the
/// teeth there too: at either extreme as much as the error, and the torque, changes over the tooth pitch of @p pitch,
/// under the same torque.
void add_places_between(RunSequence& sequence, RunSequence const& pitch);

/// Adds what an error of the shape of up to @p angle at each position comes to [rad].
void add_shape_error(RunSequence& sequence, double angle);

}  // namespace hdconj::running
