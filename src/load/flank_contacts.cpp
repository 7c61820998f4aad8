// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "gap_minima.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::load {
namespace {

/// Everything of a contact but its curvature.
FlankContact contact_at(FlankView const& view, FlankCurve::Place const& place, contact::GapField::Touch const& touch)
{
    FlankContact c;
    c.space = view.space;
    c.flank = view.flank;
    c.slice = view.slice;
    c.tooth = touch.tooth;
    c.arc_length = view.curve.arc_length_at(place);
    c.arc_fraction = c.arc_length / view.curve.arc_length().back();
    c.gap = touch.nearest.distance - view.radius;
    Vec2 const& normal = touch.normal;
    Vec2 const p = view.field.placed(view.space, view.curve.point(place));
    c.point = p - view.radius * normal;
    c.normal = normal;
    c.lever = cross(normal, p);
    // the circular spline stands turned back by this turn against the wave generator, and teeth beside their places
    // keep their direction from the axis
    double const phi = 2 * std::numbers::pi * touch.tooth / view.search.flexspline_teeth + view.search.phase;
    Vec2 const n = turned_clockwise(normal, view.field.space_angle(view.space) - touch.turn - phi);
    c.c_t = n.x();
    c.c_r = n.y();
    // arm in the tooth's frame: turns against the ring by less than a degree do not change it
    c.c_turn = cross(touch.nearest.normal, touch.nearest.point);
    c.tooth_y = touch.nearest.point.y();
    c.inclination = touch.nearest.normal.y();
    return c;
}

/// A contact and the interval of arc length that its strip covers [mm].
struct StripContact
{
    FlankContact contact;
    double begin, end;
};

/// The contact of a minimum. The force acts in the middle of a wide strip. A narrow strip has its normal at the least
/// gap, and so has an edge, where all of the strip is on one circle, unless the search asks for the middle.
StripContact contact_of(FlankView const& view, GapMinimum const& at, contact::GapField::Touch const& touch)
{
    ContactStrip const strip = contact_strip(view, at, touch);
    double const half = 0.5 * (strip.behind + strip.ahead), place = view.curve.arc_length_at(at.place);
    double const on_circle = std::sqrt(2 * view.search.strip_depth * view.radius);
    double const wide = view.radius > 0 ? std::clamp(half / (2 * on_circle) - 1, 0.0, 1.0) : 1.0;
    bool const on_edge = (at.at_end && place <= 0 && !view.search.in_middle) || wide == 0;
    double const moved = view.search.in_middle ? 1 : on_edge ? 0 : wide;
    FlankCurve::Place const middle =
        moved == 0 ? at.place : view.curve.place(place + 0.5 * moved * (strip.ahead - strip.behind));
    FlankContact c = contact_at(view, middle, moved == 0 ? touch : view.touch(view.curve.point(middle)));
    c.gap = touch.nearest.distance - view.radius;
    c.curvature = 2 * view.search.strip_depth / (half * half);
    c.on_edge = on_edge;
    return {c, place - strip.behind, place + strip.ahead};
}

/// Adds the contacts of one flank to @p found. What lies in the strip of a smaller gap belongs to that strip.
void add_contacts(FlankView const& view, std::vector<double> const& gap, std::vector<Vec2> const& gradient,
                  std::vector<FlankContact>& found)
{
    std::vector<StripContact> here;
    for (GapMinimum const& at : gap_minima(view, gap, gradient)) {
        contact::GapField::Touch const touch = view.touch(view.curve.point(at.place));
        if (touch.nearest.distance - view.radius <= view.search.limit)
            here.push_back(contact_of(view, at, touch));
    }
    for (std::size_t i = 0; i < here.size(); ++i) {
        FlankContact const& c = here[i].contact;
        bool own = true;
        for (std::size_t j = 0; j < here.size(); ++j) {
            double const other = here[j].contact.gap;
            bool const less = other < c.gap || (other == c.gap && j < i);
            own = own && !(less && c.arc_length > here[j].begin && c.arc_length < here[j].end);
        }
        if (own)
            found.push_back(c);
    }
}

}  // namespace

