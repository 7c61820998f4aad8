// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hdconj::region {
namespace {

/// -1, 0 or 1: the side of a b on which @p p lies.
int side(Vec2 const& a, Vec2 const& b, Vec2 const& p)
{
    double const area = cross(b - a, p - a);
    return (area > 0) - (area < 0);
}

/// Whether @p p, known to be on the line through a b, lies between them.
bool between(Vec2 const& a, Vec2 const& b, Vec2 const& p)
{
    return (p.array() >= a.cwiseMin(b).array()).all() && (p.array() <= a.cwiseMax(b).array()).all();
}

/// Whether the segments a b and c d touch or cross.
bool touch(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    int const sc = side(a, b, c), sd = side(a, b, d), sa = side(c, d, a), sb = side(c, d, b);
    if (sc * sd < 0 && sa * sb < 0)
        return true;
    return (sc == 0 && between(a, b, c)) || (sd == 0 && between(a, b, d)) || (sa == 0 && between(c, d, a)) ||
           (sb == 0 && between(c, d, b));
}

}  // namespace

SegmentFoot segment_foot(Vec2 const& p, Vec2 const& a, Vec2 const& b)
{
    Vec2 const along = b - a;
    double const length2 = along.squaredNorm();
    double const share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return {(p - a - share * along).squaredNorm(), share};
}

double distance_of_segments(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    if (touch(a, b, c, d))
        return 0;
    return std::sqrt(std::min({segment_foot(a, c, d).squared, segment_foot(b, c, d).squared,
                               segment_foot(c, a, b).squared, segment_foot(d, a, b).squared}));
}

SegmentTree::SegmentTree(std::vector<Vec2> points, bool closed) : points_(std::move(points)), closed_(closed)
{
    if (points_.size() < 2)
        throw std::logic_error("a line needs two points");
    if (closed)
        points_.push_back(points_.front());
    std::size_t const leaves = (points_.size() - 1 + leaf - 1) / leaf;
    boxes_.resize(4 * std::bit_ceil(leaves));
    build(1, 0, points_.size() - 1);
}

void SegmentTree::build(std::size_t node, std::size_t first, std::size_t last)
{
    if (last - first > leaf) {
        std::size_t const middle = first + (last - first) / 2;
        build(2 * node, first, middle);
        build(2 * node + 1, middle, last);
        boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]);
        return;
    }
    for (std::size_t i = first; i <= last; ++i)
        boxes_[node].extend(points_[i]);
}

Eigen::AlignedBox2d SegmentTree::box_of(std::size_t segment) const
{
    Vec2 const &a = points_[segment], &b = points_[segment + 1];
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

SegmentTree::Nearest SegmentTree::nearest(Vec2 const& p, std::size_t near) const
{
    std::size_t const start = std::min(near, points_.size() - 2);
    SegmentFoot best = segment_foot(p, points_[start], points_[start + 1]);
    std::size_t at = start;
    approach(p, best.squared, [&](std::size_t i) {
        SegmentFoot const foot = segment_foot(p, points_[i], points_[i + 1]);
        if (foot.squared < best.squared) {
            best = foot;
            at = i;
        }
        return best.squared;
    });
    return {at, best.share, std::sqrt(best.squared)};
}

std::vector<std::size_t> SegmentTree::near(std::size_t segment) const
{
    std::vector<std::size_t> found;
    meeting(1, 0, points_.size() - 1, box_of(segment), found);
    return found;
}

void SegmentTree::meeting(std::size_t node, std::size_t first, std::size_t last, Eigen::AlignedBox2d const& box,
                          std::vector<std::size_t>& found) const
{
    if (!boxes_[node].intersects(box))
        return;
    if (last - first > leaf) {
        std::size_t const middle = first + (last - first) / 2;
        meeting(2 * node, first, middle, box, found);
        meeting(2 * node + 1, middle, last, box, found);
        return;
    }
    for (std::size_t i = first; i < last; ++i)
        if (box_of(i).intersects(box))
            found.push_back(i);
}

std::pair<std::size_t, std::size_t> SegmentTree::crossing() const
{
    std::size_t const segments = points_.size() - 1;
    for (std::size_t i = 0; i < segments; ++i)
        for (std::size_t const j : near(i)) {
            bool const neighbours = j <= i + 1 || (closed_ && i == 0 && j + 1 == segments);
            if (!neighbours && touch(points_[i], points_[i + 1], points_[j], points_[j + 1]))
                return {i, j};
        }
    return {0, 0};
}

}  // namespace hdconj::region
