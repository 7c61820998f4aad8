// SPDX-License-Identifier: GPL-3.0-or-later
#include "sequence_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "spectrum.hpp"

namespace hdconj::running {
namespace {

constexpr double single = 3.5;  // of the error of a single position or order over that of the sequence

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
/// at whole pitches. For rings that are not round: add_places_between().
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

/// Harmonics of @p values at the positions of @p sequence.
/// @param per_input  periods in a turn of the wave generator
/// @param highest    order
std::vector<Harmonic> harmonics_of(RunSequence const& sequence, std::vector<double> const& values, double per_input,
                                   std::size_t highest)
{
    std::vector<double> x;
    for (RunPosition const& each : sequence.positions)
        x.push_back(per_input * each.angle);
    return harmonics(x, values, static_cast<int>(highest));
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

void add_amplitude_error(RunOrder& order, double error)
{
    order.amplitude_error += error;
    order.phase_error =
        order.amplitude_error < order.amplitude ? std::asin(order.amplitude_error / order.amplitude) : std::numbers::pi;
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
         harmonics_of(sequence, values, per_input, highest_order(sequence, plan, motion.pitch())))
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

/// How large each of @p values may be: no less than both neighbours, or the root mean square of all, since a single one
/// may be small by chance.
std::vector<double> sizes_of(std::vector<double> const& values)
{
    double squares = 0;
    for (double const value : values)
        squares += value * value / static_cast<double>(values.size());
    std::vector<double> sizes(values.size(), std::sqrt(squares));
    for (std::size_t i = 0; i < sizes.size(); ++i)
        for (std::size_t const step : {sizes.size() - 1, sizes.size(), sizes.size() + 1})
            sizes[i] = std::max(sizes[i], std::abs(values[(i + step) % sizes.size()]));
    return sizes;
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

void add_grid_error(RunSequence& sequence, RunSequence const& coarse, double safety)
{
    std::size_t const count = sequence.positions.size();
    std::vector<double> difference, of_torque;
    for (RunPosition const& each : coarse.positions) {
        auto const found = std::ranges::find(sequence.positions, each.angle, &RunPosition::angle);
        if (found == sequence.positions.end())
            continue;
        difference.push_back(found->error - each.error);
        of_torque.push_back(found->wave_generator_torque - each.wave_generator_torque);
    }
    if (2 * difference.size() < count)
        return;
    Spread const spread = spread_of(difference);
    sequence.peak_to_peak_error += safety * spread.peak_to_peak;
    sequence.rms_error += safety * spread.rms;
    sequence.torque_ripple_error += safety * spread_of(of_torque).peak_to_peak;
    bool const everywhere = difference.size() == count;
    // what noise of this size has in a single order; where positions are missing, the most that an order may have
    double const usual = everywhere ? 2 * spread.rms / std::sqrt(static_cast<double>(count)) : 2 * spread.rms;
    std::vector<double> orders(sequence.orders.size(), usual);
    if (everywhere && !orders.empty())
        std::ranges::transform(harmonics_of(sequence, difference, sequence.orders.front().per_input, orders.size()),
                               orders.begin(),
                               [usual](Harmonic const& each) { return std::max(each.amplitude, usual); });
    for (std::size_t k = 0; k < orders.size(); ++k)
        add_amplitude_error(sequence.orders[k], single * safety * orders[k]);
    for (double& each : difference)
        each -= spread.mean;
    std::vector<double> errors = sizes_of(difference), torque_errors = sizes_of(of_torque);
    for (std::vector<double>* const all : {&errors, &torque_errors})
        if (!everywhere)
            all->assign(count, *std::ranges::max_element(*all));
    for (std::size_t i = 0; i < count; ++i) {
        sequence.positions[i].error_error += single * safety * errors[i];
        sequence.positions[i].torque_error += single * safety * torque_errors[i];
    }
    sequence.estimated = true;
}

void add_error_of(RunSequence& sequence, RunSequence const& like)
{
    if (!like.estimated || like.positions.empty())
        return;
    double const largest = std::ranges::max_element(like.positions, {}, &RunPosition::error_error)->error_error;
    sequence.peak_to_peak_error += 2 * largest / single;
    sequence.rms_error += largest / single;
    for (RunOrder& each : sequence.orders)
        add_amplitude_error(each, 2 * largest / std::sqrt(static_cast<double>(sequence.positions.size())));
    for (RunPosition& each : sequence.positions)
        each.error_error += largest;
    sequence.estimated = true;
}

void add_places_between(RunSequence& sequence, RunSequence const& pitch)
{
    sequence.peak_to_peak_error += 2 * (pitch.peak_to_peak + pitch.peak_to_peak_error);
    sequence.torque_ripple_error += 2 * (pitch.torque_ripple + pitch.torque_ripple_error);
}

void add_shape_error(RunSequence& sequence, double angle)
{
    sequence.peak_to_peak_error += 2 * angle;
    sequence.rms_error += angle;
    for (RunOrder& each : sequence.orders)
        add_amplitude_error(each, angle);
    for (RunPosition& each : sequence.positions)
        each.error_error += angle;
    sequence.estimated = true;
}

}  // namespace hdconj::running
