// SPDX-License-Identifier: GPL-3.0-or-later
// The nominal part: its two flanks in each measured plane, and where they stand on the ring.
#pragma once

#include <memory>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/distance/tooth_distance.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"

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
    struct PieceStart
    {
        Vec2 point;
        double squared_reach;  ///< of a disc about the point that holds the piece [mm^2]
    };

    std::unique_ptr<profile::Profile const> flank_;  ///< at a fixed place: the distance points into it
    distance::ToothDistance distance_;
    std::vector<PieceStart> starts_;  ///< in the order of the profile
    std::vector<double> ends_;        ///< arc length at the end of each piece, in the order of the profile
    Vec2 first_, last_;
    bool root_first_, space_;
};

/// The nominal outline in one plane. Frame of a tooth: y outward, the axis of the part `seat` below its origin.
struct NominalPlane
{
    NominalFlank left, right;
    double reference_radius = 0;             ///< of the circle through the middles of the flanks [mm]
    double half_angle = 0;                   ///< from the middle of the right flank to that of the left one, half [rad]
    double error = 0;                        ///< of the outline [mm]
    double raise = 0;                        ///< from here to `raised` [mm]
    std::unique_ptr<NominalPlane> raised{};  ///< the outline at another height; none where it is the same

    /// Of the tooth, or width of the space, along the reference circle [mm].
    [[nodiscard]] double thickness() const { return 2 * half_angle * reference_radius; }
    [[nodiscard]] NominalFlank const& flank(bool is_right) const { return is_right ? right : left; }
    /// The foot of @p p on a flank, and its distance from the outline that is higher by @p above: to first order.
    [[nodiscard]] FlankFoot foot(Vec2 const& p, bool is_right, double above) const;
};

/// A ring of equal teeth, or of equal tooth spaces.
struct NominalPart
{
    int teeth = 0;
    bool space = false;  ///< whether the flanks bound a tooth space
    double seat = 0;     ///< from the axis to the origin of a tooth's frame [mm]
    double scale = 0;    ///< largest radius [mm]
    Pose frame;          ///< of the tooth as a scene has it, about the axis: y from the pitch line towards the tip
    std::vector<NominalPlane> planes;

    [[nodiscard]] double pitch() const;  ///< angle from tooth to tooth [rad]
    /// Rounding of a deviation [mm].
    [[nodiscard]] Tolerance tolerance() const { return {0, scale}; }
};

/// The flanks of a tooth that is given exactly: the pieces from the root to the tip land on either side.
/// @param seat  as of the part
[[nodiscard]] NominalPlane plane_of_profile(profile::Profile const& tooth, double seat);

/// The flanks of an outline: a cubic spline through the points of each piece that is a flank or a corner. The error is
/// what the spline through every second point misses of the others, divided by 2^4, and @p point_error.
/// @param tooth  kinds of the pieces and their points, in the frame of the tooth or space
/// @param seat   as of the part
[[nodiscard]] NominalPlane plane_of_outline(std::vector<Vec2> const& outline, std::vector<OutlinePiece> const& pieces,
                                            double seat, bool space, double point_error);

}  // namespace hdconj::inspect
