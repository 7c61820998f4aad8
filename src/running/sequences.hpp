// SPDX-License-Identifier: GPL-3.0-or-later
// Sequences of positions of the wave generator and what they come to.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/running.hpp"
#include "turning_drive.hpp"

namespace hdconj::running {

/// Where the positions of a sequence stand.
struct SpanPlan
{
    RunSpan span = RunSpan::tooth_pitch;
    std::vector<double> pitches;  ///< that the wave generator has turned at each position, increasing
    double period = 1;            ///< after which all comes again [pitches]
};

/// Positions over one tooth pitch, even.
[[nodiscard]] SpanPlan tooth_pitch_plan(int positions);

/// Positions over @p period pitches, each a whole number, as even as these can be.
[[nodiscard]] SpanPlan whole_pitch_plan(RunSpan span, int period, int positions);

/// Enters orders, peak to peak, rms, and the figures of the torque. Errors are those of the positions: how peak to peak
/// and rms change at most where either half of them, every second one, is left out; of an order, what higher ones look
/// like it. Those of the torque are the differences of both of its ways, that of its mean also the difference from T/i.
void enter_figures(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion);

/// Adds the error of the grid: what peak to peak and rms of the difference of both grids come to, times @p safety. Two
/// grids may agree by chance in a single position or order: these get no less than what is usual, with a larger factor.
/// Nothing where the coarse grid has less than half of the positions.
/// @param coarse  the same positions on the coarse grid
void add_grid_error(RunSequence& sequence, RunSequence const& coarse, double safety);

/// Adds the error of the grid to a sequence that is too long for a second one: its positions are as far off as the
/// worst of @p like, first contacts of the same rings at fewer whole pitches. Nothing where that has no estimate.
void add_error_of(RunSequence& sequence, RunSequence const& like);

/// Adds what an error of the shape of up to @p angle at each position comes to [rad].
void add_shape_error(RunSequence& sequence, double angle);

/// Who asks for positions, and is told of them.
struct SequenceObserver
{
    std::function<bool()> stop;                          ///< null: never
    std::function<void()> on_position;                   ///< null: nobody
    std::function<void(std::string const&)> on_missing;  ///< a position without a result
};

/// A sequence of first contacts. @param turn_at  turn of the flexspline after so many pitches [rad]
[[nodiscard]] RunSequence first_contacts(SpanPlan const& plan, RunningMotion const& motion,
                                         std::function<double(double)> const& turn_at,
                                         SequenceObserver const& observer);

/// A sequence of balances, each from its neighbour on. Positions without a balance are left out.
/// @param torque  on the output [N mm]
[[nodiscard]] RunSequence balanced(SpanPlan const& plan, TurningDrive const& drive, RunningMotion const& motion,
                                   double torque, SequenceObserver const& observer);

}  // namespace hdconj::running
