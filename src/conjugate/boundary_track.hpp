// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of boundary pieces, and stretches of all slices that are sampled at the same shares of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "space_curve.hpp"

namespace hdconj::conjugate {

/// Consecutive pieces of one kind that one segment of the tooth traced.
struct BoundaryStretch
{
    OutlineKind kind = OutlineKind::land;
    int segment = -1;
    std::vector<BoundaryPiece> pieces;
};
[[nodiscard]] std::vector<BoundaryStretch> stretches_of(ToothSpaceBoundary const& curve,
                                                        std::vector<BoundaryPiece> const& pieces);

/// What shares are measured by.
enum class Measure
{
    length,   ///< between the stations of its polygon in the wave generator's angle: where on the curve, but not at
              ///< which share of it to more than the polygon's step
    rulings,  ///< length of the curve, not of its polygon, also within a chord: for points of different slices that are
              ///< joined, where what lies between depends on which
    profile   ///< profile parameter of the contact
};

/// A point with the normals of the pieces on either side; they differ at corners only.
struct TrackPoint
{
    Vec2 p = Vec2::Zero();
    Vec2 before = Vec2::Zero();
    Vec2 after = Vec2::Zero();
};

/// Stretches of one slice between two landmarks.
class BoundaryTrack
{
  public:
    /// @param chord  of the polygon that measures lengths [mm]
    BoundaryTrack(ToothSpaceBoundary const& curve, std::vector<BoundaryStretch> const& stretches, Measure measure,
                  double chord);

    /// Whether shares grow along the whole track; a track by profile parameter is of no use otherwise.
    [[nodiscard]] bool monotone() const { return monotone_; }
    [[nodiscard]] double length() const { return length_; }
    /// Shares at which one stretch ends and the next begins.
    [[nodiscard]] std::vector<double> const& joints() const { return joints_; }

    /// The exact contact at @p share, met as the measure says.
    [[nodiscard]] TrackPoint at(double share) const;

  private:
    struct Station
    {
        double share;
        std::size_t piece;
        double u;
    };
    [[nodiscard]] CurvePoint point(Station const& station) const
    {
        return curve_->at(pieces_[station.piece], station.u);
    }
    [[nodiscard]] double between(Station const& a, Station const& b, double share) const;

    ToothSpaceBoundary const* curve_;
    Measure measure_;
    std::vector<BoundaryPiece> pieces_;
    std::vector<Station> stations_;
    std::vector<double> joints_;
    double first_ = 0, last_ = 1;  ///< profile parameters at the ends
    double length_ = 0;
    bool monotone_ = true;
};

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
