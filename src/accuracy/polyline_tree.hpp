// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest segment of a polyline, by boxes around runs of segments.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::accuracy {

/// Squared distance of @p p from the segment a b, and where along it (0 ... 1).
struct SegmentFoot
{
    double squared = 0;
    double share = 0;
};
[[nodiscard]] SegmentFoot segment_foot(Vec2 const& p, Vec2 const& a, Vec2 const& b);

/// A binary tree of boxes over the segments in their own order.
class PolylineTree
{
  public:
    explicit PolylineTree(std::vector<Vec2> points);

    struct Nearest
    {
        std::size_t segment = 0;
        double share = 0;
        double distance = 0;
    };
    /// @param near  a segment that may be close: the answer of the point before. Any is right, a near one is fast.
    [[nodiscard]] Nearest nearest(Vec2 const& p, std::size_t near) const;
    [[nodiscard]] std::vector<Vec2> const& points() const { return points_; }

  private:
    struct Box
    {
        Vec2 low, high;
    };
    void build(std::size_t node, std::size_t first, std::size_t last);
    void search(std::size_t node, std::size_t first, std::size_t last, Vec2 const& p, Nearest& best,
                double& squared) const;
    [[nodiscard]] double squared_to(std::size_t node, Vec2 const& p) const;

    std::vector<Vec2> points_;
    std::vector<Box> boxes_;
};

}  // namespace hdconj::accuracy
