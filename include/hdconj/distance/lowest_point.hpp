// SPDX-License-Identifier: GPL-3.0-or-later
// The lowest point of a dip of a distance, smooth or pointed.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::distance {

/// One side of a dip.
struct BracketEnd
{
    double u = 0;         ///< parameter of the motion
    double distance = 0;  ///< [mm]
    double slope = 0;     ///< falling before the dip, rising after it
};

/// Where, of 0 ... width from @p low to @p high, the cubic with their values and slopes is lowest.
[[nodiscard]] inline double lowest_of_cubic(BracketEnd const& low, BracketEnd const& high)
{
    double const width = high.u - low.u;
    double const chord = (high.distance - low.distance) / width;
    double const z = low.slope + high.slope - 3 * chord;
    double const root = std::sqrt(std::max(0.0, z * z - low.slope * high.slope));
    return width * (1 - (high.slope + root - z) / (high.slope - low.slope + 2 * root));
}

/// Where lines with twice the slopes of both sides meet, above the first, and how far they allow less than the least
/// value seen. A dip reaches no deeper if the slopes between are no more than twice those at its sides.
[[nodiscard]] inline double doubt_of(BracketEnd const& low, BracketEnd const& high)
{
    double const width = high.u - low.u;
    double const meet = std::clamp(
        (low.distance - high.distance + 2 * high.slope * width) / (2 * (high.slope - low.slope)), 0.0, width);
    return std::min(low.distance, high.distance) -
           std::min(low.distance + 2 * low.slope * meet, high.distance - 2 * high.slope * (width - meet));
}

/// Follows the dip between @p low (falling) and @p high (rising) with @p look, u -> BracketEnd, until doubt_of() its
/// sides is no more than @p rounding [mm].
///
/// A smooth dip is met by the cubic through both sides. A pointed one, where the foot changes to another piece, is met
/// by their tangents. The slope at the last evaluation shows which it is. Where the cubic comes from one side only, the
/// step is doubled. Where tangents meet at one side or beyond it, or gain little, the next evaluation is at the
/// geometric mean of that distance and the width. After forty evaluations the bracket is halved.
template <class Look>
void minimise_bracketed(Look&& look, BracketEnd low, BracketEnd high, double rounding)
{
    constexpr int budget = 120, usual = 40;
    bool pointed = false, was_pointed = false;
    int on_one_side = 0;
    double doubt_before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < budget; ++k) {
        double const width = high.u - low.u;
        double const last_bits = 4 * unit_roundoff * std::max(std::abs(low.u), std::abs(high.u));
        double const doubt = doubt_of(low, high);
        if (!(width > last_bits) || doubt <= rounding)
            return;
        constexpr double gain = 0.25;
        bool const stalls = !(doubt <= gain * doubt_before);
        doubt_before = doubt;
        double const meet = (low.distance - high.distance + high.slope * width) / (high.slope - low.slope);
        double step = pointed ? meet : lowest_of_cubic(low, high);
        if (!pointed && on_one_side < -1)
            step *= 2;
        if (!pointed && on_one_side > 1)
            step = width - 2 * (width - step);
        if ((pointed && was_pointed && stalls) || !(step > 0 && step < width)) {
            bool const left = meet < 0.5 * width;
            double const mean =
                std::min(std::sqrt(std::max(std::abs(left ? meet : width - meet), last_bits) * width), 0.5 * width);
            step = left ? mean : width - mean;
        }
        if (k > usual)
            step = 0.5 * width;
        BracketEnd const now = look(std::clamp(low.u + step, low.u + 0.25 * last_bits, high.u - 0.25 * last_bits));
        bool const falls = now.slope < 0;
        BracketEnd& side = falls ? low : high;
        was_pointed = pointed;
        pointed = std::abs(now.slope) > 0.5 * std::abs(side.slope);
        on_one_side = falls ? std::min(on_one_side, 0) - 1 : std::max(on_one_side, 0) + 1;
        side = now;
        if (now.slope == 0)
            return;
    }
}

}  // namespace hdconj::distance
