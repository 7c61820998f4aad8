// SPDX-License-Identifier: GPL-3.0-or-later
#include "sequences.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "spectrum.hpp"

namespace hdconj::running {
namespace {

using Clock = std::chrono::steady_clock;

/// Peak to peak and root mean square about the mean.
struct Spread
{
    double peak_to_peak = 0, mean = 0, rms = 0;
};

Spread spread_of(std::vector<double> const& values)
{
    Spread result;
    if (values.empty())
        return result;
    auto const [low, high] = std::ranges::minmax_element(values);
    result.peak_to_peak = *high - *low;
    auto const count = static_cast<double>(values.size());
    for (double const value : values)
        result.mean += value / count;
    for (double const value : values)
        result.rms += (value - result.mean) * (value - result.mean) / count;
    result.rms = std::sqrt(result.rms);
    return result;
}

/// Every value, or every @p step-th from @p first on.
std::vector<double> column(std::vector<RunPosition> const& positions, double RunPosition::*value, std::size_t first = 0,
                           std::size_t step = 1)
{
    std::vector<double> result;
    for (std::size_t i = first; i < positions.size(); i += step)
        result.push_back(positions[i].*value);
    return result;
}

void enter_orders(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion)
{
    constexpr int most_orders = 200;
    int const highest = std::min(most_orders, (static_cast<int>(sequence.positions.size()) - 1) / 2);
    double const per_input = motion.held_teeth() / plan.period;
    std::vector<double> x;
    for (RunPosition const& each : sequence.positions)
        x.push_back(per_input * each.angle);
    for (Harmonic const& each : harmonics(x, column(sequence.positions, &RunPosition::error), highest))
        sequence.orders.push_back(
            {each.order * per_input, each.order * per_input * motion.ratio(), each.amplitude, each.phase});
}

void enter_torque(RunSequence& sequence, RunningMotion const& motion)
{
    Spread const torque = spread_of(column(sequence.positions, &RunPosition::wave_generator_torque));
    Spread const by_teeth = spread_of(column(sequence.positions, &RunPosition::torque_by_teeth));
    sequence.mean_torque = torque.mean;
    // over a whole period no work remains in the drive
    double const by_energy = sequence.torque / motion.ratio();
    sequence.mean_torque_error = std::max(std::abs(torque.mean - by_teeth.mean), std::abs(torque.mean - by_energy));
    sequence.torque_ripple = torque.peak_to_peak;
    for (RunPosition const& each : sequence.positions)
        sequence.torque_ripple_error =
            std::max(sequence.torque_ripple_error,
                     2 * std::abs(each.wave_generator_torque - torque.mean - (each.torque_by_teeth - by_teeth.mean)));
}

/// Places of a sequence one after the other; those that @p act has no result for are told and left out.
template <class Act>
RunSequence along(SpanPlan const& plan, RunningMotion const& motion, double torque, SequenceObserver const& observer,
                  Act act)
{
    auto const begin = Clock::now();
    RunSequence sequence{.span = plan.span, .torque = torque};
    for (double const pitches : plan.pitches) {
        if (observer.stop && observer.stop()) {
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
            if (observer.on_missing)
                observer.on_missing(fmt::format("no result at {:g} N m and {:.4g} pitches of the wave generator: {}",
                                                torque * per_newton_metre, pitches, error.what()));
        }
        if (observer.on_position)
            observer.on_position();
    }
    if (sequence.positions.size() > 2)
        enter_figures(sequence, plan, motion);
    sequence.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return sequence;
}

}  // namespace

SpanPlan tooth_pitch_plan(int positions)
{
    SpanPlan plan;
    for (int i = 0; i < positions; ++i)
        plan.pitches.push_back(static_cast<double>(i) / positions - 0.5);
    return plan;
}

SpanPlan whole_pitch_plan(RunSpan span, int period, int positions)
{
    SpanPlan plan{span, {}, static_cast<double>(period)};
    int const count = std::min(period, positions);
    for (int i = 0; i < count; ++i)
        plan.pitches.push_back(std::round(static_cast<double>(i) * period / count));
    return plan;
}

void enter_figures(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion)
{
    Spread const all = spread_of(column(sequence.positions, &RunPosition::error));
    sequence.peak_to_peak = all.peak_to_peak;
    sequence.rms = all.rms;
    for (std::size_t const first : {0U, 1U}) {
        Spread const half = spread_of(column(sequence.positions, &RunPosition::error, first, 2));
        sequence.peak_to_peak_error = std::max(sequence.peak_to_peak_error, all.peak_to_peak - half.peak_to_peak);
        sequence.rms_error = std::max(sequence.rms_error, std::abs(all.rms - half.rms));
    }
    enter_orders(sequence, plan, motion);
    if (sequence.torque != 0)
        enter_torque(sequence, motion);
}

void add_grid_error(RunSequence& sequence, RunSequence const& coarse, double safety)
{
    if (coarse.positions.size() != sequence.positions.size())
        return;
    std::vector<double> difference;
    for (std::size_t i = 0; i < sequence.positions.size(); ++i)
        difference.push_back(sequence.positions[i].error - coarse.positions[i].error);
    Spread const spread = spread_of(difference);
    sequence.peak_to_peak_error += safety * spread.peak_to_peak;
    sequence.rms_error += safety * spread.rms;
    sequence.estimated = true;
}

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
