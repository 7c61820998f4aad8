// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Random numbers that are the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace designs {

/// Numbers from a seed. Own mapping to an interval: the standard's distributions differ between libraries.
class Draws
{
  public:
    explicit Draws(std::uint64_t seed) : engine_(seed) {}

    double between(double low, double high)
    {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int whole(int low, int high) { return static_cast<int>(std::floor(between(low, high + 1))); }
    bool chance(double share) { return between(0, 1) < share; }
    double about(double value, double share) { return value * between(1 - share, 1 + share); }
    double sign() { return chance(0.5) ? -1 : 1; }

  private:
    std::mt19937_64 engine_;
};

}  // namespace designs