void GapBounds::lower(double fall)
{
    for (double& least : least_)
        least -= fall;
}

std::vector<FlankContact> flank_contacts(contact::GapField const& field, FlankSearch const& search, int threads,
                                         GapBounds* known)
{
    contact::FlankGrid const& grid = field.grid();
    std::size_t const slices = grid.slices();
    std::vector<FlankCurve> curves(2 * slices);
    constexpr std::size_t curves_worth_a_thread = 8;
    parallel_for(curves.size(), threads, curves_worth_a_thread,
                 [&](std::size_t i) { curves[i] = FlankCurve(grid.point[i / slices][i % slices], search.tangents); });
    constexpr double nothing = -std::numeric_limits<double>::infinity();
    std::vector<double> unknown;
    std::vector<double>& bounds = known != nullptr ? known->least_ : unknown;
    bounds.resize(search.spaces * curves.size(), nothing);
    std::vector<std::vector<FlankContact>> found(search.spaces);
    constexpr std::size_t grain = 4;
    parallel_for(search.spaces, threads, grain, [&](std::size_t s) {
        std::vector<double> gap(grid.points());
        std::vector<Vec2> gradient(grid.points());
        std::size_t const space = search.first_space + s;
        std::vector<contact::GapField::NearTeeth> teeth;
        for (std::size_t k = 0; k < slices; ++k)
            teeth.push_back(field.near_teeth(space, k, search.turn));
        for (std::size_t f = 0; f < 2; ++f)
            for (std::size_t k = 0; k < slices; ++k) {
                int const flank = static_cast<int>(f);
                FlankView const view{field, search, curves[f * slices + k], space,
                                     flank, k,      field.radius(flank, k), teeth[k]};
                double& bound = bounds[s * curves.size() + f * slices + k];
                if (bound == nothing)
                    bound = sampled_bound(view);
                if (bound > search.limit)
                    continue;
                field.gaps(teeth[k], flank, grid.point[f][k].data(), gap.size(), gap.data(), gradient.data());
                bound = *std::ranges::min_element(gap) - view.curve.longest();
                add_contacts(view, gap, gradient, found[s]);
            }
    });
    std::vector<FlankContact> all;
    for (auto const& each : found)
        all.insert(all.end(), each.begin(), each.end());
    return all;
}

void hold_contacts(contact::GapField const& field, FlankSearch const& search, std::vector<FlankContact> const& before,
                   std::vector<double> const& force, std::vector<FlankContact>& contacts)
{
    auto const flank_of = [](FlankContact const& c) { return std::tuple(c.space, c.flank, c.slice); };
    auto const half_width = [&](FlankContact const& c) { return std::sqrt(2 * search.strip_depth / c.curvature); };
    std::vector<FlankContact> held;
    for (std::size_t i = 0; i < before.size(); ++i) {
        FlankContact const& old = before[i];
        auto const first = std::ranges::lower_bound(contacts, flank_of(old), {}, flank_of);
        auto const last = std::ranges::upper_bound(contacts, flank_of(old), {}, flank_of);
        bool const found = std::any_of(first, last, [&](FlankContact const& c) {
            return std::abs(c.arc_length - old.arc_length) <= std::max(half_width(c), half_width(old));
        });
        if (!(force[i] > 0) || found)
            continue;
        FlankCurve const curve(field.grid().point[static_cast<std::size_t>(old.flank)][old.slice], search.tangents);
        contact::GapField::NearTeeth const teeth = field.near_teeth(old.space, old.slice, search.turn);
        FlankView const view{field, search, curve, old.space, old.flank, old.slice, field.radius(old.flank, old.slice),
                             teeth};
        FlankCurve::Place const place = curve.place(old.arc_length);
        FlankContact c = contact_at(view, place, view.touch(curve.point(place)));
        c.curvature = old.curvature;
        c.on_edge = old.on_edge;
        held.push_back(c);
    }
    contacts.insert(contacts.end(), held.begin(), held.end());
    std::ranges::stable_sort(
        contacts, {}, [&](FlankContact const& c) { return std::tuple(c.space, c.flank, c.slice, c.arc_length); });
}

}  // namespace hdconj::load
