// SPDX-License-Identifier: GPL-3.0-or-later
// How far something must be moved until nothing enters it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/solution.hpp"

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

/// Estimated error of a least side clearance, @p found by clearance_accuracy() [mm]; 0 where none is needed.
[[nodiscard]] inline double error_of_least(Tolerance const& tolerance, double found)
{
    return found > 0 ? clearance_accuracy(tolerance) / flattest_slope : 0;
}

/// Enters that the side clearance was found to @p error [mm]: both flanks move with it, each as far as it does but
/// where it meets the tip circle aslant.
inline void add_side_clearance_error(ErrorEstimate& estimate, double error)
{
    estimate.side_clearance = error;
    estimate.clearance += error;
    estimate.land += 2 * error;
}

/// The distance at which @p clearance(distance) is zero to @p enough, from the guess @p distance; of a clearance that
/// jumps there, the distance to @p enough beyond which it is positive.
///
/// Secant steps, the first of slope 1. A tooth may meet the flank's end nearly along it: where the clearance grows by
/// less than flattest_slope steps double, until it has both signs, and then the range between them is halved. Nothing
/// where 60 steps do not settle.
template <class Clearance>
[[nodiscard]] std::optional<double> side_clearance_search(Clearance&& clearance, double distance, double enough)
{
    constexpr int budget = 60;
    double const far = std::numeric_limits<double>::infinity();
    double before = distance, at_before = 0;
    double low = -far, high = far;  // where the clearance is known to be negative, and positive
    for (int i = 0; i < budget; ++i) {
        double const here = clearance(distance);
        if (std::abs(here) <= enough)
            return distance;
        (here < 0 ? low : high) = distance;
        if (high - low > 0 && high - low <= enough)
            return high;
        double const step = distance - before;
        bool const is_first = step == 0;
        double const slope = is_first ? 1 : (here - at_before) / step;
        bool const is_flat = slope <= flattest_slope, is_closed = low < high && high - low < far;
        double next = is_flat ? distance + std::copysign(2 * step, -here) : distance - here / slope;
        if (is_closed && (is_flat || next <= low || next >= high))
            next = 0.5 * (low + high);
        before = distance;
        at_before = here;
        distance = next;
    }
    return std::nullopt;
}

}  // namespace hdconj::contact
