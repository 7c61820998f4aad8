// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_grid.hpp"

#include <algorithm>
#include <utility>

#include "hdconj/contact.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "parallel_trim.hpp"
#include "surface/cone.hpp"

namespace hdconj::contact {
namespace {

/// Points of a flank, from the land corner on, that lie within the circle @p tip come together where the flank crosses
/// it.
void cut_at_tip(std::vector<Vec2>& point, std::vector<Vec2>& normal, double tip)
{
    auto const outside = std::find_if(point.begin(), point.end(), [tip](Vec2 const& p) { return p.norm() >= tip; });
    if (outside == point.begin() || outside == point.end())
        return;
    auto const first = static_cast<std::size_t>(outside - point.begin());
    auto const at = [&, last = first](double t) {
        return hermite_between(point[last - 1], normal[last - 1], point[last], normal[last], t);
    };
    double const t = numeric::bracketed_root([&](double s) { return at(s).norm() - tip; }, 0.0, 1.0,
                                             point[first - 1].norm() - tip, point[first].norm() - tip)
                         .x;
    Vec2 const corner = at(t), its_normal = ((1 - t) * normal[first - 1] + t * normal[first]).normalized();
    std::fill(point.begin(), outside, corner);
    std::fill(normal.begin(), normal.begin() + static_cast<std::ptrdiff_t>(first), its_normal);
}

/// Moves points along their normals by @p offset, those that have been moved outward by @p shift before as they were
/// without.
void move(std::vector<Vec2>& points, std::vector<Vec2>& normals, double offset, double shift)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2& p = points[i];
        Vec2& n = normals[i];
        if (shift == 0 || offset == 0) {
            p += offset * n;
            continue;
        }
        Vec2 const before = surface::moved_radially(p, -shift), normal = surface::normal_moved_radially(p, n, -shift),
                   moved = before + offset * normal;
        p = surface::moved_radially(moved, shift);
        n = surface::normal_moved_radially(moved, normal, shift);
    }
}

/// Shares of the length of the right flank in the middle slice.
std::vector<double> stations_of(FlankGrid const& grid)
{
    std::size_t const k = grid.slices() / 2;
    bool const whole = !grid.line[GapMap::right].empty();
    std::vector<Vec2> const& line = whole ? grid.line[GapMap::right][k] : grid.point[GapMap::right][k];
    std::vector<double> way{0};
    for (std::size_t i = 1; i < line.size(); ++i)
        way.push_back(way.back() + (line[i] - line[i - 1]).norm());
    std::vector<double> station;
    for (std::size_t j = 0; j < grid.points(); ++j)
        station.push_back(way[whole ? grid.index[GapMap::right][j] : j] / way.back());
    return station;
}

}  // namespace

double FlankGrid::place(int flank, std::size_t j) const
{
    auto const& chosen = index[static_cast<std::size_t>(flank)];
    return static_cast<double>(chosen.empty() ? j : chosen[j]);
}

Vec2 FlankGrid::between(int flank, std::size_t slice, double s) const
{
    auto const f = static_cast<std::size_t>(flank);
    auto const& points = line[f].empty() ? point[f][slice] : line[f][slice];
    auto const& normals = line[f].empty() ? normal[f][slice] : line_normal[f][slice];
    auto const first = std::min(static_cast<std::size_t>(s), points.size() - 2);
    double const t = s - static_cast<double>(first);
    Vec2 const& a = points[first];
    Vec2 const& b = points[first + 1];
    Vec2 const chord = b - a;
    double const length = chord.norm();
    if (t == 0 || length == 0)
        return a;
    // the path of circles' centres turns where they leave the flank, and knows no tangents there
    if (!radius[f].empty())
        return a + t * chord;
    return hermite_between(a, normals[first], b, normals[first + 1], t);
}

