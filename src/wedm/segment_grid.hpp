// SPDX-License-Identifier: GPL-3.0-or-later
// Many short segments in the cells of a square grid: distances and crossings without asking every one.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "lean.hpp"

namespace hdconj::wedm {

/// The segments of a line of at least 2 points.
class SegmentGrid
{
  public:
    /// @param closed  whether the last point is joined to the first
    SegmentGrid(std::vector<Vec2> points, bool closed);

    /// Distance of @p p from the nearest segment, as it is seen along @p lean [mm].
    [[nodiscard]] double distance(Vec2 const& p, Lean const& lean = {}) const;

    /// Numbers of the segments that may touch or cross @p segment, itself among them, in ascending order.
    [[nodiscard]] std::vector<std::size_t> near(std::size_t segment) const;

    /// Two segments that are not neighbours and touch or cross; nothing found: both numbers 0.
    [[nodiscard]] std::pair<std::size_t, std::size_t> crossing() const;

  private:
    struct Cell
    {
        int x, y;
    };
    [[nodiscard]] Cell cell_of(Vec2 const& p) const;
    [[nodiscard]] std::size_t number(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] Vec2 const& end(std::size_t segment) const
    {
        return points_[segment + 1 == points_.size() ? 0 : segment + 1];
    }
    [[nodiscard]] bool touch(std::size_t a, std::size_t b) const;
    template <class Body>
    void cells_of(std::size_t segment, Body&& body) const;

    std::vector<Vec2> points_;
    std::size_t segments_;
    Vec2 low_ = Vec2::Zero();
    double size_ = 1;
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::size_t> begin_;    // of each cell in members_, and the end of the last
    std::vector<std::size_t> members_;  // segments whose box meets the cell
};

/// Distance of @p p from the segment a b, as it is seen along @p lean [mm].
[[nodiscard]] double distance_to_segment(Vec2 const& p, Vec2 const& a, Vec2 const& b, Lean const& lean = {});

/// Distance of the segments a b and c d; 0 where they touch or cross [mm].
[[nodiscard]] double distance_of_segments(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d);

}  // namespace hdconj::wedm
