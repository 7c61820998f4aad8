// SPDX-License-Identifier: GPL-3.0-or-later
// Sine and cosine as plain arithmetic, so that a compiler makes vector instructions of the loop they stand in; private
// to src/envelope.
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

#include "base/loop_targets.hpp"

namespace hdconj::envelope {

struct SineCosine
{
    double sine, cosine;
};

/// Both by Taylor's series on |r| <= pi/4 and the quadrant. Error below 2^-52 for |x| <= 64.
inline SineCosine sine_cosine(double x)
{
    constexpr double to_whole = 0x1.8p52;  // added and taken away: the nearest whole number
    constexpr double quarters = 2 / std::numbers::pi;
    // pi/2 in three parts of 33 bits and the rest: q times each of the first two is exact
    constexpr double part_1 = 0x1.921fb544p+0, part_2 = 0x1.0b4611a6p-34, part_3 = 0x1.3198a2e037073p-69;
    double const raised = x * quarters + to_whole;
    double const q = raised - to_whole;
    double const r = ((x - q * part_1) - q * part_2) - q * part_3;
    double const z = r * r;
    constexpr double s3 = -1.0 / 6, s5 = 1.0 / 120, s7 = -1.0 / 5040, s9 = 1.0 / 362880, s11 = -1.0 / 39916800,
                     s13 = 1.0 / 6227020800.0, s15 = -1.0 / 1307674368000.0;
    constexpr double c2 = -1.0 / 2, c4 = 1.0 / 24, c6 = -1.0 / 720, c8 = 1.0 / 40320, c10 = -1.0 / 3628800,
                     c12 = 1.0 / 479001600.0, c14 = -1.0 / 87178291200.0, c16 = 1.0 / 20922789888000.0;
    double const s = r + r * z * (s3 + z * (s5 + z * (s7 + z * (s9 + z * (s11 + z * (s13 + z * s15))))));
    double const c = 1 + z * (c2 + z * (c4 + z * (c6 + z * (c8 + z * (c10 + z * (c12 + z * (c14 + z * c16)))))));
    auto const quadrant = std::bit_cast<std::uint64_t>(raised);
    std::uint64_t const swap = 0 - (quadrant & 1);
    auto const si = std::bit_cast<std::uint64_t>(s), ci = std::bit_cast<std::uint64_t>(c);
    std::uint64_t const sine = ((si & ~swap) | (ci & swap)) ^ ((quadrant & 2) << 62);
    std::uint64_t const cosine = ((ci & ~swap) | (si & swap)) ^ (((quadrant + 1) & 2) << 62);
    return {std::bit_cast<double>(sine), std::bit_cast<double>(cosine)};
}

}  // namespace hdconj::envelope
