// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far something must be moved until nothing enters it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::contact {

/// What clears to this clears [mm]: between its points a flank is known to much less than the scene's tolerance, but
/// not to rounding.
[[nodiscard]] inline double clearing_accuracy(Tolerance const& tolerance)
{
    constexpr double part = 0x1p-6;
    return std::max(part * tolerance.length, tolerance.coincidence());
}

/// Moving a flank along its normal opens a gap at least so much as fast as it moves.
constexpr double flattest_clearing = 0.05;

/// The distance at which @p clearance(distance) is zero to @p enough, from the guess @p distance.
///
/// Moving a flank along its normal opens a gap about as fast as it moves, and much more slowly where a tooth meets the
/// flank's end nearly along it: secant steps, the first of slope 1, none flatter than flattest_clearing. Nothing where
/// 60 steps do not settle.
template <class Clearance>
[[nodiscard]] std::optional<double> clearing_search(Clearance&& clearance, double distance, double enough)
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
        distance -= here / (slope > flattest_clearing ? slope : 1);
    }
    return std::nullopt;
}

}  // namespace hdconj::contact
