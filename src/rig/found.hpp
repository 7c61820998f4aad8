// SPDX-License-Identifier: GPL-3.0-or-later
// Values found by a fit, and their mean.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hdconj/measured.hpp"
#include "numeric/moments.hpp"

namespace hdconj::rig {

/// A fitted value and its standard error from the residuals of the fit.
struct Found
{
    double value = 0, error = 0;
};

/// The mean, with the larger of two errors: what each fit states, and the scatter of the values.
[[nodiscard]] inline Estimate mean_of(std::vector<Found> const& found)
{
    Estimate result;
    result.count = static_cast<int>(found.size());
    double const n = result.count;
    double own = 0, squares = 0;
    for (auto const& each : found) {
        result.value += each.value / n;
        own += each.error * each.error / n;
    }
    for (auto const& each : found)
        squares += std::pow(each.value - result.value, 2);
    double const scatter = found.size() > 1 ? squares / (n - 1) : 0;
    result.error = found.empty() ? 0 : std::sqrt(std::max(own, scatter) / n);
    return result;
}

/// The value that a share of the others lie below. Domain: not empty.
[[nodiscard]] inline double quantile(std::vector<double> values, double share)
{
    auto const at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::ranges::nth_element(values, at);
    return *at;
}

/// Standard deviation of normal noise about zero by the upper quartile of its size, on which a fifth of strays has
/// little influence. The median would be zero for readings in coarse steps.
[[nodiscard]] inline double deviation_of(std::vector<double> values)
{
    for (double& each : values)
        each = std::abs(each);
    constexpr double quartile = 1.1503;  // of |x| for standard normal x
    return quantile(std::move(values), 0.75) / quartile;
}

/// The smallest difference of two values; two that differ by less than 1e-9 of their range are one.
[[nodiscard]] inline double smallest_step(std::vector<double> values)
{
    std::ranges::sort(values);
    double const range = values.back() - values.front();
    constexpr double rounding = 1e-9;  // of the range: two spellings of one reading
    double step = range;
    for (std::size_t i = 1; i < values.size(); ++i) {
        double const here = values[i] - values[i - 1];
        step = here > rounding * range ? std::min(step, here) : step;
    }
    return step;
}

}  // namespace hdconj::rig
