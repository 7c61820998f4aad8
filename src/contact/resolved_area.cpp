// SPDX-License-Identifier: GPL-3.0-or-later
#include "resolved_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <utility>

#include "gap_field.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::contact {
namespace {

constexpr std::size_t edge_steps = 16;  // between two points of the map, where the edge of the contact may be

/// Contact of one space, or of all, by all edge_steps, by every second one and by every fourth.
using Sums = Eigen::Array3d;

/// The flank of one space.
class SpaceArea
{
  public:
    SpaceArea(GapField const& field, double turn, std::size_t space, int flank, double limit)
        : field_(&field),
          turn_(turn),
          space_(space),
          flank_(flank),
          limit_(limit),
          points_(field.grid().points()),
          looked_(field.grid().slices() * points_)
    {
        gaps_.assign(field.grid().slices(), std::vector<double>(points_));
        near_limit_.assign(gaps_.size() * points_, 0);
        for (std::size_t k = 0; k < gaps_.size(); ++k) {
            field.along(space, flank, k, turn, gaps_[k].data());
            for (std::size_t j = 0; j + 1 < points_; ++j)
                near_limit_[k * points_ + j] = may_reach_limit(k, j) ? 1 : 0;
        }
    }

    /// The smallest gap, between the points too where it is below @p below.
    [[nodiscard]] double lowest(double below) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < gaps_.size(); ++k)
            least =
                std::min(least, smallest_on_line(*field_, {space_, flank_, k, 0}, gaps_[k].data(), turn_, below).gap);
        return least;
    }

    /// The strip between the slices @p low and @p high, laid at the heights @p z_low and @p z_high.
    /// @param parts  so many of the three sums
    [[nodiscard]] Sums strip(std::size_t low, std::size_t high, double z_low, double z_high, int parts)
    {
        Sums sums = Sums::Zero();
        FlankGrid const& grid = field_->grid();
        auto const& line = grid.point[static_cast<std::size_t>(flank_)];
        for (std::size_t j = 0; j + 1 < points_; ++j) {
            if (!near_limit(low, j) && !near_limit(high, j) && inside(low, j) == inside(high, j)) {
                std::array<AreaCorner, 4> const corner{
                    at(line[low][j], z_low, gap(low, j)), at(line[low][j + 1], z_low, gap(low, j + 1)),
                    at(line[high][j + 1], z_high, gap(high, j + 1)), at(line[high][j], z_high, gap(high, j))};
                double contact = 0;
                if (inside(low, j)) {
                    add_contact_of_cell(corner, contact);
                    sums += contact;
                }
                continue;
            }
            Steps const& a = between(low, j);
            Steps const& b = between(high, j);
            for (int part = 0; part < parts; ++part) {
                std::size_t const stride = std::size_t{1} << part;
                double contact = 0;
                for (std::size_t i = 0; i < edge_steps; i += stride)
                    add_contact_of_cell(
                        {at(a.point[i], z_low, a.gap[i]), at(a.point[i + stride], z_low, a.gap[i + stride]),
                         at(b.point[i + stride], z_high, b.gap[i + stride]), at(b.point[i], z_high, b.gap[i])},
                        contact);
                sums[part] += contact;
            }
        }
        return sums;
    }

  private:
    struct Steps
    {
        std::array<Vec2, edge_steps + 1> point;
        std::array<double, edge_steps + 1> gap;
    };

    [[nodiscard]] double gap(std::size_t slice, std::size_t j) const { return gaps_[slice][j]; }
    [[nodiscard]] AreaCorner at(Vec2 const& p, double z, double g) const { return {{p.x(), p.y(), z}, g - limit_}; }
    [[nodiscard]] bool inside(std::size_t slice, std::size_t j) const { return gap(slice, j) <= limit_; }

    /// Whether the gap may reach the limit between the points j and j + 1, going on as steeply as anywhere beside.
    [[nodiscard]] bool may_reach_limit(std::size_t slice, std::size_t j) const
    {
        double change = 0;
        for (std::size_t i = j > 0 ? j - 1 : j; i <= j + 1 && i + 1 < points_; ++i)
            change = std::max(change, std::abs(gap(slice, i + 1) - gap(slice, i)));
        double const low = std::min(gap(slice, j), gap(slice, j + 1)),
                     high = std::max(gap(slice, j), gap(slice, j + 1));
        return low - change <= limit_ && limit_ <= high + change;
    }

    [[nodiscard]] bool near_limit(std::size_t slice, std::size_t j) const
    {
        return near_limit_[slice * points_ + j] != 0;
    }

    [[nodiscard]] Steps const& between(std::size_t slice, std::size_t j)
    {
        std::size_t& slot = looked_[slice * points_ + j];
        if (slot == 0) {
            FlankGrid const& grid = field_->grid();
            Steps made;
            double const from = grid.place(flank_, j), to = grid.place(flank_, j + 1);
            auto const& line = grid.point[static_cast<std::size_t>(flank_)][slice];
            made.point.front() = line[j];
            made.point.back() = line[j + 1];
            made.gap.front() = gap(slice, j);
            made.gap.back() = gap(slice, j + 1);
            for (std::size_t i = 1; i < edge_steps; ++i)
                made.point[i] = grid.between(flank_, slice, from + (to - from) * static_cast<double>(i) / edge_steps);
            field_->gaps(space_, flank_, slice, made.point.data() + 1, edge_steps - 1, turn_, made.gap.data() + 1);
            kept_.push_back(made);
            slot = kept_.size();
        }
        return kept_[slot - 1];
    }

    GapField const* field_;
    double turn_;
    std::size_t space_;
    int flank_;
    double limit_;
    std::size_t points_;
    std::vector<std::vector<double>> gaps_;
    std::vector<std::uint8_t> near_limit_;  // (k,j): may_reach_limit()
    std::vector<std::size_t> looked_;       // place in kept_ from 1 on; 0: not looked at
    std::deque<Steps> kept_;
};

