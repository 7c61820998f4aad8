// SPDX-License-Identifier: GPL-3.0-or-later
#include "sequences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "sequence_figures.hpp"

namespace hdconj::running {
namespace {

using Clock = std::chrono::steady_clock;

/// How much the error has changed where @p sequence would begin anew; nothing where that has no result.
template <class Act>
std::optional<double> drift_of(RunSequence const& sequence, SpanPlan const& plan, Act act)
{
    if (plan.repeats)
        return 0;
    try {
        return act(plan.pitches.front() + plan.period).error - sequence.positions.front().error;
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
        return std::nullopt;
    }
}

/// Computes the positions of a sequence in their order. A position without a result is reported and left out. If the
/// whole first quarter has no result, the remaining positions are not tried.
template <class Act>
RunSequence along(SpanPlan const& plan, RunningMotion const& motion, double torque, SequenceObserver const& observer,
                  Act act)
{
    auto const begin = Clock::now();
    RunSequence sequence{.span = plan.span, .torque = torque, .planned = plan.pitches.size()};
    constexpr std::size_t fewest_tried = 3;
    std::size_t const tried = std::max(fewest_tried, plan.pitches.size() / 4);
    std::size_t failed = 0;
    for (double const pitches : plan.pitches) {
        if (failed == tried && sequence.positions.empty()) {
            if (observer.on_missing)
                observer.on_missing(
                    fmt::format("the first {} of {} positions at {:g} N m have no result: the others "
                                "were not tried",
                                failed, plan.pitches.size(), torque * per_newton_metre));
            break;
        }
        if (observer.is_stopped()) {
            if (observer.on_missing)
                observer.on_missing(fmt::format("stopped after {} of {} positions at {:g} N m",
                                                sequence.positions.size(), plan.pitches.size(),
                                                torque * per_newton_metre));
            break;
        }
        try {
            RunPosition position = act(pitches);
            position.angle = pitches * motion.pitch();
            sequence.positions.push_back(position);
        } catch (NumericalError const& error) {
            ++failed;
            if (observer.on_missing)
                observer.on_missing(fmt::format("no result at {:g} N m and {:.4g} pitches of the wave generator: {}",
                                                torque * per_newton_metre, pitches, error.what()));
        }
        if (observer.on_position)
            observer.on_position();
    }
    if (sequence.positions.size() > 2)
        enter_figures(sequence, plan, motion, drift_of(sequence, plan, act));
    else
        leave_undetermined(sequence);
    sequence.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return sequence;
}

}  // namespace

RunSequence first_contacts(SpanPlan const& plan, RunningMotion const& motion,
                           std::function<double(double)> const& turn_at, SequenceObserver const& observer)
{
    return along(plan, motion, 0, observer,
                 [&](double pitches) { return RunPosition{.error = -motion.turn_rate() * turn_at(pitches)}; });
}

RunSequence balanced(SpanPlan const& plan, TurningDrive const& drive, RunningMotion const& motion, double torque,
                     SequenceObserver const& observer)
{
    std::optional<Balance> neighbour;
    return along(plan, motion, torque, observer, [&](double pitches) {
        std::vector<Balance> found =
            drive.balances(pitches, {motion.spline_torque(torque)}, neighbour ? &*neighbour : nullptr);
        neighbour = std::move(found.front());
        return RunPosition{.error = -motion.turn_rate() * neighbour->drive.state.turn,
                           .wave_generator_torque = neighbour->wave_generator_torque,
                           .torque_by_teeth = neighbour->torque_by_teeth};
    });
}

}  // namespace hdconj::running
