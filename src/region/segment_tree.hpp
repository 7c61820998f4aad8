// SPDX-License-Identifier: GPL-3.0-or-later
// A line of many short segments: what is near, without asking every one.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <utility>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::region {

/// Squared distance of @p p from the segment a b, and where along it (0 ... 1).
struct SegmentFoot
{
    double squared = 0;
    double share = 0;
};
[[nodiscard]] SegmentFoot segment_foot(Vec2 const& p, Vec2 const& a, Vec2 const& b);

/// Distance of the segments a b and c d; 0 where they touch or cross [mm].
[[nodiscard]] double distance_of_segments(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d);

/// A binary tree of boxes over the segments of a line, in the order of the line. The search for the nearest of n
/// segments of a smooth curve measures the distance of about sqrt(n) of them; near the curve, of about log(n).
class SegmentTree
{
  public:
    /// @param points  at least 2
    /// @param closed  whether the last point is joined to the first
    explicit SegmentTree(std::vector<Vec2> points, bool closed = false);

    struct Nearest
    {
        std::size_t segment = 0;
        double share = 0;
        double distance = 0;
    };
    /// @param near  a segment that may be close: the answer of the point before. Any is right, a near one is fast.
    [[nodiscard]] Nearest nearest(Vec2 const& p, std::size_t near) const;

    /// Calls @p measure(segment) for the segments whose boxes are nearer to @p p than @p reach, nearer boxes first.
    /// @param reach    square of a distance [mm^2]
    /// @param measure  returns the square that takes the place of reach
    template <class Measure>
    void approach(Vec2 const& p, double reach, Measure&& measure) const
    {
        approach(1, 0, points_.size() - 1, p, reach, measure);
    }

    /// Numbers of the segments whose boxes meet that of @p segment, itself among them, in ascending order.
    [[nodiscard]] std::vector<std::size_t> near(std::size_t segment) const;

    /// The first two segments that are not neighbours and touch or cross; nothing found: both numbers 0.
    [[nodiscard]] std::pair<std::size_t, std::size_t> crossing() const;

    /// A closed line has its first point at the end too.
    [[nodiscard]] std::vector<Vec2> const& points() const { return points_; }

  private:
    static constexpr std::size_t leaf = 8;  // segments

    void build(std::size_t node, std::size_t first, std::size_t last);
    [[nodiscard]] Eigen::AlignedBox2d box_of(std::size_t segment) const;
    [[nodiscard]] double squared_to(std::size_t node, Vec2 const& p) const
    {
        Eigen::AlignedBox2d const& box = boxes_[node];
        return (p - p.cwiseMax(box.min()).cwiseMin(box.max())).squaredNorm();
    }
    template <class Measure>
    void approach(std::size_t node, std::size_t first, std::size_t last, Vec2 const& p, double& reach,
                  Measure& measure) const
    {
        if (!(squared_to(node, p) < reach))
            return;
        if (last - first <= leaf) {
            for (std::size_t i = first; i < last; ++i)
                reach = measure(i);
            return;
        }
        std::size_t const middle = first + (last - first) / 2;
        bool const left_first = squared_to(2 * node, p) <= squared_to(2 * node + 1, p);
        if (left_first)
            approach(2 * node, first, middle, p, reach, measure);
        approach(2 * node + 1, middle, last, p, reach, measure);
        if (!left_first)
            approach(2 * node, first, middle, p, reach, measure);
    }
    void meeting(std::size_t node, std::size_t first, std::size_t last, Eigen::AlignedBox2d const& box,
                 std::vector<std::size_t>& found) const;

    std::vector<Vec2> points_;
    bool closed_;
    std::vector<Eigen::AlignedBox2d> boxes_;  // of node 1, the root; nodes 2 n and 2 n + 1 halve the segments of node n
};

}  // namespace hdconj::region
