// SPDX-License-Identifier: GPL-3.0-or-later
// Values found by a fit, and their mean.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hdconj/measured.hpp"

namespace hdconj::rig {

/// A fitted value and its standard errors.
struct Found
{
    double value = 0;
    double error = 0;   ///< of its own
    double shared = 0;  ///< that other values may have too
    [[nodiscard]] double both() const { return std::hypot(error, shared); }
};

/// The mean, with the larger of two errors: what each fit states, and the scatter of the values. What they share does
/// not become less.
[[nodiscard]] inline Estimate mean_of(std::vector<Found> const& found)
{
    Estimate result;
    result.count = static_cast<int>(found.size());
    double const n = result.count;
    double own = 0, squares = 0, shared = 0;
    for (auto const& each : found) {
        result.value += each.value / n;
        own += each.error * each.error / n;
        shared += each.shared / n;
    }
    for (auto const& each : found)
        squares += std::pow(each.value - result.value, 2);
    double const scatter = found.size() > 1 ? squares / (n - 1) : 0;
    result.error = found.empty() ? 0 : std::hypot(std::sqrt(std::max(own, scatter) / n), shared);
    return result;
}

}  // namespace hdconj::rig
