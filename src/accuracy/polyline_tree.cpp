// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hdconj::accuracy {

constexpr std::size_t leaf = 8;  // segments

SegmentFoot segment_foot(Vec2 const& p, Vec2 const& a, Vec2 const& b)
{
    Vec2 const along = b - a;
    double const length2 = along.squaredNorm();
    double const share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return {(p - a - share * along).squaredNorm(), share};
}

PolylineTree::PolylineTree(std::vector<Vec2> points) : points_(std::move(points))
{
    if (points_.size() < 2)
        throw std::logic_error("a polyline needs two points");
    std::size_t const leaves = (points_.size() - 1 + leaf - 1) / leaf;
    boxes_.resize(4 * std::bit_ceil(leaves));
    build(1, 0, points_.size() - 1);
}

void PolylineTree::build(std::size_t node, std::size_t first, std::size_t last)
{
    if (last - first > leaf) {
        std::size_t const middle = first + (last - first) / 2;
        build(2 * node, first, middle);
        build(2 * node + 1, middle, last);
        boxes_[node] = {boxes_[2 * node].low.cwiseMin(boxes_[2 * node + 1].low),
                        boxes_[2 * node].high.cwiseMax(boxes_[2 * node + 1].high)};
        return;
    }
    Box box{points_[first], points_[first]};
    for (std::size_t i = first; i <= last; ++i) {
        box.low = box.low.cwiseMin(points_[i]);
        box.high = box.high.cwiseMax(points_[i]);
    }
    boxes_[node] = box;
}

double PolylineTree::squared_to(std::size_t node, Vec2 const& p) const
{
    Box const& box = boxes_[node];
    return (p - p.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

void PolylineTree::search(std::size_t node, std::size_t first, std::size_t last, Vec2 const& p, Nearest& best,
                          double& squared) const
{
    if (!(squared_to(node, p) < squared))
        return;
    if (last - first > leaf) {
        std::size_t const middle = first + (last - first) / 2;
        bool const left_first = squared_to(2 * node, p) <= squared_to(2 * node + 1, p);
        if (left_first)
            search(2 * node, first, middle, p, best, squared);
        search(2 * node + 1, middle, last, p, best, squared);
        if (!left_first)
            search(2 * node, first, middle, p, best, squared);
        return;
    }
    for (std::size_t i = first; i < last; ++i) {
        SegmentFoot const foot = segment_foot(p, points_[i], points_[i + 1]);
        if (foot.squared < squared) {
            squared = foot.squared;
            best = {i, foot.share, 0};
        }
    }
}

PolylineTree::Nearest PolylineTree::nearest(Vec2 const& p, std::size_t near) const
{
    std::size_t const start = std::min(near, points_.size() - 2);
    SegmentFoot const first = segment_foot(p, points_[start], points_[start + 1]);
    Nearest best{start, first.share, 0};
    double squared = first.squared;
    search(1, 0, points_.size() - 1, p, best, squared);
    best.distance = std::sqrt(squared);
    return best;
}

}  // namespace hdconj::accuracy
