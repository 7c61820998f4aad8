// SPDX-License-Identifier: GPL-3.0-or-later
#include "sound_flank.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/text.hpp"

namespace hdconj::profile {
namespace {

/// Somewhere in [a, b] where the polynomial with Bernstein coefficients @p c on it is not positive: by halving until no
/// coefficient is negative, or the interval is a point to 2^-40.
std::optional<double> not_positive(std::vector<double> c, double a, double b)
{
    if (std::all_of(c.begin(), c.end(), [](double value) { return value > 0; }))
        return std::nullopt;
    if (!(c.front() > 0))
        return a;
    constexpr double point = 0x1p-40;
    if (!(c.back() > 0) || b - a < point)
        return b;
    std::vector<double> right(c.size());
    numeric::bernstein_split(c, right, 0.5);
    double const middle = 0.5 * (a + b);
    auto const left = not_positive(std::move(c), a, middle);
    return left ? left : not_positive(std::move(right), middle, b);
}

/// Where the curve's speed falls to almost nothing of its largest.
std::optional<Vec2> standstill(CurvePiece const& curve)
{
    // |x'|^2 of a piece; below this share of its largest coefficient a tangent would be rounding
    constexpr double share = 0x1p-40;
    std::vector<double> const x1 = numeric::bernstein_derivative(curve.x());
    std::vector<double> const y1 = numeric::bernstein_derivative(curve.y());
    std::vector<double> speed2 = numeric::bernstein_product(x1, x1);
    std::vector<double> const y2 = numeric::bernstein_product(y1, y1);
    double largest = 0;
    for (std::size_t i = 0; i < speed2.size(); ++i) {
        speed2[i] += y2[i];
        largest = std::max(largest, std::abs(speed2[i]));
    }
    for (double& value : speed2)
        value -= share * largest;
    auto const t = not_positive(std::move(speed2), 0, 1);
    return t ? std::optional(curve.point(*t)) : std::nullopt;
}

double height_of(Vec2 const& p)
{
    return p.y();
}

/// Signed area of the triangle a, b, c.
double side(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return cross(b - a, c - a);
}

/// Where the polygon crosses itself: segments sorted by height, each compared with those that overlap it in height.
std::optional<Vec2> crossing(std::vector<Vec2> const& points)
{
    std::size_t const count = points.size() - 1;
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    auto const low = [&](std::size_t i) { return std::min(points[i].y(), points[i + 1].y()); };
    auto const high = [&](std::size_t i) { return std::max(points[i].y(), points[i + 1].y()); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t const i = order[k];
        for (std::size_t l = k + 1; l < count && low(order[l]) <= high(i); ++l) {
            std::size_t const j = order[l];
            if (i + 1 == j || j + 1 == i)
                continue;
            Vec2 const &a = points[i], &b = points[i + 1], &c = points[j], &d = points[j + 1];
            bool const apart = (side(a, b, c) > 0) == (side(a, b, d) > 0) || (side(c, d, a) > 0) == (side(c, d, b) > 0);
            if (!apart)
                return 0.5 * (a + b);
        }
    }
    return std::nullopt;
}

/// The curve of @p segments; a fault where it has no tangent.
Profile curve_with_tangents(std::vector<FlankSegment> const& segments, std::string_view key,
                            scene::ParameterFaults const& refuse)
{
    Profile curve;
    for (FlankSegment const& segment : segments)
        for (PieceShape const& shape : segment.pieces) {
            auto const* piece = std::get_if<CurvePiece>(&shape);
            if (auto const where = piece ? standstill(*piece) : std::nullopt) {
                refuse(key, "the curve has no tangent at " + short_point(*where),
                       "sort the points along the curve, move points apart that lie on each other there, or take the "
                       "cusp out");
                return {};
            }
            curve.pieces.push_back({shape, 0, 0, 1, false});
        }
    return curve;
}

/// Chord error of the polygons as a share of the height.
constexpr double chord_share = 0x1p-10;

/// The largest value on [0, 1] of the polynomial with Bernstein coefficients @p c, or @p found where none is larger by
/// more than @p error: by halving.
double largest_of(std::vector<double> c, double found, double error)
{
    found = std::max({found, c.front(), c.back()});
    if (!(*std::ranges::max_element(c) > found + error))
        return found;
    std::vector<double> right(c.size());
    numeric::bernstein_split(c, right, 0.5);
    return largest_of(std::move(right), largest_of(std::move(c), found, error), error);
}

}  // namespace

std::string short_point(Vec2 const& p)
{
    return "(" + short_number(p.x()) + ", " + short_number(p.y()) + ")";
}

void validate_flank(std::vector<FlankSegment> const& right_flank, scene::FamilyChoice const& choice,
                    std::string_view key, Faults& faults)
{
    scene::ParameterFaults const refuse(choice, faults);
    double const top = start_of(right_flank.front().pieces.front()).point.y();
    double const bottom = end_of(right_flank.back().pieces.back()).point.y();
    double const height = top - bottom;
    Profile const flank = curve_with_tangents(right_flank, key, refuse);
    if (refuse.any())
        return;
    if (!(height > 0)) {
        refuse(key,
               "the flank ends at height " + short_number(bottom) + ", not below its start at " + short_number(top),
               "give the flank from the tip down to the root");
        return;
    }
    std::vector<Vec2> const points = polygon_of(flank, height * chord_share);
    Vec2 const highest = *std::ranges::max_element(points, {}, height_of);
    Vec2 const lowest = *std::ranges::min_element(points, {}, height_of);
    Vec2 const leftmost = *std::ranges::min_element(points, {}, [](Vec2 const& p) { return p.x(); });
    // numbers are typed with finitely many digits
    constexpr double typed = 1e-9;
    // a spline through measured points may swing this far beyond a round tip
    constexpr double swing = 1e-3;
    if (highest.y() > top + swing * height)
        refuse(key, "the flank rises above its tip at " + short_point(highest), "start the flank at its highest point");
    if (lowest.y() < bottom - swing * height)
        refuse(key, "the flank falls below its root at " + short_point(lowest), "end the flank at its lowest point");
    if (leftmost.x() < -typed * height)
        refuse(key, "the flank crosses the tooth's centre line x = 0 at " + short_point(leftmost),
               "give the right flank, with x of 0 or more");
    if (auto const where = crossing(points))
        refuse(key, "the flank crosses itself near " + short_point(*where),
               "give a flank without loops, its points in order from tip to root");
}

double validate_whole_tooth(FlankSegment const& tooth, double top, double bottom, scene::FamilyChoice const& choice,
                            std::string_view key, Faults& faults)
{
    scene::ParameterFaults const refuse(choice, faults);
    double const height = top - bottom;
    Profile const curve = curve_with_tangents({tooth}, key, refuse);
    if (refuse.any())
        return top;
    std::vector<Vec2> const points = polygon_of(curve, height * chord_share);
    // a spline may swing this far beyond points that leave out its highest one, or turn into a flat tip
    constexpr double swing = 0x1p-6;
    // last points of both flanks are rarely measured at the same height
    constexpr double uneven = 0x1p-4;
    Vec2 const highest = *std::ranges::max_element(points, {}, height_of);
    Vec2 const lowest = *std::ranges::min_element(points, {}, height_of);
    if (highest.y() > top + swing * height)
        refuse(key,
               "the curve rises to " + short_point(highest) +
                   ", above the highest of the points at y = " + short_number(top),
               "give points along the tip too, or the right flank alone with side = \"right\"");
    if (lowest.y() < bottom - swing * height)
        refuse(key,
               "the curve falls to " + short_point(lowest) +
                   ", below the lowest of the points at y = " + short_number(bottom),
               "give more points there, and end both flanks at their lowest points");
    double const left = points.front().y(), right = points.back().y();
    if (std::abs(left - right) > uneven * height)
        refuse(key, "the left flank ends at height " + short_number(left) + ", the right one at " + short_number(right),
               "give both flanks down to the same height");
    if (auto const where = crossing(points))
        refuse(key, "the curve crosses itself near " + short_point(*where),
               "give a tooth without loops, its points in order from the left root over the tip to the right root");
    double summit = top;
    for (PieceShape const& shape : tooth.pieces)
        if (auto const* piece = std::get_if<CurvePiece>(&shape))
            summit = largest_of(piece->y(), summit, 0x1p-40 * height);
    return summit;
}

}  // namespace hdconj::profile
