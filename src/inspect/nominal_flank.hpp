// SPDX-License-Identifier: GPL-3.0-or-later
// One nominal flank: signed distance, foot and arc length.
#pragma once

#include <memory>
#include <vector>

#include "hdconj/distance/tooth_distance.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::inspect {

/// Where a point stands against a flank.
struct FlankFoot
{
    bool on = false;             ///< whether the foot is inside the flank, not at one of its ends
    double distance = 0;         ///< signed, positive outside the material
    Vec2 point = Vec2::Zero();   ///< the foot
    Vec2 normal = Vec2::Zero();  ///< out of the material there
};

/// A flank of a tooth or of a tooth space, in its frame.
class NominalFlank
{
  public:
    /// @param flank       pieces in the order of a profile: from left to right, outward normals to the left
    /// @param root_first  whether the first piece is at the root
    /// @param space       whether the profile's outward normals point into the material
    NominalFlank(profile::Profile flank, bool root_first, bool space);

    [[nodiscard]] FlankFoot operator()(Vec2 const& p) const;
    /// Arc length from the root end to @p foot, a point of the flank.
    [[nodiscard]] double arc_length(Vec2 const& foot) const;
    [[nodiscard]] double length() const { return ends_.back(); }
    /// The point at an arc length from the root end, with the normal out of the material.
    [[nodiscard]] profile::PieceEnd at(double arc_length) const;
    /// Arc lengths from the root end at which pieces meet, ends included, increasing.
    [[nodiscard]] std::vector<double> joints() const;

  private:
    std::unique_ptr<profile::Profile const> flank_;  ///< at a fixed place: the distance points into it
    distance::ToothDistance distance_;
    std::vector<Vec2> starts_;  ///< of the pieces, in the order of the profile
    std::vector<double> ends_;  ///< arc length at the end of each piece, in the order of the profile
    Vec2 first_, last_;
    bool root_first_, space_;
};

}  // namespace hdconj::inspect