/// Area of one flank of one space. An overlap that side clearance leaves beyond an end of the flank (trim_overlaps())
/// runs backwards for as far as its neighbours overrun their crossing: such stretches count as less than nothing, so
/// that the area does not depend on how finely the bend is drawn.
/// @p stride: every so many of the slices.
double flank_area(FlankGrid const& grid, int flank, double width, std::size_t stride)
{
    auto const f = static_cast<std::size_t>(flank);
    auto const& line = grid.line[f].empty() ? grid.point[f] : grid.line[f];
    auto const& normal = grid.line[f].empty() ? grid.normal[f] : grid.line_normal[f];
    bool const strip = grid.slices() == 1;
    double area = 0;
    for (std::size_t k = 0; k + 1 < (strip ? 2 : grid.slices()); k += stride) {
        std::size_t const high = strip ? k : std::min(k + stride, grid.slices() - 1);
        double const z_low = strip ? -width / 2 : grid.z[k], z_high = strip ? width / 2 : grid.z[high];
        auto const corner = [&](std::size_t slice, double z, std::size_t j) {
            return AreaCorner{{line[slice][j].x(), line[slice][j].y(), z}, 1};
        };
        for (std::size_t j = 0; j + 1 < line[k].size(); ++j) {
            double contact = 0, whole = 0;
            add_cell(
                {corner(k, z_low, j), corner(k, z_low, j + 1), corner(high, z_high, j + 1), corner(high, z_high, j)},
                contact, whole);
            // from the land corner outward, with the material on the right of the right flank
            Vec2 const n = normal[k][j] + normal[k][j + 1];
            Vec2 const onward = flank == GapMap::right ? left_of(n) : right_of(n);
            area += (line[k][j + 1] - line[k][j]).dot(onward) < 0 ? -whole : whole;
        }
    }
    return area;
}

