// SPDX-License-Identifier: GPL-3.0-or-later
// Other numbers with which a refused tooth can be built.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::drive {

/// Adds to the remedy of @p fault values of one key, or of two, with which the tooth can be built and fits its pitch:
/// those nearest to the given ones that a search in steps of a fiftieth finds. A tooth whose flanks cross gets a usual
/// tip land where there is room for it. Where there are no such values the remedy says so, and with which value of a
/// key this fault is gone. A family without numbers is left alone.
/// @param fault  of the tooth of the flexspline, or of the circular spline where @p outside
void advise_tooth(Scene const& scene, bool outside, Fault& fault);

}  // namespace hdconj::drive
