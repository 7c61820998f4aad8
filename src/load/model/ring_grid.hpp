// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How an elastic drive is divided around the ring.
#pragma once

#include "hdconj/scene.hpp"

namespace hdconj::load {

/// Even angles around the ring: those of the teeth, and more where they are few.
struct RingGrid
{
    int lobes;       ///< how often teeth and lobes repeat around the ring
    int sectors;     ///< and single balls with them
    int per_sector;  ///< teeth
    int steps;       ///< from tooth to tooth

    [[nodiscard]] int angles() const { return per_sector * steps; }
};

[[nodiscard]] RingGrid ring_grid(Scene const& scene);

/// The highest harmonic that these angles resolve.
[[nodiscard]] int highest_harmonic(RingGrid const& grid);

}  // namespace hdconj::load
