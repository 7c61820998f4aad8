// SPDX-License-Identifier: GPL-3.0-or-later
// The gap map at the points of a mesh, and what a picture asks of a map.
#pragma once

#include <optional>
#include <vector>

#include "spline_surface.hpp"

namespace hdconj::io {

/// One flank of one tooth space of a map.
struct FlankOfMap
{
    std::size_t space = 0;
    int flank = GapMap::right;
    bool in_contact = false;  ///< some of it
};

/// The flank of the driving side (right) with the largest area in contact (gap <= @p contact_gap), weighted by slice
/// and station. Where none there is in contact the left one with the largest; where none is at all the one with the
/// smallest gap.
[[nodiscard]] FlankOfMap fullest_flank(GapMap const& map, double contact_gap);

/// Where the points of one flank lie that a map is of. Stations are shares of the length in the middle slice; points of
/// the slices with the same index belong together (design 3.4), so that a station is a place between two indices, the
/// same in all slices.
class FlankStations
{
  public:
    /// @throws std::logic_error where @p spline has no landmarks
    FlankStations(CircularSplineOutline const& spline, int flank);

    /// Station of an outline point, 0 at the land corner ... 1 at the flank end; nothing off the flank.
    [[nodiscard]] std::optional<double> at(std::size_t index) const;

    /// Distances of @p stations from the land corner along the outline of a slice [mm].
    [[nodiscard]] std::vector<double> along(std::vector<Vec2> const& outline,
                                            std::vector<double> const& stations) const;

  private:
    /// Distances of the flank's points from the land corner.
    [[nodiscard]] std::vector<double> lengths(std::vector<Vec2> const& outline) const;

    int land_, end_;
    std::vector<double> station_;  ///< of the flank's points, from the land corner
};

/// Gap [mm] at each point of @p surface, linear between stations; NaN off the flanks. One tooth: that of @ref
/// fullest_flank.
/// @throws std::logic_error where map and outline do not match
[[nodiscard]] std::vector<double> gaps_of(Surface const& surface, ContactStudy const& study, bool ring);

}  // namespace hdconj::io
