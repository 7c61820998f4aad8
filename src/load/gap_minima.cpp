// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_minima.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/base/tolerance.hpp"

namespace hdconj::load {
namespace {

/// Place in a stretch between two points where the slope is zero, from negative at 0 to positive at 1 (regula falsi,
/// Illinois).
FlankCurve::Place turning_place(FlankView const& view, std::size_t stretch, double low, double high, double at_low,
                                double at_high)
{
    constexpr int budget = 100;
    constexpr double enough = 16 * unit_roundoff;
    int side = 0;
    double share = low;
    for (int i = 0; i < budget && high - low > enough; ++i) {
        share = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(share > low && share < high))
            share = 0.5 * (low + high);
        double const slope = view.slope({stretch, share});
        if (slope == 0)
            break;
        if (slope > 0) {
            high = share;
            at_high = slope;
            if (side == 1)
                at_low /= 2;
            side = 1;
        } else {
            low = share;
            at_low = slope;
            if (side == -1)
                at_high /= 2;
            side = -1;
        }
    }
    return {stretch, share};
}

}  // namespace

double sampled_bound(FlankView const& view)
{
    std::vector<Vec2> const& point = view.curve.points();
    std::vector<double> const& length = view.curve.arc_length();
    constexpr std::size_t stride = 8;
    std::size_t const last = length.size() - 1;
    std::vector<std::size_t> chosen;
    std::vector<Vec2> place;
    for (std::size_t i = 0;; i = std::min(i + stride, last)) {
        chosen.push_back(i);
        place.push_back(point[i]);
        if (i == last)
            break;
    }
    std::vector<double> gap(place.size());
    view.field.gaps(view.teeth, view.flank, place.data(), place.size(), gap.data());
    double bound = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < chosen.size(); ++j) {
        std::size_t const i = chosen[j];
        double const reach =
            std::max(length[std::min(i + stride, last)] - length[i], length[i] - length[i - std::min(i, stride)]);
        bound = std::min(bound, gap[j] - reach);
    }
    return bound;
}

std::vector<GapMinimum> gap_minima(FlankView const& view, std::vector<double> const& gap,
                                   std::vector<Vec2> const& gradient)
{
    std::vector<GapMinimum> found;
    FlankCurve const& curve = view.curve;
    std::size_t const last_point = gap.size() - 1;
    double const least = *std::min_element(gap.begin(), gap.end());
    if (least > view.search.limit + curve.longest())
        return found;
    // The slopes at the ends of a stretch decide; stretches of no length are edges.
    bool falling = false, begun = false;
    for (std::size_t i = 0; i < last_point; ++i) {
        if (!(curve.length(i) > 0))
            continue;
        if (std::min(gap[i], gap[i + 1]) > view.search.limit + curve.length(i)) {
            falling = true;
            begun = true;
            continue;
        }
        double const at_begin = gradient[i].dot(curve.tangent({i, 0})),
                     at_end = gradient[i + 1].dot(curve.tangent({i, 1}));
        if (!begun) {
            if (at_begin >= 0)
                found.push_back({{i, 0}, true});
        } else if (falling && at_begin >= 0)
            found.push_back({{i, 0}, false});  // an edge, or rounding at a point
        begun = true;
        if (at_begin < 0 && at_end > 0)
            found.push_back({turning_place(view, i, 0, 1, at_begin, at_end), false});
        falling = at_end < 0;
    }
    if (begun && falling && gap[last_point] <= view.search.limit)
        found.push_back({{curve.last(), 1}, true});
    return found;
}

namespace {

/// Gap at the distance @p aside from a minimum at the arc length @p place, along the line that touches flank and tooth
/// there. Beyond a round edge the gap grows as its circle falls away from that line.
double gap_beside(FlankView const& view, GapMinimum const& at, contact::GapField::Touch const& touch, double place,
                  double aside)
{
    FlankCurve const& curve = view.curve;
    double const r = view.radius;
    if (at.at_end && place <= 0 && r > 0) {
        Vec2 const flank = curve.tangent(at.place), line = right_of(touch.normal);
        Vec2 const tangent = line.dot(flank) > 0 ? line : Vec2(-line);
        double const turned = std::acos(std::clamp(tangent.dot(flank), -1.0, 1.0));
        // towards the flank the edge is round for as long as the normal has to turn
        double const arc = aside > 0 ? std::min(r * turned, aside) : std::abs(aside);
        return view.gap(curve.points().front() + aside * tangent) + arc * arc / (2 * r) +
               arc / r * (std::abs(aside) - arc);
    }
    double const to = place + aside, total = curve.arc_length().back();
    if (to < 0)
        return view.gap(curve.points().front() + to * curve.tangent({curve.first(), 0})) +
               (r > 0 ? to * to / (2 * r) : 0);
    if (to > total)
        return view.gap(curve.points().back() + (to - total) * curve.tangent({curve.last(), 1}));
    return view.gap(curve.point(curve.place(to)));
}

/// A distance from the minimum and how far the gap there exceeds the level of the strip's end.
struct StripSample
{
    double distance, above;
};

/// Distance at which the gap reaches the level, between @p below and @p beyond: regula falsi (Illinois) on the square
/// of the distance, with which the gap grows.
template <class Above>
double strip_end(Above const& above, StripSample below, StripSample beyond)
{
    auto [low, at_low] = below;
    auto [high, at_high] = beyond;
    constexpr int budget = 60;
    constexpr double enough = 1e-6;  // of the width
    int side = 0;
    for (int i = 0; i < budget && high - low > enough * high; ++i) {
        double w = std::sqrt((low * low * at_high - high * high * at_low) / (at_high - at_low));
        if (!(w > low && w < high))
            w = 0.5 * (low + high);
        double const value = above(w);
        if (value > 0) {
            high = w;
            at_high = value;
            at_low = side == 1 ? at_low / 2 : at_low;
            side = 1;
        } else {
            low = w;
            at_low = value;
            at_high = side == -1 ? at_high / 2 : at_high;
            side = -1;
            if (value == 0)
                return w;
        }
    }
    return 0.5 * (low + high);
}

}  // namespace

ContactStrip contact_strip(FlankView const& view, GapMinimum const& at, contact::GapField::Touch const& touch)
{
    constexpr double widest_strip = 0.1;  // of the flank, to either side
    double const place = view.curve.arc_length_at(at.place);
    double const depth = view.search.strip_depth;
    double const level = touch.nearest.distance - view.radius + depth;
    double const widest = widest_strip * view.curve.arc_length().back();
    double const guess = std::min(widest, view.radius > 0 ? std::sqrt(depth * view.radius) : widest / 16);
    auto const end = [&](double sense) {
        auto const above = [&](double w) { return gap_beside(view, at, touch, place, sense * w) - level; };
        double low = 0, at_low = -depth;
        double high = guess, at_high = above(high);
        while (at_high <= 0 && high < widest) {
            low = high;
            at_low = at_high;
            high = std::min(2 * high, widest);
            at_high = above(high);
        }
        return at_high <= 0 ? widest : strip_end(above, {low, at_low}, {high, at_high});
    };
    return {end(-1), end(1)};
}

}  // namespace hdconj::load
