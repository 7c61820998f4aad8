// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// An order for jobs of different length: a long one taken last is waited for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hdconj {

/// Indices of @p sizes from the largest on, equal ones in their order.
[[nodiscard]] inline std::vector<std::size_t> largest_first(std::vector<double> const& sizes)
{
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    return order;
}

}  // namespace hdconj
