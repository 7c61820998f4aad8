// SPDX-License-Identifier: GPL-3.0-or-later
// The mean flank of the measured teeth, as points of a tooth.
#pragma once

#include <vector>

#include "ring_figures.hpp"

namespace hdconj::inspect {

/// The right flank of a symmetric tooth that is the mean of all flanks of the first plane, from tip to root. On the
/// circular spline that is the right wall of the mean tooth space.
///
/// The deviations of all flanks, each turned to its own position, are smoothed by the polynomial of degree 5 of least
/// squares against arc length: waves that are shorter than about half a flank are left out with the noise. The flank is
/// turned by half the mean excess of the thickness, and cut or continued straight at the heights at which the nominal
/// one ends, in NominalPart::frame.
/// @returns nothing where one side has no flank
[[nodiscard]] std::vector<Vec2> mean_flank(RingData const& data);

}  // namespace hdconj::inspect
