// SPDX-License-Identifier: GPL-3.0-or-later
// How far ruled flanks lie from the conjugate outlines of their planes.
#pragma once

#include <vector>

#include "part_flanks.hpp"

namespace hdconj::contact {

/// Largest distance of the ruled @p flanks, which carry no side clearance, from the conjugate outlines of the planes of
/// @p surface, one by one [mm]. It is taken at all points of the outline, which follow it to the chord error however
/// few points a map over the flanks has.
/// @param tip  radius of the tip circle at z = 0 [mm]
[[nodiscard]] std::vector<double> ruled_deviations(CaseSurface const& surface, PartFlanks const& flanks, double tip);

}  // namespace hdconj::contact
