// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The gap between the teeth as a map over tooth space, flank, slice and point.
#pragma once

#include <cstddef>
#include <vector>

namespace hdconj {

/// Gaps of all flanks of the circular spline at one position, plain data.
///
/// A gap is the signed distance from a point of a circular-spline flank to the nearest flexspline tooth, in the plane of the slice;
/// negative where the point is inside the tooth.
struct GapMap
{
    enum Flank : int
    {
        left = 0,  ///< x < 0 in the frame of the tooth space
        right = 1  ///< x > 0: the flank that the flexspline touches when it is turned clockwise
    };

    std::vector<double> z;        ///< (k) slices [mm]
    std::vector<double> station;  ///< (p) place along the flank: share of its arc length, 0 at the land corner ... 1 at the flank end
    std::vector<double> angle;    ///< (s) centre line of the tooth space, clockwise from the major axis [rad], within half a pitch of -pi ... pi, increasing
    std::vector<double> gap;      ///< (s,2,k,p) [mm]

    [[nodiscard]] std::size_t index(std::size_t space, int flank, std::size_t slice, std::size_t point) const
    {
        return ((space * 2 + static_cast<std::size_t>(flank)) * z.size() + slice) * station.size() + point;
    }
    [[nodiscard]] double at(std::size_t space, int flank, std::size_t slice, std::size_t point) const
    {
        return gap[index(space, flank, slice, point)];
    }
};

}  // namespace hdconj
