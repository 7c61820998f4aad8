// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The strip of a flank that belongs to one contact; private to src/load.
#pragma once

#include "gap_minima.hpp"

namespace hdconj::load {

/// Part of the flank around a minimum in which the gap exceeds that of the minimum by no more than the depth of the
/// strip: distances along the flank from the minimum to both ends [mm], at most a tenth of the flank each.
struct ContactStrip
{
    double behind, ahead;
};
[[nodiscard]] ContactStrip contact_strip(FlankView const& view, GapMinimum const& at,
                                         contact::GapField::Touch const& touch);

}  // namespace hdconj::load
