// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/load/flank_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "flank_curve.hpp"
#include "hdconj/geometry/rigid_motion.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/numeric/tolerance.hpp"

namespace hdconj {
namespace {

constexpr std::size_t stride = 8;         // of the points that tell far flanks
constexpr double widest_strip = 0.1;      // of the flank, either side

/// One flank of a slice, looked at from one space.
struct View
{
    GapField const& field;
    FlankSearch const& search;
    FlankCurve const& curve;
    std::size_t space;
    int flank;
    std::size_t slice;
    double radius;

    [[nodiscard]] GapField::Touch touch(Vec2 const& q) const { return field.touch(space, slice, q, search.turn); }
    [[nodiscard]] double gap(Vec2 const& q) const { return touch(q).nearest.distance - radius; }
    /// Derivative of the gap along the flank, at an end of a stretch from within.
    [[nodiscard]] double slope(FlankCurve::Place const& at) const { return touch(curve.point(at)).normal.dot(curve.tangent(at)); }
};

/// Whether every gap is above the limit, from every stride-th one.
bool is_far(View const& view)
{
    std::vector<Vec2> const& point = view.curve.points();
    std::vector<double> const& way = view.curve.way();
    std::size_t const last = way.size() - 1;
    for (std::size_t i = 0;; i = std::min(i + stride, last))
    {
        double const reach = way[std::min(i + stride, last)] - way[i];
        if (view.gap(point[i]) - std::max(reach, way[i] - way[i - std::min(i, stride)]) <= view.search.limit)
            return false;
        if (i == last)
            return true;
    }
}

/// Place in a stretch between two points where the slope is zero, from negative at 0 to positive at 1 (regula falsi, Illinois).
FlankCurve::Place turning_place(View const& view, std::size_t stretch, double low, double high, double at_low, double at_high)
{
    constexpr int budget = 100;
    constexpr double enough = 16 * unit_roundoff;
    int side = 0;
    double share = low;
    for (int i = 0; i < budget && high - low > enough; ++i)
    {
        share = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(share > low && share < high))
            share = 0.5 * (low + high);
        double const slope = view.slope({stretch, share});
        if (slope == 0)
            break;
        if (slope > 0)
        {
            high = share;
            at_high = slope;
            if (side == 1)
                at_low /= 2;
            side = 1;
        }
        else
        {
            low = share;
            at_low = slope;
            if (side == -1)
                at_high /= 2;
            side = -1;
        }
    }
    return {stretch, share};
}

/// A place, and whether the flank ends there with the gap still falling.
struct Minimum
{
    FlankCurve::Place place;
    bool at_end = false;
};

/// All places where the gap turns from falling to rising, and ends.
void minima(View const& view, std::vector<double> const& gap, std::vector<Minimum>& found)
{
    found.clear();
    FlankCurve const& curve = view.curve;
    std::size_t const last_point = gap.size() - 1;
    double const least = *std::min_element(gap.begin(), gap.end());
    if (least > view.search.limit + curve.longest())
        return;
    // slopes at the ends of a stretch decide; stretches of no length are edges
    bool falling = false, begun = false;
    for (std::size_t i = 0; i < last_point; ++i)
    {
        if (!(curve.length(i) > 0))
            continue;
        if (std::min(gap[i], gap[i + 1]) > view.search.limit + curve.length(i))
        {
            falling = true;
            begun = true;
            continue;
        }
        double const at_begin = view.slope({i, 0}), at_end = view.slope({i, 1});
        if (!begun)
        {
            if (at_begin >= 0)
                found.push_back({{i, 0}, true});
        }
        else if (falling && at_begin >= 0)
            found.push_back({{i, 0}, false});  // an edge, or rounding at a point
        begun = true;
        if (at_begin < 0 && at_end > 0)
            found.push_back({turning_place(view, i, 0, 1, at_begin, at_end), false});
        else if (at_begin >= 0 && at_end < 0)
        {
            // up and down again within a stretch: nothing is least inside
        }
        falling = at_end < 0;
    }
    if (begun && falling && gap[last_point] <= view.search.limit)
        found.push_back({{curve.last(), 1}, true});
}

/// Gap beside a place, along the line that touches flank and tooth there; an edge falls away from it.
double gap_beside(View const& view, Minimum const& at, GapField::Touch const& touch, double way, double aside)
{
    FlankCurve const& curve = view.curve;
    double const r = view.radius;
    if (at.at_end && way <= 0 && r > 0)
    {
        Vec2 const flank = curve.tangent(at.place), line = right_of(touch.normal);
        Vec2 const tangent = line.dot(flank) > 0 ? line : Vec2(-line);
        double const turned = std::acos(std::clamp(tangent.dot(flank), -1.0, 1.0));
        // towards the flank the edge is round for as long as the normal has to turn
        double const arc = aside > 0 ? std::min(r * turned, aside) : std::abs(aside);
        return view.gap(curve.points().front() + aside * tangent) + arc * arc / (2 * r) + arc / r * (std::abs(aside) - arc);
    }
    double const to = way + aside, total = curve.way().back();
    if (to < 0)
        return view.gap(curve.points().front() + to * curve.tangent({curve.first(), 0})) + (r > 0 ? to * to / (2 * r) : 0);
    if (to > total)
        return view.gap(curve.points().back() + (to - total) * curve.tangent({curve.last(), 1}));
    return view.gap(curve.point(curve.place(to)));
}

/// Part of the flank around a place in which the gap is no larger than that of the place and the strip's depth: ways from it to both ends.
struct Strip
{
    double behind, ahead;
};

Strip strip_of(View const& view, Minimum const& at, GapField::Touch const& touch)
{
    double const way = view.curve.way_at(at.place);
    double const depth = view.search.strip_depth;
    double const level = touch.nearest.distance - view.radius + depth;
    double const widest = widest_strip * view.curve.way().back();
    auto const end = [&](double sense) {
        auto const above = [&](double w) { return gap_beside(view, at, touch, way, sense * w) - level; };
        double low = 0, at_low = -depth;
        double high = std::min(widest, view.radius > 0 ? std::sqrt(depth * view.radius) : widest / 16);
        double at_high = above(high);
        while (at_high <= 0 && high < widest)
        {
            low = high;
            at_low = at_high;
            high = std::min(2 * high, widest);
            at_high = above(high);
        }
        if (at_high <= 0)
            return widest;
        constexpr int budget = 60;
        constexpr double enough = 1e-6;  // of the width
        int side = 0;
        for (int i = 0; i < budget && high - low > enough * high; ++i)
        {
            // the gap goes with the square of the way
            double w = std::sqrt((low * low * at_high - high * high * at_low) / (at_high - at_low));
            if (!(w > low && w < high))
                w = 0.5 * (low + high);
            double const value = above(w);
            if (value > 0)
            {
                high = w;
                at_high = value;
                at_low = side == 1 ? at_low / 2 : at_low;
                side = 1;
            }
            else
            {
                low = w;
                at_low = value;
                at_high = side == -1 ? at_high / 2 : at_high;
                side = -1;
                if (value == 0)
                    return w;
            }
        }
        return 0.5 * (low + high);
    };
    return {end(-1), end(1)};
}

/// Everything of a contact but its curvature.
FlankContact contact_at(View const& view, FlankCurve::Place const& place, GapField::Touch const& touch)
{
    FlankContact c;
    c.space = view.space;
    c.flank = view.flank;
    c.slice = view.slice;
    c.tooth = touch.tooth;
    c.way = view.curve.way_at(place);
    c.station = c.way / view.curve.way().back();
    c.gap = touch.nearest.distance - view.radius;
    Vec2 const& normal = touch.normal;
    Vec2 const p = view.curve.point(place);
    c.lever = cross(normal, p);
    // the circular spline stands turned back by `turn` against the wave generator
    double const phi = 2 * std::numbers::pi * touch.tooth / view.search.flexspline_teeth + view.search.phase;
    Vec2 const n = turned_clockwise(normal, view.field.space_angle(view.space) - view.search.turn - phi);
    c.c_t = n.x();
    c.c_r = n.y();
    // arm in the tooth's frame: turns against the ring by less than a degree do not change it
    c.c_turn = cross(touch.nearest.normal, touch.nearest.point);
    c.tooth_x = touch.nearest.point.x();
    c.tooth_y = touch.nearest.point.y();
    c.inclination = touch.nearest.normal.y();
    return c;
}

std::vector<FlankCurve> curves_of(FlankGrid const& grid, int threads)
{
    std::size_t const slices = grid.slices();
    std::vector<FlankCurve> curves(2 * slices);
    constexpr std::size_t grain = 8;
    parallel_for(curves.size(), threads, grain, [&](std::size_t i) { curves[i] = FlankCurve(grid.point[i / slices][i % slices]); });
    return curves;
}

double radius_of(FlankGrid const& grid, std::size_t flank, std::size_t slice)
{
    return grid.radius[flank].empty() ? 0 : grid.radius[flank][slice];
}

}  // namespace

