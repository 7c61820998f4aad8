// SPDX-License-Identifier: GPL-3.0-or-later
// A run of boundary pieces as a curve over a share 0 ... 1 of its length or of its profile parameter.
#pragma once

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

}  // namespace hdconj::conjugate
