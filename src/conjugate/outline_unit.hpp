// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of all slices that are sampled at the same shares.
#pragma once

#include <algorithm>
#include <vector>

#include "boundary_track.hpp"

namespace hdconj::conjugate {

struct OutlineUnit
{
    OutlineKind kind = OutlineKind::land;
    int segment = -1;
    std::vector<BoundaryTrack> tracks;        ///< (k)
    std::vector<double> stations;             ///< shares, from 0 to 1
    std::vector<std::vector<TrackPoint>> at;  ///< (k, stations)
    double chord = 0;                         ///< bound of the largest chord error in any slice [mm]

    /// Of the longest slice [mm].
    [[nodiscard]] double length() const
    {
        double longest = 0;
        for (BoundaryTrack const& track : tracks)
            longest = std::max(longest, track.length());
        return longest;
    }
};

/// Cuts every interval of stations that is too coarse in any slice, until none is.
///
/// A chord's error is estimated from its ends where its neighbours bend as it does; where curvature changes, at ends
/// and where chords are few the slice is looked at between the ends (chord_bound()).
/// @param chord      [mm]
/// @param intervals  at least so many, and where several stretches are sampled as one their joints
/// @throws NumericalError when that cannot be met
void sample(OutlineUnit& unit, double chord, int intervals, int threads);

}  // namespace hdconj::conjugate
