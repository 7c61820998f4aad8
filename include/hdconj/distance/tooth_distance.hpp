// SPDX-License-Identifier: GPL-3.0-or-later
// Signed distance from a point to a flexspline tooth, to its exact pieces and not to a polygon.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "hdconj/distance/curve_stretch.hpp"
#include "hdconj/distance/distance_lanes.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::distance {

/// Nearest point of the tooth and the distance to it.
struct NearestPoint
{
    double distance = 0;         ///< [mm], negative inside the tooth
    Vec2 point = Vec2::Zero();   ///< on the profile, tooth frame
    Vec2 normal = Vec2::Zero();  ///< outward: gradient of the distance
};

/// Distance function of one tooth in its own frame. Keeps pointers into the profile's curves.
///
/// Feet on lines and arcs have closed forms. A short stretch of a curve has at most one root of (p - x(t)).x'(t) = 0
/// that can be a minimum; where this is not proved, all roots on that curve are found. At a corner the foot is the
/// corner. Below the root ends the body goes on as the rim: points whose nearest point is a root end count as outside.
/// That is right for every point beyond the rim, and all points of a circular spline are.
class ToothDistance
{
  public:
    explicit ToothDistance(profile::Profile const& profile);

    [[nodiscard]] NearestPoint operator()(Vec2 const& p) const;

    /// The same of several points at once; null for a tooth with curves, or of so many pieces that it has several
    /// boxes.
    [[nodiscard]] DistanceLanes const* together() const { return lanes_ ? &*lanes_ : nullptr; }

    /// A quick lower bound of the distance, from the tooth's height and width; exact sign not implied.
    [[nodiscard]] double lower_bound(Vec2 const& p) const
    {
        double const above = p.y() - top_;
        double const beside = std::abs(p.x()) - half_width_;
        return above > beside ? above : beside;
    }

  private:
    struct Vertex
    {
        Vec2 point;
        Vec2 normal;    ///< mean of the normals on both sides
        bool open_end;  ///< root end of the profile
    };
    struct Line
    {
        Vec2 a, along, normal;
        double length;
    };
    struct Arc
    {
        Vec2 centre;
        double radius;
        Vec2 middle;  ///< middle of the normals
        double cos_half_span;
    };
    struct Patch
    {
        std::variant<Line, Arc, CurveStretch> shape;
        Vec2 low, high;  ///< bounding box
    };
    struct Run
    {
        std::size_t first, last;  ///< patches, the last one excluded
        Vec2 low, high;
    };
    struct Nearest;

    static void foot_on(Line const& line, Vec2 const& p, Nearest& nearest);
    static void foot_on(Arc const& arc, Vec2 const& p, Nearest& nearest);
    static void foot_on(CurveStretch const& stretch, Vec2 const& p, Nearest& nearest);
    static void all_feet_on(profile::CurvePiece const& curve, Vec2 const& p, Nearest& nearest);
    void add_patches(profile::PieceShape const& shape);
    void gather_runs();
    void gather_lanes();
    void look_at(Run const& run, Vec2 const& p, Nearest& nearest) const;

    std::vector<Patch> patches_;
    std::vector<Run> runs_;
    std::vector<Vertex> vertices_;
    std::optional<DistanceLanes> lanes_;
    double top_ = 0;
    double half_width_ = 0;
};

}  // namespace hdconj::distance
