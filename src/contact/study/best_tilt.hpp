// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the tilt of a surface.
#pragma once

#include <functional>

#include "hdconj/contact.hpp"

namespace hdconj::contact {

/// The best of @p value over the interval of @p options: an even scan, and a golden-section search around its best
/// point. A tilt at which no surface can be made is no candidate, and is counted.
/// @param largest  whether the largest value is the best, or the least
/// @throws NumericalError, that of the last one, where none can be made
[[nodiscard]] BestTilt best_tilt(TiltGoal goal, TiltKind kind, ContactOptions const& options, bool largest,
                                 std::function<double(double)> const& value);

}  // namespace hdconj::contact
