// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How an elastic drive is divided around the ring.
#pragma once

#include "hdconj/scene/scene.hpp"

namespace hdconj::detail {

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

}  // namespace hdconj::detail
