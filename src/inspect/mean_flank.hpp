// SPDX-License-Identifier: GPL-3.0-or-later
// The mean flank of the measured teeth, as points of a tooth.
#pragma once

#include <vector>

#include "ring_figures.hpp"

namespace hdconj::inspect {

/// The right flank of a symmetric tooth that is the mean of all flanks of the first plane, from tip to root. On the
/// circular spline that is the right wall of the mean tooth space.
///
/// The deviations of all flanks, each turned to its own position, are smoothed by a polynomial of least squares against
/// arc length: a parabola, or of the degree up to 5 whose highest term noise makes in fewer than one of 1000
/// measurements (Student). Waves that are shorter than about half a flank are left out with the noise. Beyond the
/// outermost points the parabola goes on that has value, slope and bend of the polynomial there. The flank is turned by
/// half the mean excess of the thickness. It is cut or continued straight at the heights at which the nominal one ends;
/// an end so nearly level that this would move it by more than 1/160 of the flank stays where it is, and what bends
/// back beyond the highest or the lowest point is left out. In NominalPart::frame.
/// @returns nothing where one side has no flank
[[nodiscard]] std::vector<Vec2> mean_flank(RingData const& data);

}  // namespace hdconj::inspect
