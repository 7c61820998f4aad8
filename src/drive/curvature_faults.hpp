// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of a neutral curve that is hollow.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::drive {

/// The deformed neutral curve must be convex: a ring on a wave generator never bends inwards.
void validate_curvature(Scene const& scene, wavegen::AnyWaveShape const& shape, double r_m, Faults& faults);

}  // namespace hdconj::drive
