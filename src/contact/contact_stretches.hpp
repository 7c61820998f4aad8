// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Contact in one plane: the stretches of a flank whose gap is within a limit.
#pragma once

#include <cstddef>
#include <vector>

#include "gap_field.hpp"

namespace hdconj::contact {

/// A stretch of a flank, its ends as FlankGrid::between() counts.
struct ContactStretch
{
    double from = 0, to = 0;
};

/// Where the gap of a flank of one space in one plane is at most @p limit [mm] at @p turn, in order along the flank.
///
/// The ends are roots of the exact gap (bracketed_root()), to the last bits. No gap changes faster than the flank goes
/// on: where that rules out an edge between two stations the gap is not looked at; elsewhere they are halved up to
/// three times, and two edges within an eighth of them may be missed.
/// @param stride  only every so many stations are looked at, and the last one: what another stride changes tells how
/// much is hidden
[[nodiscard]] std::vector<ContactStretch> contact_stretches(GapField const& field, std::size_t space, int flank,
                                                            std::size_t slice, double turn, double limit,
                                                            std::size_t stride = 1);

/// What those stretches add to the area per length of the axis: the integral of sqrt(1 + v^2) along them, v the speed
/// at which the flank moves along its normal from plane to plane.
///
/// The outward rate of a surface that z cuts: dA = ds dz sqrt(1 + (n . dp/dz)^2), whatever points of two planes belong
/// together. Of v: central differences between the planes beside, at an end plane to the one that is there; 0 with one
/// plane. [mm^2/mm]
[[nodiscard]] double area_per_length(FlankGrid const& grid, int flank, std::size_t slice,
                                     std::vector<ContactStretch> const& stretches);

}  // namespace hdconj::contact
