// SPDX-License-Identifier: GPL-3.0-or-later
// Advice that goes with the faults of a drive's geometry.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::drive {

/// Says that the radial deformation @p w0 is unusual and what the flanks need to touch.
/// @param geometric  whether @p faults may follow from the deformation; it is said first then
void say_likely_cause(Scene const& scene, double w0, bool geometric, Faults& faults);

}  // namespace hdconj::drive
