// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points of the flanks of a tooth space, slice by slice.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hdconj/conjugate/matched_outline.hpp"

namespace hdconj {

/// Points of both flanks of one tooth space, the same for all spaces of a ring; flanks as in GapMap.
struct FlankGrid
{
    std::vector<double> z;         ///< (k) [mm]
    std::vector<double> station;   ///< (p) share of the length in the middle slice, 0 at the land corner ... 1 at the flank end
    /// [flank][slice][point], frame of the tooth space [mm]
    std::array<std::vector<std::vector<Vec2>>, 2> point;
    std::array<std::vector<std::vector<Vec2>>, 2> normal;  ///< unit, into the material

    [[nodiscard]] std::size_t slices() const { return z.size(); }
    [[nodiscard]] std::size_t points() const { return station.size(); }
};

/// Points of a matched outline, @p count on each flank as evenly as its points allow: points of the outline itself, so that one point has one
/// origin in all slices. Fewer where the outline has fewer.
[[nodiscard]] FlankGrid flank_grid(MatchedOutline const& outline, std::vector<double> const& z, int count);

/// The grid moved along its normals into the material by the side clearance @p offset [mm].
[[nodiscard]] FlankGrid moved_into_material(FlankGrid grid, double offset);

}  // namespace hdconj
