// SPDX-License-Identifier: GPL-3.0-or-later
// How far something must be moved until nothing enters it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "hdconj/base/tolerance.hpp"

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

/// What clears to this clears [mm]: between its points a flank is known to much less than the scene's tolerance, but
/// not to rounding.
[[nodiscard]] inline double clearance_accuracy(Tolerance const& tolerance)
{
    constexpr double part = 0x1p-6;
    return std::max(part * tolerance.length, tolerance.coincidence());
}

/// Moving a flank along its normal opens a gap at least so much as fast as it moves.
constexpr double flattest_slope = 0.05;

/// The distance at which @p clearance(distance) is zero to @p enough, from the guess @p distance.
///
/// Secant steps, the first of slope 1, none flatter than flattest_slope, since a tooth may meet the flank's end
/// nearly along it. Nothing where 60 steps do not settle.
template <class Clearance>
[[nodiscard]] std::optional<double> side_clearance_search(Clearance&& clearance, double distance, double enough)
{
    constexpr int budget = 60;
    double before = distance;
    double at_before = 0;
    for (int i = 0; i < budget; ++i) {
        double const here = clearance(distance);
        if (std::abs(here) <= enough)
            return distance;
        double const slope = distance != before ? (here - at_before) / (distance - before) : 1;
        before = distance;
        at_before = here;
        distance -= here / (slope > flattest_slope ? slope : 1);
    }
    return std::nullopt;
}

}  // namespace hdconj::contact
