// SPDX-License-Identifier: GPL-3.0-or-later
// One flank of a given tooth as a chain of smooth pieces.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/profile/profile.hpp"

namespace hdconj::cam {

/// A place on a flank: a piece and its local parameter, 0 ... 1.
struct FlankPlace
{
    std::size_t piece = 0;
    double t = 0;
};

/// A point of a flank.
struct PointOnFlank
{
    Vec2 point = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();  ///< unit vector, in the direction of the tooth's traversal
    double curvature = 0;         ///< of the curve, positive where the tangent turns counter-clockwise: convex < 0
    double speed = 0;             ///< length per unit of the parameter [mm]

    /// Outward normal.
    [[nodiscard]] Vec2 normal() const { return left_of(tangent); }
};

/// The right flank of a tooth from the tip land to the root, without lands and corners. The pieces share their tangents
/// where no corner stands between them.
class Flank
{
  public:
    /// @param tooth  whose pieces run from its left root over the tip to its right root
    explicit Flank(profile::Profile const& tooth);

    [[nodiscard]] bool empty() const { return pieces_.empty(); }
    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] PointOnFlank at(FlankPlace const& place) const;

    /// The place @p way [mm] farther along the flank, to first order in each piece, and no farther than the flank's
    /// ends. @return whether the end was not passed
    [[nodiscard]] bool advance(FlankPlace& place, double way) const;

    /// Places about @p step [mm] apart, both ends among them.
    [[nodiscard]] std::vector<FlankPlace> places(double step) const;

    /// Distance along the flank to its tip end and to its root end, to first order [mm].
    [[nodiscard]] double from_tip(FlankPlace const& place) const;
    [[nodiscard]] double from_root(FlankPlace const& place) const { return length_ - from_tip(place); }

  private:
    std::vector<profile::PieceShape> pieces_;
    std::vector<double> begins_;  ///< length before each piece
    double length_ = 0;
};

}  // namespace hdconj::cam
