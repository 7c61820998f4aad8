// SPDX-License-Identifier: GPL-3.0-or-later
// The fits of all flanks without strays.
#pragma once

#include <vector>

#include "flank_fit.hpp"
#include "hdconj/inspect.hpp"

namespace hdconj::inspect {

/// Fits the flanks @p groups, each without its strays, see strays_of(). Flanks with too few points have no fit.
[[nodiscard]] std::vector<FlankFit> fits_without_strays(PointReader const& read, std::vector<PlanePoint> const& points,
                                                        std::vector<FlankGroup> groups, Placement const& placement);

/// Notes where strays gather at one place of many flanks.
void add_note_of_strays(Inspection& result);

}  // namespace hdconj::inspect
