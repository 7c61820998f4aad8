// SPDX-License-Identifier: GPL-3.0-or-later
#include "sequence_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hdconj::running {

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

std::vector<Harmonic> harmonics_at_positions(RunSequence const& sequence, std::vector<double> const& values,
                                             double per_input, std::size_t highest)
{
    std::vector<double> x;
    for (RunPosition const& each : sequence.positions)
        x.push_back(per_input * each.angle);
    return harmonics(x, values, static_cast<int>(highest));
}

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

void add_amplitude_error(RunOrder& order, double error)
{
    order.amplitude_error += error;
    order.phase_error =
        order.amplitude_error < order.amplitude ? std::asin(order.amplitude_error / order.amplitude) : std::numbers::pi;
}

}  // namespace hdconj::running
