// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_strip.hpp"

#include <algorithm>
#include <cmath>

#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::load {
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
