// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/conjugate/swept_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/error.hpp"

namespace hdconj::conjugate {
namespace {

/// Angle from the y axis, clockwise.
double angle_of(Vec2 const& p)
{
    return std::atan2(p.x(), p.y());
}

}  // namespace

void SweptPolygons::add(int arc, std::vector<Vec2> const& points, std::vector<double> const& u)
{
    auto const [low, high] = std::minmax_element(
        points.begin(), points.end(), [](Vec2 const& a, Vec2 const& b) { return angle_of(a) < angle_of(b); });
    // half a pitch either side of the middle is wanted; the spaces next to it must be whole, or the walk gets into them
    double const window = 1.5 * pitch_;
    int const first = static_cast<int>(std::ceil((-window - angle_of(*high)) / pitch_));
    int const last = static_cast<int>(std::floor((window - angle_of(*low)) / pitch_));
    for (int copy = first; copy <= last; ++copy) {
        std::vector<Vec2> turned(points.size());
        for (std::size_t k = 0; k < points.size(); ++k)
            turned[k] = turned_clockwise(points[k], copy * pitch_);
        polygons_.push_back(std::move(turned));
        sources_.push_back({arc, copy, u});
    }
}

void SweptPolygons::add_one(int arc, int copy, std::vector<Vec2> const& points, std::vector<double> const& u)
{
    polygons_.push_back(points);
    sources_.push_back({arc, copy, u});
}

void SweptPolygons::join_ends(double same)
{
    std::vector<Vec2> seen;
    std::multimap<double, std::size_t> by_x;  // numbers of those
    for (auto& polygon : polygons_) {
        for (Vec2* p : {&polygon.front(), &polygon.back()}) {
            std::size_t first = seen.size();
            auto const end = by_x.upper_bound(p->x() + 2 * same);  // twice: no rounding may hide one
            for (auto near = by_x.lower_bound(p->x() - 2 * same); near != end; ++near)
                if ((*p - seen[near->second]).norm() <= same)
                    first = std::min(first, near->second);
            if (first == seen.size()) {
                by_x.emplace(p->x(), first);
                seen.push_back(*p);
            } else {
                *p = seen[first];
            }
        }
    }
}

int SweptPolygons::add_floor(double radius, double chord)
{
    double low = -1.75 * pitch_;
    double high = 1.75 * pitch_;
    for (auto const& polygon : polygons_) {
        for (Vec2 const& p : polygon) {
            low = std::min(low, angle_of(p) - pitch_ / 8);
            high = std::max(high, angle_of(p) + pitch_ / 8);
        }
    }
    double const step = 2 * std::acos(1 - std::min(0.5, chord / radius));
    auto const count = static_cast<std::size_t>(std::ceil((high - low) / step));
    std::vector<Vec2> floor;
    Source source;
    for (std::size_t k = 0; k <= count; ++k) {
        double const angle = low + (high - low) * static_cast<double>(k) / static_cast<double>(count);
        floor.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
        source.u.push_back(angle);
    }
    polygons_.push_back(std::move(floor));
    sources_.push_back(std::move(source));
    return static_cast<int>(polygons_.size()) - 1;
}

int SweptPolygons::add_floor_line(double y, double margin)
{
    double left = -margin;
    double right = margin;
    for (auto const& polygon : polygons_) {
        for (Vec2 const& p : polygon) {
            left = std::min(left, p.x() - margin);
            right = std::max(right, p.x() + margin);
        }
    }
    add_one(-1, 0, {{right, y}, {left, y}}, {right, left});
    return static_cast<int>(polygons_.size()) - 1;
}

void SweptPolygons::add_wall(double x, double y, double margin)
{
    double low = y;
    for (auto const& polygon : polygons_)
        for (Vec2 const& p : polygon)
            low = std::min(low, p.y());
    low -= margin;
    add_one(-1, 0, {{x, y}, {x, low}}, {y, low});
}

double SweptPolygons::lowest_at(std::initializer_list<double> places) const
{
    double lowest = std::numeric_limits<double>::infinity();
    for (auto const& polygon : polygons_) {
        for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
            Vec2 const& a = polygon[k];
            Vec2 const& b = polygon[k + 1];
            for (double const x : places)
                if ((a.x() < x) != (b.x() < x))
                    lowest = std::min(lowest, a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
        }
    }
    return lowest;
}

double SweptPolygons::radius_at(std::initializer_list<double> angles) const
{
    double reached = 0;
    for (auto const& polygon : polygons_) {
        double before = angle_of(polygon.front());
        for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
            double const after = angle_of(polygon[k + 1]);
            for (double const side : angles) {
                if ((before < side) == (after < side))
                    continue;
                Vec2 const p = polygon[k] + (side - before) / (after - before) * (polygon[k + 1] - polygon[k]);
                reached = std::max(reached, p.norm());
            }
            before = after;
        }
    }
    return reached;
}

