// SPDX-License-Identifier: GPL-3.0-or-later
// The value at a place among others in growing order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hdconj::numeric {

/// The value that a @p share of the others lie below: the median for 0.5, of two middle values the larger.
/// Domain: at least one value, and a share from 0 to less than 1.
[[nodiscard]] inline double quantile(std::vector<double> values, double share)
{
    auto const at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::ranges::nth_element(values, at);
    return *at;
}

}  // namespace hdconj::numeric
