// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_minima.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::load {
namespace {

/// Place in a stretch where the slope is zero.
/// @param at_begin, at_end  slopes at the ends of the stretch, of opposite signs
FlankCurve::Place turning_place(FlankView const& view, std::size_t stretch, double at_begin, double at_end)
{
    auto const slope = [&](double share) { return view.slope({stretch, share}); };
    return {stretch, numeric::bracketed_root(slope, 0, 1, at_begin, at_end).x};
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
            found.push_back({turning_place(view, i, at_begin, at_end), false});
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

/// Distance between @p low and @p high at which the gap reaches the level that ends the strip. The root is found in the
/// square of the distance, since the gap grows with that square.
/// @param above  the gap minus that level, a function of the distance
template <class Above>
double strip_end(Above const& above, double low, double high, double at_low, double at_high)
{
    constexpr std::uintmax_t budget = 60;
    constexpr double enough = 2e-6;  // of the square
    auto const by_square = [&](double square) { return above(std::sqrt(square)); };
    auto const last =
        numeric::shrunk_bracket(by_square, low * low, high * high, at_low, at_high, enough * high * high, budget);
    return std::sqrt(low * low + 0.5 * (last.low + last.high));
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
        return at_high <= 0 ? widest : strip_end(above, low, high, at_low, at_high);
    };
    return {end(-1), end(1)};
}

}  // namespace hdconj::load