/// What the chords of one flank are short of its arcs, which turn by theta from end to end: theta^2/24 of each, of the
/// area in all slices. A bend is no arc: it counts as one at most.
double arcs_over_chords(FlankGrid const& grid, int flank, double width)
{
    constexpr double circle = 24;
    auto const f = static_cast<std::size_t>(flank);
    auto const& line = grid.line[f].empty() ? grid.point[f] : grid.line[f];
    auto const& normal = grid.line[f].empty() ? grid.normal[f] : grid.line_normal[f];
    double most = 0;
    for (std::size_t k = 0; k < grid.slices(); ++k) {
        double over = 0;
        for (std::size_t j = 0; j + 1 < line[k].size(); ++j)
            over += (line[k][j + 1] - line[k][j]).norm() * (normal[k][j + 1] - normal[k][j]).squaredNorm() / circle;
        most = std::max(most, over);
    }
    return most * (grid.slices() == 1 ? width : grid.z.back() - grid.z.front());
}

/// What is left of a value by @p all places, half and a quarter of them: see ResolvedArea.
double left_open(double all, double half, double quarter)
{
    constexpr double best = 0.5, worst = 2.0 / 3, safety = 2;
    double const by_two = std::abs(all - half), by_four = std::abs(half - quarter);
    double const falls = by_four > 0 ? std::clamp(by_two / by_four, best, worst) : worst;
    // a difference may be small by chance, two hardly are: no less than what second order leaves of the coarser one
    return std::max(safety * by_two * falls / (1 - falls), by_four / 2);
}

}  // namespace

ResolvedArea resolved_area(GapField const& field, std::vector<std::size_t> const& spaces, double turn, int flank,
                           double limit, double width, int threads, bool errors)
{
    FlankGrid const& grid = field.grid();
    std::size_t const last = grid.slices() - 1;
    int const parts = errors ? 3 : 1;
    struct Space
    {
        Sums all = Sums::Zero(), second = all, fourth = all;  ///< of all slices, every second and every fourth
        bool touches = false;
    };
    std::vector<Space> found(spaces.size());
    constexpr std::size_t grain = 2;
    parallel_for(spaces.size(), threads, grain, [&](std::size_t s) {
        SpaceArea area(field, turn, spaces[s], flank, limit);
        Space& space = found[s];
        // one slice is a strip between two copies of itself
        if (last == 0)
            space.all = space.second = space.fourth = area.strip(0, 0, -width / 2, width / 2, parts);
        for (std::size_t k = 0; k < last; ++k)
            space.all += area.strip(k, k + 1, grid.z[k], grid.z[k + 1], parts);
        // a touch may be narrower than what the area is summed over
        space.touches = space.all[0] > 0 || area.lowest(limit) <= limit;
        for (auto const& [stride, sums] :
             {std::pair{std::size_t{2}, &space.second}, std::pair{std::size_t{4}, &space.fourth}})
            for (std::size_t k = 0; errors && k < last; k += stride)
                *sums += area.strip(k, std::min(k + stride, last), grid.z[k], grid.z[std::min(k + stride, last)], 1);
    });
    ResolvedArea result;
    Sums all = Sums::Zero(), second = all, fourth = all;
    for (Space const& space : found) {
        all += space.all;
        second += space.second;
        fourth += space.fourth;
        result.area.spaces += space.touches ? field.lobes() : 0;
    }
    for (Sums* const sums : {&all, &second, &fourth})
        *sums *= field.lobes();
    // all spaces have the same flanks
    result.area.contact = all[0];
    auto const every = [&](std::size_t stride) { return flank_area(grid, flank, width, stride); };
    double const one = every(1);
    result.area.whole = std::max(one * static_cast<double>(field.spaces()), all[0]);
    if (!errors)
        return result;
    double const open = (last == 0 ? 0 : left_open(one, every(2), every(4))) + arcs_over_chords(grid, flank, width);
    result.whole = open * static_cast<double>(field.spaces());
    if (!(result.area.whole > 0))
        return result;
    result.along = left_open(all[0], all[1], all[2]) / result.area.whole;
    result.across = left_open(all[0], second[0], fourth[0]) / result.area.whole;
    return result;
}

}  // namespace hdconj::contact
