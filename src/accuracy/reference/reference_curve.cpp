// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "hdconj/error.hpp"

namespace hdconj::accuracy {
namespace {

constexpr std::size_t patch_steps = 48;  // dense points of a patch

long double clenshaw(std::vector<long double> const& c, long double s)
{
    long double b1 = 0, b2 = 0;
    for (std::size_t k = c.size(); k-- > 1;) {
        long double const b = 2 * s * b1 - b2 + c[k];
        b2 = b1;
        b1 = b;
    }
    return s * b1 - b2 + c[0];
}

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
    return {clenshaw(patch.x, s), clenshaw(patch.y, s)};
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

/// The first patch of a stretch and the one after its last.
std::pair<std::size_t, std::size_t> patches_of(std::vector<ReferencePatch> const& patches, int stretch)
{
    auto const first = std::find_if(patches.begin(), patches.end(),
                                    [&](ReferencePatch const& patch) { return patch.stretch == stretch; });
    if (first == patches.end())
        throw NumericalError(ErrorCode::no_outline, "reference", "stretch " + std::to_string(stretch),
                             "there is no such stretch of boundary");
    auto const after =
        std::find_if(first, patches.end(), [&](ReferencePatch const& patch) { return patch.stretch != stretch; });
    return {static_cast<std::size_t>(first - patches.begin()), static_cast<std::size_t>(after - patches.begin())};
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
    PolylineTree::Nearest const found = tree_.nearest({static_cast<double>(x), static_cast<double>(y)}, near);
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

double ReferenceCurve::largest_radius() const
{
    long double largest = 0;
    for (std::size_t patch = 0; patch < patches_.size(); ++patch) {
        auto const radius = [&](long double s) {
            SeriesPoint const p = at(patches_[patch], s);
            return std::hypot(p.x, p.y);
        };
        std::size_t best = 0;
        long double const step = 2.0L / patch_steps;
        for (std::size_t k = 1; k <= patch_steps; ++k)
            if (radius(-1 + step * static_cast<long double>(k)) > radius(-1 + step * static_cast<long double>(best)))
                best = k;
        long double const middle = -1 + step * static_cast<long double>(best);
        long double a = std::max(-1.0L, middle - step), b = std::min(1.0L, middle + step);
        constexpr int thirds = 100;
        for (int i = 0; i < thirds; ++i) {
            long double const c = a + (b - a) / 3, d = b - (b - a) / 3;
            if (radius(c) > radius(d))
                b = d;
            else
                a = c;
        }
        largest = std::max({largest, radius(a), radius(middle)});
    }
    return static_cast<double>(largest);
}

Vec2 ReferenceCurve::start_of(int stretch) const
{
    return points_[patches_of(patches_, stretch).first * patch_steps];
}

Vec2 ReferenceCurve::end_of(int stretch) const
{
    return points_[patches_of(patches_, stretch).second * patch_steps];
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
    PolylineTree const tree(polygon);
    double gap = 0;
    std::size_t last = 0;
    for (Vec2 const& p : points_) {
        PolylineTree::Nearest const found = tree.nearest(p, last);
        last = found.segment;
        gap = std::max(gap, found.distance);
    }
    return gap;
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
    PolylineTree const tree(polygon);
    std::size_t last = 0;
    double gap = 0;
    std::size_t const samples = points_.size();
    std::vector<double> distances(samples);
    for (std::size_t k = 0; k < samples; ++k) {
        PolylineTree::Nearest const found = tree.nearest(points_[k], last);
        last = found.segment;
        distances[k] = found.distance;
        gap = std::max(gap, found.distance);
    }
    std::size_t first = 0;
    while (first < patches_.size()) {
        std::size_t end = first;
        while (end < patches_.size() && patches_[end].stretch == patches_[first].stretch)
            ++end;
        if (distances[(first + end) * patch_steps / 2] > far)
            ++result.missed;
        first = end;
    }
    result.points = static_cast<double>(points);
    result.hausdorff = std::max({static_cast<double>(points), static_cast<double>(chords), gap});
    return result;
}

}  // namespace hdconj::accuracy
