// SPDX-License-Identifier: GPL-3.0-or-later
// What bodies that yield under load need of the drive's dimensions.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::drive {

/// The body of the circular spline against its root circle, and the balls against the ring that they run in.
void validate_yielding(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults);

}  // namespace hdconj::drive
