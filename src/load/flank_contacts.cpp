// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/load/flank_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hdconj/geometry/rigid_motion.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj {
namespace {

constexpr std::size_t stride = 8;         // of the points that tell far flanks
constexpr double window_share = 0.05;     // of the flank, either side, for the curvature

/// Ways along one flank of a slice, from the land corner.
std::vector<double> ways(std::vector<Vec2> const& line)
{
    std::vector<double> way(line.size(), 0);
    for (std::size_t i = 1; i < line.size(); ++i)
        way[i] = way[i - 1] + (line[i] - line[i - 1]).norm();
    return way;
}

/// Whether every gap is above @p limit, from every stride-th one.
bool is_far(GapField const& field, GapField::Index at, std::vector<double> const& way, double turn, double limit)
{
    std::size_t const last = way.size() - 1;
    for (std::size_t i = 0;; i = std::min(i + stride, last))
    {
        at.point = i;
        double const reach = way[std::min(i + stride, last)] - way[i];
        if (field.gap(at, turn) - std::max(reach, way[i] - way[i - std::min(i, stride)]) <= limit)
            return false;
        if (i == last)
            return true;
    }
}

double second_difference(std::vector<double> const& gap, std::vector<double> const& way, std::size_t at)
{
    std::size_t const last = way.size() - 1;
    double const window = window_share * way.back();
    std::size_t centre = at, low = at, high = at;
    // at an end the nearest point that has a window on both sides
    while (way[centre] - way.front() < window && centre < last)
        ++centre;
    while (way.back() - way[centre] < window && centre > 0)
        --centre;
    low = high = centre;
    while (low > 0 && way[centre] - way[low] < window)
        --low;
    while (high < last && way[high] - way[centre] < window)
        ++high;
    double const below = way[centre] - way[low], above = way[high] - way[centre];
    if (!(below > 0) || !(above > 0))
        return 0;
    return 2 * ((gap[high] - gap[centre]) / above - (gap[centre] - gap[low]) / below) / (above + below);
}

struct Minimum
{
    std::size_t point;
    double gap;             ///< of the parabola through its neighbours
    std::size_t next;       ///< the neighbour towards which the parabola's least point lies
    double share = 0;       ///< of the way there
};

/// Least gap, and the least other local minimum that lies contacts_apart away from it.
std::vector<Minimum> minima(std::vector<double> const& gap, std::vector<double> const& way, double limit)
{
    std::size_t const last = gap.size() - 1;
    std::size_t const least = static_cast<std::size_t>(std::min_element(gap.begin(), gap.end()) - gap.begin());
    auto const refined = [&](std::size_t i) -> Minimum {
        if (i == 0 || i == last)
            return {i, gap[i], i, 0};
        double const h0 = way[i] - way[i - 1], h1 = way[i + 1] - way[i];
        double const s0 = (gap[i] - gap[i - 1]) / h0, s1 = (gap[i + 1] - gap[i]) / h1;
        double const bend = (s1 - s0) / (h0 + h1);
        if (!(bend > 0))
            return {i, gap[i], i, 0};
        double const slope = (s0 * h1 + s1 * h0) / (h0 + h1);
        double const step = -slope / (2 * bend);
        bool const up = step > 0;
        return {i, gap[i] - slope * slope / (4 * bend), up ? i + 1 : i - 1, std::min(1.0, std::abs(step) / (up ? h1 : h0))};
    };
    std::vector<Minimum> found;
    if (gap[least] <= limit)
        found.push_back(refined(least));
    std::size_t second = gap.size();
    for (std::size_t i = 0; i <= last; ++i)
    {
        bool const minimum = (i == 0 || gap[i] < gap[i - 1]) && (i == last || gap[i] <= gap[i + 1]);
        bool const apart = std::abs(way[i] - way[least]) > contacts_apart * way.back();
        if (minimum && apart && gap[i] <= limit && (second == gap.size() || gap[i] < gap[second]))
            second = i;
    }
    if (second < gap.size())
        found.push_back(refined(second));
    std::sort(found.begin(), found.end(), [](Minimum const& a, Minimum const& b) { return a.point < b.point; });
    return found;
}

/// Everything of a contact but its curvature.
FlankContact contact_at(GapField const& field, FlankSearch const& search, std::vector<double> const& along, GapField::Index const& where, Minimum const& at)
{
    auto const f = static_cast<std::size_t>(where.flank);
    std::vector<Vec2> const& line = field.grid().point[f][where.slice];
    // between two points of the flank all of a contact goes evenly from one to the other: where it jumped, forces would have no balance
    GapField::Touch const touch = field.touch({where.space, where.flank, where.slice, at.point}, search.turn);
    GapField::Touch const beside = at.share > 0 ? field.touch({where.space, where.flank, where.slice, at.next}, search.turn) : touch;
    double const share = beside.tooth == touch.tooth ? at.share : 0;
    auto const between = [&](Vec2 const& a, Vec2 const& b) { return Vec2(a + share * (b - a)); };
    FlankContact c;
    c.space = where.space;
    c.flank = where.flank;
    c.slice = where.slice;
    c.point = at.point;
    c.next = at.next;
    c.share = at.share;
    c.tooth = touch.tooth;
    c.station = (along[at.point] + share * (along[at.next] - along[at.point])) / along.back();
    c.gap = at.gap;
    Vec2 const p = between(line[at.point], line[at.next]);
    // the gap is the distance to the tooth, so it changes along the tooth's normal; away from corners the flank's is the same
    Vec2 const normal = between(touch.normal, beside.normal).normalized();
    c.lever = normal.x() * p.y() - normal.y() * p.x();
    // the circular spline stands turned back by `turn` against the wave generator
    double const phi = 2 * std::numbers::pi * touch.tooth / search.flexspline_teeth + search.phase;
    Vec2 const n = turned_clockwise(normal, field.space_angle(where.space) - search.turn - phi);
    c.c_t = n.x();
    c.c_r = n.y();
    Vec2 const foot = between(touch.nearest.point, beside.nearest.point);
    // arm in the tooth's frame: turns against the ring by less than a degree do not change it
    Vec2 const own = between(touch.nearest.normal, beside.nearest.normal).normalized();
    c.c_turn = own.x() * foot.y() - own.y() * foot.x();
    c.tooth_x = foot.x();
    c.tooth_y = foot.y();
    c.inclination = own.y();
    return c;
}

}  // namespace

