// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_grid.hpp"

#include <algorithm>
#include <limits>

#include "hdconj/base/stop.hpp"

namespace hdconj::wedm {
namespace {

/// Most columns and rows.
constexpr int most_cells = 2048;

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
bool segments_touch(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    int const sc = side(a, b, c), sd = side(a, b, d), sa = side(c, d, a), sb = side(c, d, b);
    if (sc * sd < 0 && sa * sb < 0)
        return true;
    return (sc == 0 && between(a, b, c)) || (sd == 0 && between(a, b, d)) || (sa == 0 && between(c, d, a)) ||
           (sb == 0 && between(c, d, b));
}

}  // namespace

double distance_to_segment(Vec2 const& p, Vec2 const& a, Vec2 const& b, Lean const& lean)
{
    Vec2 const along = lean.seen(b - a), to_p = lean.seen(p - a);
    double const length = along.squaredNorm();
    double const share = length > 0 ? std::clamp(to_p.dot(along) / length, 0.0, 1.0) : 0;
    return (to_p - share * along).norm();
}

double distance_of_segments(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    if (segments_touch(a, b, c, d))
        return 0;
    return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                     distance_to_segment(d, a, b)});
}

SegmentGrid::SegmentGrid(std::vector<Vec2> points, bool closed)
    : points_(std::move(points)), segments_(points_.size() - (closed ? 0 : 1))
{
    low_ = points_.front();
    Vec2 high = low_;
    double length = 0;
    for (std::size_t i = 0; i < segments_; ++i) {
        low_ = low_.cwiseMin(points_[i]).cwiseMin(end(i));
        high = high.cwiseMax(points_[i]).cwiseMax(end(i));
        length += (end(i) - points_[i]).norm();
    }
    Vec2 const span = high - low_;
    // a few segments to a cell that any passes through
    double const mean = length / static_cast<double>(segments_);
    size_ = std::max({2 * mean, span.maxCoeff() / most_cells, std::numeric_limits<double>::min()});
    columns_ = static_cast<int>(span.x() / size_) + 1;
    rows_ = static_cast<int>(span.y() / size_) + 1;
    begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (std::size_t i = 0; i < segments_; ++i)
        cells_of(i, [&](std::size_t cell) { ++begin_[cell + 1]; });
    for (std::size_t c = 1; c < begin_.size(); ++c)
        begin_[c] += begin_[c - 1];
    members_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < segments_; ++i)
        cells_of(i, [&](std::size_t cell) { members_[next[cell]++] = i; });
}

SegmentGrid::Cell SegmentGrid::cell_of(Vec2 const& p) const
{
    Vec2 const at = (p - low_) / size_;
    return {static_cast<int>(std::clamp(at.x(), 0.0, static_cast<double>(columns_ - 1))),
            static_cast<int>(std::clamp(at.y(), 0.0, static_cast<double>(rows_ - 1)))};
}

template <class Body>
void SegmentGrid::cells_of(std::size_t segment, Body&& body) const
{
    Cell const a = cell_of(points_[segment]);
    Cell const b = cell_of(end(segment));
    for (int y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y)
        for (int x = std::min(a.x, b.x); x <= std::max(a.x, b.x); ++x)
            body(number(x, y));
}

std::vector<std::size_t> SegmentGrid::near(std::size_t segment) const
{
    std::vector<std::size_t> found;
    cells_of(segment, [&](std::size_t cell) {
        for (std::size_t m = begin_[cell]; m < begin_[cell + 1]; ++m)
            found.push_back(members_[m]);
    });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

double SegmentGrid::distance(Vec2 const& p, Lean const& lean) const
{
    end_if_stopped();
    Cell const home = cell_of(p);
    double best = std::numeric_limits<double>::infinity();
    int const last = std::max(columns_, rows_);
    for (int ring = 0; ring <= last; ++ring) {
        // for a point outside, the distance from its home cell is less than its own
        if (best * lean.secant() <= (ring - 1) * size_)
            break;
        for (int y = std::max(0, home.y - ring); y <= std::min(rows_ - 1, home.y + ring); ++y) {
            bool const whole = y == home.y - ring || y == home.y + ring;
            for (int x = home.x - ring; x <= home.x + ring; x += whole || ring == 0 ? 1 : 2 * ring) {
                if (x < 0 || x >= columns_)
                    continue;
                std::size_t const cell = number(x, y);
                for (std::size_t m = begin_[cell]; m < begin_[cell + 1]; ++m)
                    best = std::min(best, distance_to_segment(p, points_[members_[m]], end(members_[m]), lean));
            }
        }
    }
    return best;
}

bool SegmentGrid::touch(std::size_t i, std::size_t j) const
{
    return segments_touch(points_[i], end(i), points_[j], end(j));
}

std::pair<std::size_t, std::size_t> SegmentGrid::crossing() const
{
    bool const closed = segments_ == points_.size();
    for (std::size_t cell = 0; cell + 1 < begin_.size(); ++cell) {
        for (std::size_t m = begin_[cell]; m < begin_[cell + 1]; ++m) {
            for (std::size_t n = m + 1; n < begin_[cell + 1]; ++n) {
                std::size_t const i = members_[m];
                std::size_t const j = members_[n];
                bool const neighbours = j == i + 1 || (closed && i == 0 && j + 1 == segments_);
                if (!neighbours && touch(i, j))
                    return {i, j};
            }
        }
    }
    return {0, 0};
}

}  // namespace hdconj::wedm
