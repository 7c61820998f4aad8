// SPDX-License-Identifier: GPL-3.0-or-later
#include "sequence_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

#include "sequence_values.hpp"

namespace hdconj::running {
namespace {

constexpr double single = 3.5;  // of the error of a single position or order over that of the sequence

/// The orders of @p difference, each no less than noise of this size has. Where it is not there at every position, the
/// most that an order may have.
std::vector<double> order_sizes(RunSequence const& sequence, std::vector<double> const& difference)
{
    bool const everywhere = difference.size() == sequence.positions.size();
    double const rms = spread_of(difference).rms,
                 usual = everywhere ? 2 * rms / std::sqrt(static_cast<double>(difference.size())) : 2 * rms;
    std::vector<double> orders(sequence.orders.size(), usual);
    if (everywhere && !orders.empty())
        std::ranges::transform(
            harmonics_at_positions(sequence, difference, sequence.orders.front().per_input, orders.size()),
            orders.begin(), [usual](Harmonic const& each) { return std::max(each.amplitude, usual); });
    return orders;
}

/// Error and torque of the wave generator on the straight line through both neighbours.
/// @param positions  in order of angle
/// @param period     angle after which they come again [rad]; infinite: they do not, and the first and last go on
RunPosition on_line(std::vector<RunPosition> const& positions, double angle, double period)
{
    auto const next = std::ranges::upper_bound(positions, angle, {}, &RunPosition::angle);
    bool const is_first = next == positions.begin(), is_beyond = next == positions.end();
    RunPosition before = is_first ? positions.back() : *std::prev(next), after = is_beyond ? positions.front() : *next;
    if (std::isinf(period) && is_first)
        before = after;
    else if (std::isinf(period) && is_beyond)
        after = before;
    else if (is_first)
        before.angle -= period;
    else if (is_beyond)
        after.angle += period;
    double const width = after.angle - before.angle, share = width != 0 ? (angle - before.angle) / width : 0;
    return {.angle = angle,
            .error = std::lerp(before.error, after.error, share),
            .wave_generator_torque = std::lerp(before.wave_generator_torque, after.wave_generator_torque, share)};
}

/// Peak to peak of @p values and 0.
double range_with_zero(std::vector<double> values)
{
    values.push_back(0);
    return spread_of(values).peak_to_peak;
}

}  // namespace

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
    std::vector<double> const orders = order_sizes(sequence, difference);
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

void add_places_between(RunSequence& sequence, RunSequence const& between, SpanPlan const& plan,
                        RunningMotion const& motion)
{
    if (sequence.positions.empty() || 2 * between.positions.size() < between.planned) {
        sequence.estimated = false;
        return;
    }
    // With these, 16 places in each pitch of 22 drives changed no figure by more than its error (running.md).
    constexpr double of_range = 1.25, of_rms = 0.5, of_orders = 1.75;
    double const period = plan.closed ? plan.period * motion.pitch() : std::numeric_limits<double>::infinity();
    std::vector<double> error, torque;
    for (RunPosition const& each : between.positions) {
        RunPosition const line = on_line(sequence.positions, each.angle, period);
        error.push_back(each.error - line.error);
        torque.push_back(each.wave_generator_torque - line.wave_generator_torque);
    }
    Spread const spread = spread_of(error);
    sequence.peak_to_peak_error += of_range * range_with_zero(error);
    sequence.rms_error += of_rms * std::hypot(spread.rms, spread.mean);
    sequence.torque_ripple_error += of_range * range_with_zero(torque);
    std::vector<double> const orders = order_sizes(sequence, error);
    for (std::size_t i = 0; i < orders.size(); ++i) {
        double const x = std::numbers::pi * static_cast<double>(i + 1) / static_cast<double>(sequence.positions.size());
        double const of_lines = std::pow(std::sin(x) / x, 2);  // an order of the lines over that of the positions
        add_amplitude_error(sequence.orders[i], of_orders * orders[i] + (1 - of_lines) * sequence.orders[i].amplitude);
    }
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
