// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How much flank is in contact: the part of its area where the gap is no larger than a limit.
#pragma once

#include "gap_field.hpp"

namespace hdconj::contact {

/// Areas of the flanks on one side of all tooth spaces.
struct ContactArea
{
    double contact = 0;  ///< [mm^2] with gap <= limit
    double whole = 0;    ///< [mm^2]
    int spaces = 0;      ///< tooth spaces with any contact
    [[nodiscard]] double share() const { return whole > 0 ? contact / whole : 0; }
};

/// Area integral over @p map on the flanks @p flank.
///
/// Every cell between two points and two slices is cut into four triangles at its middle, and the gap is taken linear
/// in each, so that the edge of the contact runs through cells. One slice stands for the whole @p width.
/// @param stride  uses every stride-th point and slice (and the last ones): the difference to stride 1 is about three
/// times the error of
///                stride 1, since the error falls with the square of the spacing
/// Accuracy: second order in the spacing; exact for a gap that is linear in each triangle.
[[nodiscard]] ContactArea contact_area(GapMap const& map, FlankGrid const& grid, int flank, double limit, double width,
                                       std::size_t stride = 1);

}  // namespace hdconj::contact
