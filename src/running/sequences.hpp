// SPDX-License-Identifier: GPL-3.0-or-later
// Sequences of positions of the wave generator.
#pragma once

#include <functional>
#include <string>

#include "span_plan.hpp"
#include "turning_drive.hpp"

namespace hdconj::running {

/// Who asks for positions, and is told of them.
struct SequenceObserver
{
    std::function<bool()> stop;                          ///< null: never
    std::function<void()> on_position;                   ///< null: nobody
    std::function<void(std::string const&)> on_missing;  ///< a position without a result

    [[nodiscard]] bool is_stopped() const { return stop && stop(); }
    /// The same, which is not told of positions without a result.
    [[nodiscard]] SequenceObserver silent() const { return {stop, on_position, {}}; }
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
