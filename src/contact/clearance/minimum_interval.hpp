// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Between which planes the least of some values may lie.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hdconj::contact {

/// A stretch of the axis [mm].
struct PlaceRange
{
    double from = 0, to = 0;
};

/// From the plane before the first that is within @p error of the least to the plane after the last; between two planes
/// no place is told. Ends with the outermost planes.
/// @param z       increasing [mm]
/// @param excess  of each plane over the least, which one of them is
[[nodiscard]] inline PlaceRange place_range(std::vector<double> const& z, std::vector<double> const& excess,
                                            double error)
{
    std::size_t first = z.size(), last = 0;
    for (std::size_t k = 0; k < z.size(); ++k)
        if (excess[k] <= error) {
            first = std::min(first, k);
            last = k;
        }
    if (first == z.size())
        return {z.front(), z.back()};
    return {z[first > 0 ? first - 1 : 0], z[std::min(last + 1, z.size() - 1)]};
}

}  // namespace hdconj::contact
