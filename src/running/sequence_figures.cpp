// SPDX-License-Identifier: GPL-3.0-or-later
#include "sequence_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "sequence_values.hpp"

namespace hdconj::running {
namespace {

/// How far a curve may rise above the highest of @p values, which are taken at even places of it: half of the fall to
/// the lower neighbour, as for a peak with equally steep sides, or where the lines through two values on either side of
/// a gap beside the highest one meet.
double above_highest(std::vector<double> const& values, bool repeats)
{
    auto const count = static_cast<std::ptrdiff_t>(values.size()),
               top = std::ranges::max_element(values) - values.begin();
    auto const at = [&](std::ptrdiff_t i) {
        return values[static_cast<std::size_t>(repeats ? (i + count) % count
                                                       : std::clamp<std::ptrdiff_t>(i, 0, count - 1))];
    };
    double const highest = at(top);
    double most = 0.5 * (highest - std::min(at(top - 1), at(top + 1)));
    for (std::ptrdiff_t const first : {top - 1, top}) {
        double const rise = at(first) - at(first - 1), fall = at(first + 1) - at(first + 2);
        if (rise > 0 && fall > 0) {
            double const share = std::clamp((at(first + 1) - at(first) + fall) / (rise + fall), 0.0, 1.0);
            most = std::max(most, at(first) + share * rise - highest);
        }
    }
    return most;
}

/// How far both extremes may lie beyond @p values; 0 where there are no places between: teeth have errors of their own
/// at whole pitches.
double beyond_extremes(std::vector<double> values, SpanPlan const& plan)
{
    if (plan.span != RunSpan::tooth_pitch && static_cast<double>(values.size()) >= plan.period)
        return 0;
    double const above = above_highest(values, plan.repeats);
    for (double& value : values)
        value = -value;
    return above + above_highest(values, plan.repeats);
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

/// The highest order that the positions tell: less than half of them, and where some have no result less than half a
/// period over the widest gap. Positions that are rounded to whole pitches stand up to a pitch further apart.
std::size_t highest_order(RunSequence const& sequence, SpanPlan const& plan, double pitch)
{
    constexpr std::size_t most_orders = 200;
    std::size_t const count = sequence.positions.size(), highest = std::min(most_orders, (count - 1) / 2);
    if (count == plan.pitches.size())
        return highest;
    double const rounded =
        plan.span != RunSpan::tooth_pitch && static_cast<double>(plan.pitches.size()) < plan.period ? 1 : 0;
    double widest = sequence.positions.front().angle / pitch + plan.period - sequence.positions.back().angle / pitch;
    for (std::size_t i = 1; i < count; ++i)
        widest = std::max(widest, (sequence.positions[i].angle - sequence.positions[i - 1].angle) / pitch);
    constexpr double rounding = 1e-9;  // of a quotient that is whole
    return std::min(highest,
                    static_cast<std::size_t>(std::ceil(plan.period / (2 * (widest - rounded)) - rounding)) - 1);
}

/// Orders above the highest one look like lower ones: with N positions jN + k for every j like k. An error with kinks
/// has amplitudes that fall as c/k^2, with c from the upper half of the orders; all that look like k come to
/// c((pi/N)^2/sin(pi k/N)^2 - 1/k^2). None where the positions are all there are.
/// @param drift  of the error over the span: a straight line through it is no part of the orders [rad]
void enter_orders(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion, double drift)
{
    double const per_input = motion.held_teeth() / plan.period, begin = sequence.positions.front().angle;
    std::vector<double> values;
    for (RunPosition const& each : sequence.positions)
        values.push_back(each.error - drift * (each.angle - begin) / (plan.period * motion.pitch()));
    for (Harmonic const& each :
         harmonics_at_positions(sequence, values, per_input, highest_order(sequence, plan, motion.pitch())))
        sequence.orders.push_back(
            {each.order * per_input, each.order * per_input * motion.ratio(), each.amplitude, each.phase});
    auto const count = static_cast<double>(sequence.positions.size());
    std::size_t const half = sequence.orders.size() / 2;
    bool const complete = plan.span != RunSpan::tooth_pitch && count >= plan.period;
    double beyond = 0;  // amplitude times the square of the order
    for (std::size_t i = half; !complete && i < sequence.orders.size(); ++i)
        beyond = std::max(beyond, sequence.orders[i].amplitude * std::pow(static_cast<double>(i + 1), 2));
    for (std::size_t i = 0; i < sequence.orders.size(); ++i) {
        auto const k = static_cast<double>(i + 1);
        double const all = std::numbers::pi / count / std::sin(std::numbers::pi * k / count);
        add_amplitude_error(sequence.orders[i], beyond * (all * all - 1 / (k * k)));
    }
}

void enter_torque(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion)
{
    std::vector<double> const torques = column(sequence.positions, &RunPosition::wave_generator_torque);
    Spread const torque = spread_of(torques);
    Spread const by_teeth = spread_of(column(sequence.positions, &RunPosition::torque_by_teeth));
    sequence.mean_torque = torque.mean;
    // over a whole period no work remains in the drive
    double const by_energy = sequence.torque / motion.ratio();
    sequence.mean_torque_error = std::max(std::abs(torque.mean - by_teeth.mean), std::abs(torque.mean - by_energy));
    sequence.torque_ripple = torque.peak_to_peak;
    std::vector<double> apart;
    for (RunPosition const& each : sequence.positions)
        apart.push_back(std::abs(each.wave_generator_torque - torque.mean - (each.torque_by_teeth - by_teeth.mean)));
    sequence.torque_ripple_error = 2 * *std::ranges::max_element(apart) + beyond_extremes(torques, plan);
    std::vector<double> const errors = sizes_of(apart);
    for (std::size_t i = 0; i < errors.size(); ++i)
        sequence.positions[i].torque_error = sequence.mean_torque_error + 2 * errors[i];
}

}  // namespace

void enter_figures(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion,
                   std::optional<double> drift)
{
    std::vector<double> const errors = column(sequence.positions, &RunPosition::error);
    Spread const all = spread_of(errors);
    sequence.peak_to_peak = all.peak_to_peak;
    sequence.rms = all.rms;
    sequence.peak_to_peak_error = beyond_extremes(errors, plan);
    for (std::size_t const first : {0U, 1U}) {
        Spread const half = spread_of(column(sequence.positions, &RunPosition::error, first, 2));
        sequence.peak_to_peak_error = std::max(sequence.peak_to_peak_error, all.peak_to_peak - half.peak_to_peak);
        sequence.rms_error = std::max(sequence.rms_error, std::abs(all.rms - half.rms));
    }
    if (drift)
        enter_orders(sequence, plan, motion, *drift);
    if (sequence.torque != 0)
        enter_torque(sequence, plan, motion);
}

void leave_undetermined(RunSequence& sequence)
{
    for (double RunSequence::*const figure :
         {&RunSequence::peak_to_peak, &RunSequence::peak_to_peak_error, &RunSequence::rms, &RunSequence::rms_error,
          &RunSequence::mean_torque, &RunSequence::mean_torque_error, &RunSequence::torque_ripple,
          &RunSequence::torque_ripple_error})
        sequence.*figure = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hdconj::running