double SweptPolygons::radius_between_spaces() const
{
    return radius_at({-0.5 * pitch_, 0.5 * pitch_});
}

std::optional<double> SweptPolygons::radius_of_land(double tip) const
{
    double const angle = (0.5 - half_land) * pitch_;
    double const radius = radius_at({-angle, angle}), deepest = radius_at({0.0}),
                 half_module = radius * pitch_ / (2 * std::numbers::pi);
    bool const is_deep = deepest - radius >= std::min((deepest - tip) / 2, half_module);
    return radius > tip && is_deep ? std::optional(radius) : std::nullopt;
}

std::vector<std::string> SweptPolygons::wider_tip(double tip) const
{
    auto const radius = radius_of_land(tip);
    return radius ? std::vector{"circular_spline.inner_radius=" + std::to_string(*radius)} : std::vector<std::string>{};
}

void SweptPolygons::refuse_without_land(double tip, double side_clearance) const
{
    double const reached = radius_between_spaces();
    if (!(reached > tip))
        return;
    std::string cause =
        "no tip land is left on the circular spline: half-way between two tooth spaces the teeth sweep up to a radius "
        "of " +
        std::to_string(reached) + " mm, where the circular spline's teeth would be pointed, and the tip circle is at " +
        std::to_string(tip) + " mm";
    bool const is_entered = reached < radius_at({0.0}) - side_clearance;  // by the tips, at a wider tip circle
    std::string remedy =
        (is_entered ? "write a circular_spline.inner_radius above " + std::to_string(reached) + ", a thinner tooth"
                    : std::string("write a thinner tooth")) +
        " or a smaller addendum";
    std::vector<std::string> set = wider_tip(tip);
    // The spaces meet at the radius reached. With a clearance that is smaller by the depth of the tip circle below that
    // place, neither reaches the middle there; half of it leaves a land.
    double const largest = side_clearance - (reached - tip);
    if (side_clearance > 0 && largest > 0) {
        constexpr int digits = 2;
        std::string const value = short_number(largest / 2, digits);
        cause += "; it is the side clearance of " + short_number(side_clearance) +
                 " mm, by which the flanks are moved, that makes the spaces meet there";
        remedy = "write circular_spline.backlash_offset = " + value + "; or " + remedy;
        set = {"circular_spline.backlash_offset=" + value};
    } else if (side_clearance > 0) {
        remedy += ", or a smaller circular_spline.backlash_offset";
    }
    throw NumericalError(ErrorCode::no_land, "region", "tip circle", cause, remedy, set);
}

double SweptPolygons::u_at(int polygon, double position) const
{
    auto const& u = source(polygon).u;
    auto const k = std::min(static_cast<std::size_t>(position), u.size() - 2);
    double const share = position - static_cast<double>(k);
    return u[k] + share * (u[k + 1] - u[k]);
}

}  // namespace hdconj::conjugate
