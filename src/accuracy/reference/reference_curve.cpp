// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hdconj/base/stop.hpp"
#include "reference_integral.hpp"

namespace hdconj::accuracy {
namespace {

constexpr std::size_t patch_steps = 48;  // dense points of a patch

/// Coefficients of the derivative of a Chebyshev series.
std::vector<long double> derivative(std::vector<long double> const& c)
{
    std::size_t const n = c.size();
    std::vector<long double> d(n + 1, 0);
    for (std::size_t k = n - 1; k-- > 0;)
        d[k] = d[k + 2] + 2 * static_cast<long double>(k + 1) * c[k + 1];
    d[0] /= 2;
    d.resize(n - 1);
    return d;
}

struct SeriesPoint
{
    long double x, y;
};

SeriesPoint at(ReferencePatch const& patch, long double s)
{
    return {chebyshev_sum(patch.x, s), chebyshev_sum(patch.y, s)};
}

long double distance_to_chord(SeriesPoint const& p, Vec2 const& a, Vec2 const& b)
{
    long double const ax = static_cast<long double>(b.x()) - a.x(), ay = static_cast<long double>(b.y()) - a.y();
    long double const px = p.x - a.x(), py = p.y - a.y();
    long double const length2 = ax * ax + ay * ay;
    long double const share = length2 > 0 ? std::clamp((px * ax + py * ay) / length2, 0.0L, 1.0L) : 0.0L;
    return std::hypot(px - share * ax, py - share * ay);
}

std::vector<Vec2> dense(std::vector<ReferencePatch> const& patches)
{
    std::vector<Vec2> points;
    points.reserve(patches.size() * patch_steps + 1);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        for (std::size_t k = 0; k < patch_steps + (i + 1 == patches.size() ? 1 : 0); ++k) {
            SeriesPoint const p = at(patches[i], -1 + 2 * static_cast<long double>(k) / patch_steps);
            points.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y));
        }
    }
    return points;
}

/// Distance of each of @p points, which follow each other, from @p polygon.
std::vector<double> gaps(std::vector<Vec2> const& points, std::vector<Vec2> const& polygon)
{
    region::SegmentTree const tree(polygon);
    std::size_t near = 0;
    std::vector<double> distances;
    for (Vec2 const& p : points) {
        region::SegmentTree::Nearest const found = tree.nearest(p, near);
        near = found.segment;
        distances.push_back(found.distance);
    }
    return distances;
}

double largest_of(std::vector<double> const& distances)
{
    return *std::max_element(distances.begin(), distances.end());
}

}  // namespace

ReferenceCurve::ReferenceCurve(std::vector<ReferencePatch> patches, double error)
    : patches_(std::move(patches)), points_(dense(patches_)), tree_(points_), error_(error)
{
    for (ReferencePatch const& patch : patches_)
        slopes_.push_back({derivative(patch.x), derivative(patch.y), patch.stretch});
}

ReferenceCurve::Foot ReferenceCurve::refined(long double x, long double y, std::size_t patch, long double s) const
{
    // Gauss-Newton: for a point near the curve two or three patch_steps reach roundoff
    constexpr int budget = 40;
    Foot best{patch, s, 0};
    for (int i = 0; i <= budget; ++i) {
        SeriesPoint const c = at(patches_[patch], best.s);
        long double const dx = c.x - x, dy = c.y - y;
        best.distance = std::hypot(dx, dy);
        if (i == budget)
            break;
        SeriesPoint const d = at(slopes_[patch], best.s);
        long double const speed2 = d.x * d.x + d.y * d.y;
        if (!(speed2 > 0))
            break;
        long double const next = std::clamp(best.s - (dx * d.x + dy * d.y) / speed2, -1.0L, 1.0L);
        long double const step = std::abs(next - best.s);
        best.s = next;
        constexpr long double settled = 0x1p-50L;
        if (step < settled) {
            SeriesPoint const q = at(patches_[patch], best.s);
            best.distance = std::hypot(q.x - x, q.y - y);
            break;
        }
    }
    return best;
}

ReferenceCurve::Foot ReferenceCurve::foot(long double x, long double y, std::size_t& near) const
{
    end_if_stopped();
    region::SegmentTree::Nearest const found = tree_.nearest({static_cast<double>(x), static_cast<double>(y)}, near);
    near = found.segment;
    std::size_t const patch = std::min(found.segment / patch_steps, patches_.size() - 1);
    auto const along = static_cast<long double>(found.segment - patch * patch_steps) + found.share;
    Foot best = refined(x, y, patch, -1 + 2 * along / patch_steps);
    // a foot at the end of a patch may lie in its neighbour
    if (best.s >= 1 && patch + 1 < patches_.size())
        if (Foot const other = refined(x, y, patch + 1, -1); other.distance < best.distance)
            best = other;
    if (best.s <= -1 && patch > 0)
        if (Foot const other = refined(x, y, patch - 1, 1); other.distance < best.distance)
            best = other;
    return best;
}

double ReferenceCurve::distance(long double x, long double y) const
{
    std::size_t near = 0;
    return static_cast<double>(foot(x, y, near).distance);
}

ReferenceCurve ReferenceCurve::inner() const
{
    std::vector<ReferencePatch> kept;
    for (ReferencePatch const& patch : patches_)
        if (patch.stretch != patches_.front().stretch && patch.stretch != patches_.back().stretch)
            kept.push_back(patch);
    return {std::move(kept), error_};
}

double ReferenceCurve::length(int stretch) const
{
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
        if (patches_[std::min(i / patch_steps, patches_.size() - 1)].stretch == stretch)
            sum += (points_[i + 1] - points_[i]).norm();
    return sum;
}

double ReferenceCurve::largest_distance(std::vector<Vec2> const& points) const
{
    long double worst = 0;
    std::size_t near = 0;
    for (Vec2 const& p : points)
        worst = std::max(worst, foot(p.x(), p.y(), near).distance);
    return static_cast<double>(worst);
}

double ReferenceCurve::largest_gap(std::vector<Vec2> const& polygon) const
{
    return largest_of(gaps(points_, polygon));
}

CurveDifference ReferenceCurve::compare(std::vector<Vec2> const& polygon, double far) const
{
    CurveDifference result;
    long double points = 0, chords = 0;
    std::size_t near = 0;
    Foot before;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Foot const now = foot(polygon[i].x(), polygon[i].y(), near);
        points = std::max(points, now.distance);
        if (i > 0) {
            // the curve between two feet, against the chord
            auto const look = [&](std::size_t patch, long double from, long double to) {
                for (long double const share : {0.25L, 0.5L, 0.75L, 1.0L})
                    chords = std::max(chords, distance_to_chord(at(patches_[patch], from + share * (to - from)),
                                                                polygon[i - 1], polygon[i]));
            };
            if (now.patch == before.patch)
                look(now.patch, before.s, now.s);
            else if (now.patch == before.patch + 1) {
                look(before.patch, before.s, 1);
                look(now.patch, now.s, -1);
            }
        }
        before = now;
    }
    // and all of the curve against all of the polygon: what no vertex is near to
    std::vector<double> const distances = gaps(points_, polygon);
    for (std::size_t first = 0, end = 0; first < patches_.size(); first = end) {
        while (end < patches_.size() && patches_[end].stretch == patches_[first].stretch)
            ++end;
        if (distances[(first + end) * patch_steps / 2] > far)
            ++result.missed;
    }
    result.points = static_cast<double>(points);
    result.hausdorff = std::max({static_cast<double>(points), static_cast<double>(chords), largest_of(distances)});
    return result;
}

}  // namespace hdconj::accuracy