FlankGrid flank_grid(conjugate::MatchedOutline const& outline, std::vector<double> const& z, int count)
{
    FlankGrid grid;
    grid.z = z;
    std::size_t const middle = z.size() / 2;
    auto const& line = outline.points[middle];
    struct Ends
    {
        std::size_t land, last;
    };
    std::array<Ends, 2> ends;
    ends[GapMap::left] = {outline.landmarks[0], outline.landmarks[1]};
    ends[GapMap::right] = {outline.landmarks[4], outline.landmarks[3]};
    // lengths along the right flank, from the land corner down; the left one has the mirror image's indices where the
    // outline is symmetric
    std::array<std::vector<std::size_t>, 2> index;
    auto const choose = [&](int flank) {
        auto const [from, to] = ends[static_cast<std::size_t>(flank)];
        std::vector<std::size_t>& chosen = index[static_cast<std::size_t>(flank)];
        std::ptrdiff_t const step = to > from ? 1 : -1;
        std::vector<double> length{0};
        for (auto i = static_cast<std::ptrdiff_t>(from); i != static_cast<std::ptrdiff_t>(to); i += step)
            length.push_back(length.back() +
                             (line[static_cast<std::size_t>(i + step)] - line[static_cast<std::size_t>(i)]).norm());
        std::vector<double> stations;
        for (int j = 0; j < count; ++j) {
            double const wanted = length.back() * j / (count - 1);
            auto const after = std::lower_bound(length.begin(), length.end(), wanted) - length.begin();
            auto const at = std::min<std::ptrdiff_t>(after, static_cast<std::ptrdiff_t>(length.size()) - 1);
            auto const best = at > 0 && wanted - length[static_cast<std::size_t>(at - 1)] <
                                            length[static_cast<std::size_t>(at)] - wanted
                                  ? at - 1
                                  : at;
            auto const point = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + step * best);
            if (!chosen.empty() && chosen.back() == point)
                continue;
            chosen.push_back(point);
            stations.push_back(length[static_cast<std::size_t>(best)] / length.back());
        }
        return stations;
    };
    grid.station = choose(GapMap::right);
    (void)choose(GapMap::left);
    // an asymmetric pair's flanks may differ in their number of points: the shorter list decides
    std::size_t const points = std::min(index[0].size(), index[1].size());
    grid.station.resize(points);
    for (std::size_t f = 0; f < 2; ++f) {
        auto const [land, last] = ends[f];
        for (std::size_t j = 0; j < points; ++j) {
            std::size_t const i = j + 1 == points ? index[f].back() : index[f][j];
            grid.index[f].push_back(i > land ? i - land : land - i);
        }
        for (std::size_t k = 0; k < z.size(); ++k) {
            auto &line_point = grid.line[f].emplace_back(), &line_normal = grid.line_normal[f].emplace_back();
            for (std::size_t i = land;; last > land ? ++i : --i) {
                line_point.push_back(outline.points[k][i]);
                line_normal.push_back(outline.normals[k][i]);
                if (i == last)
                    break;
            }
            auto &point = grid.point[f].emplace_back(), &normal = grid.normal[f].emplace_back();
            for (std::size_t const j : grid.index[f]) {
                point.push_back(line_point[j]);
                normal.push_back(line_normal[j]);
            }
        }
    }
    return grid;
}

FlankGrid moved_into_material(FlankGrid grid, double offset)
{
    offset -= std::exchange(grid.included_clearance, offset);
    for (std::size_t f = 0; f < 2; ++f)
        for (std::size_t k = 0; k < grid.slices(); ++k) {
            bool const whole = !grid.line[f].empty();
            std::vector<Vec2>& line = whole ? grid.line[f][k] : grid.point[f][k];
            std::vector<Vec2>& normal = whole ? grid.line_normal[f][k] : grid.normal[f][k];
            double const shift = grid.shift.empty() ? 0 : grid.shift[k];
            if (whole)
                move(grid.point[f][k], grid.normal[f][k], offset, shift);
            std::vector<Vec2> const bare = line;
            move(line, normal, offset, shift);
            bool const curve = grid.radius[f].empty();
            bool changed = curve && offset != 0 && trim_overlaps(bare, line, normal) > 0;
            if (curve && !grid.tip.empty()) {
                cut_at_tip(line, normal, grid.tip[k]);
                changed = true;
            }
            if (!changed || !whole)
                continue;
            for (std::size_t j = 0; j < grid.points(); ++j) {
                grid.point[f][k][j] = line[grid.index[f][j]];
                grid.normal[f][k][j] = normal[grid.index[f][j]];
            }
        }
    if (!grid.tip.empty())
        grid.station = stations_of(grid);
    return grid;
}

FlankGrid slice_of(FlankGrid const& grid, std::size_t k)
{
    FlankGrid one;
    one.z = {grid.z[k]};
    one.station = grid.station;
    one.index = grid.index;
    if (!grid.tip.empty())
        one.tip = {grid.tip[k]};
    if (!grid.shift.empty())
        one.shift = {grid.shift[k]};
    one.included_clearance = grid.included_clearance;
    auto const take = [k](auto const& all, auto& one_of_them) {
        for (std::size_t f = 0; f < 2; ++f)
            if (!all[f].empty())
                one_of_them[f] = {all[f][k]};
    };
    take(grid.point, one.point);
    take(grid.normal, one.normal);
    take(grid.line, one.line);
    take(grid.line_normal, one.line_normal);
    take(grid.radius, one.radius);
    return one;
}

}  // namespace hdconj::contact
