// SPDX-License-Identifier: GPL-3.0-or-later
// The lobe cut at the breaks of its motion: ranges on which everything is analytic.
#pragma once

#include <cmath>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::envelope {

/// A range of the motion's parameter; at a break the next one goes on.
struct SmoothRange
{
    double a = 0;
    double b = 0;
    bool from_break = false;  ///< a is a break, not the lobe's start
    bool to_break = false;    ///< b is one rounding of the lobe before a break
};

/// The lobe [-pi/n, pi/n] as ranges between breaks, in order. A break itself belongs to the range after it, where
/// one-sided derivatives are taken; the range before it ends one rounding of the lobe before.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::vector<SmoothRange> smooth_ranges(Motion const& motion)
{
    double const end = motion.half_lobe();
    double const rounding = 2 * unit_roundoff * end;
    std::vector<SmoothRange> ranges{{-end, end, false, false}};
    for (double u : motion.breaks()) {
        if (!(u > -end))
            continue;
        ranges.back().b = u - rounding;
        if (!(u < end))
            break;
        ranges.back().to_break = true;
        ranges.push_back({u, end, true, false});
    }
    return ranges;
}

/// Whether @p to is the instant @p from, or follows it across a break.
[[nodiscard]] inline bool same_instant(double from, double to)
{
    constexpr double roundings = 16 * unit_roundoff;
    return std::abs(to - from) <= roundings;
}

/// Whether contacts that reach a joint of two profile pieces from either side reach it together: each side solves for
/// the instant with its own roundings.
[[nodiscard]] inline bool same_at_joint(double from, double to)
{
    constexpr double roundings = 0x1p-30;
    return std::abs(to - from) <= roundings;
}

}  // namespace hdconj::envelope