std::vector<FlankContact> flank_contacts(GapField const& field, FlankSearch const& search, int threads)
{
    FlankGrid const& grid = field.grid();
    std::vector<std::vector<double>> way(2 * grid.slices());
    for (std::size_t f = 0; f < 2; ++f)
        for (std::size_t k = 0; k < grid.slices(); ++k)
            way[f * grid.slices() + k] = ways(grid.point[f][k]);
    std::vector<std::vector<FlankContact>> found(search.spaces);
    constexpr std::size_t grain = 4;
    parallel_for(search.spaces, threads, grain, [&](std::size_t s) {
        std::vector<double> gap;
        std::size_t const space = search.first_space + s;
        for (int flank = 0; flank < 2; ++flank)
            for (std::size_t k = 0; k < grid.slices(); ++k)
            {
                auto const f = static_cast<std::size_t>(flank);
                std::vector<double> const& along = way[f * grid.slices() + k];
                if (is_far(field, {space, flank, k, 0}, along, search.turn, search.limit))
                    continue;
                field.along(space, flank, k, search.turn, gap);
                for (Minimum const& at : minima(gap, along, search.limit))
                {
                    FlankContact c = contact_at(field, search, along, {space, flank, k, at.point}, at);
                    c.curvature = std::clamp(second_difference(gap, along, at.point), search.least_curvature, search.largest_curvature);
                    found[s].push_back(c);
                }
            }
    });
    std::vector<FlankContact> all;
    for (auto const& each : found)
        all.insert(all.end(), each.begin(), each.end());
    return all;
}

std::vector<FlankContact> at_same_places(GapField const& field, FlankSearch const& search, std::vector<FlankContact> const& contacts, int threads)
{
    std::vector<FlankContact> found(contacts.size());
    constexpr std::size_t grain = 256;
    parallel_for(contacts.size(), threads, grain, [&](std::size_t i) {
        FlankContact const& old = contacts[i];
        GapField::Index const first{old.space, old.flank, old.slice, old.point}, second{old.space, old.flank, old.slice, old.next};
        double const gap = field.gap(first, search.turn);
        double const beside = old.share > 0 ? field.gap(second, search.turn) : gap;
        std::vector<double> const along = ways(field.grid().point[static_cast<std::size_t>(old.flank)][old.slice]);
        found[i] = contact_at(field, search, along, first, {old.point, gap + old.share * (beside - gap), old.next, old.share});
        found[i].curvature = old.curvature;
    });
    return found;
}

}  // namespace hdconj