std::vector<FlankContact> flank_contacts(GapField const& field, FlankSearch const& search, int threads)
{
    FlankGrid const& grid = field.grid();
    std::vector<FlankCurve> const curves = curves_of(grid, threads);
    std::vector<std::vector<FlankContact>> found(search.spaces);
    constexpr std::size_t grain = 4;
    parallel_for(search.spaces, threads, grain, [&](std::size_t s) {
        std::vector<double> gap;
        std::vector<Minimum> places;
        std::vector<FlankContact> here;
        std::vector<Strip> strips;
        std::size_t const space = search.first_space + s;
        for (std::size_t f = 0; f < 2; ++f)
            for (std::size_t k = 0; k < grid.slices(); ++k)
            {
                View const view{field, search, curves[f * grid.slices() + k], space, static_cast<int>(f), k, radius_of(grid, f, k)};
                if (is_far(view))
                    continue;
                field.along(space, view.flank, k, search.turn, gap);
                minima(view, gap, places);
                here.clear();
                strips.clear();
                for (Minimum const& at : places)
                {
                    GapField::Touch const touch = view.touch(view.curve.point(at.place));
                    if (touch.nearest.distance - view.radius > search.limit)
                        continue;
                    Strip const strip = strip_of(view, at, touch);
                    double const half = 0.5 * (strip.behind + strip.ahead), way = view.curve.way_at(at.place);
                    strips.push_back({way - strip.behind, way + strip.ahead});
                    // the force is in the middle of a wide strip; a narrow one has its normal from the least gap, as on an edge, where all of it is on one circle
                    double const on_circle = std::sqrt(2 * search.strip_depth * view.radius);
                    double const wide = view.radius > 0 ? std::clamp(half / (2 * on_circle) - 1, 0.0, 1.0) : 1.0;
                    bool const on_edge = (at.at_end && way <= 0) || wide == 0;
                    FlankCurve::Place const middle = on_edge ? at.place : view.curve.place(way + 0.5 * wide * (strip.ahead - strip.behind));
                    FlankContact c = contact_at(view, middle, on_edge ? touch : view.touch(view.curve.point(middle)));
                    c.gap = touch.nearest.distance - view.radius;
                    c.curvature = 2 * search.strip_depth / (half * half);
                    here.push_back(c);
                }
                // what lies in the strip of a lesser gap is of that strip
                for (std::size_t i = 0; i < here.size(); ++i)
                {
                    bool own = true;
                    for (std::size_t j = 0; j < here.size(); ++j)
                    {
                        bool const less = here[j].gap < here[i].gap || (here[j].gap == here[i].gap && j < i);
                        own = own && !(less && here[i].way > strips[j].behind && here[i].way < strips[j].ahead);
                    }
                    if (own)
                        found[s].push_back(here[i]);
                }
            }
    });
    std::vector<FlankContact> all;
    for (auto const& each : found)
        all.insert(all.end(), each.begin(), each.end());
    return all;
}

}  // namespace hdconj
