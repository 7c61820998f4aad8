// SPDX-License-Identifier: GPL-3.0-or-later
#include "backlash.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cleaning.hpp"
#include "numeric/quantile.hpp"

namespace hdconj::rig {
namespace {

/// Sums of angle over torque on one side of a place.
struct Side
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void add(double px, double py, double sign = 1)
    {
        n += sign;
        x += sign * px;
        y += sign * py;
        xx += sign * px * px;
        xy += sign * px * py;
        yy += sign * py * py;
    }
    [[nodiscard]] double about_mean_xx() const { return xx - x * x / n; }
    [[nodiscard]] double about_mean_xy() const { return xy - x * y / n; }
    [[nodiscard]] double about_mean_yy() const { return yy - y * y / n; }
};

constexpr std::size_t fewest = 3;  // readings on one side

/// Where a branch crosses the backlash [N mm].
struct Crossing
{
    double torque = 0;  ///< between two readings
    double apart = 0;   ///< distance of these
};

struct Fit
{
    double height = 0, squares = std::numeric_limits<double>::infinity();
};

/// Two parallel lines through both sides.
Fit lines_beside(Side const& low, Side const& high)
{
    double const xx = low.about_mean_xx() + high.about_mean_xx();
    double const slope = (low.about_mean_xy() + high.about_mean_xy()) / xx;
    double const apart = high.x / high.n - low.x / low.n;
    return {high.y / high.n - low.y / low.n - slope * apart,
            low.about_mean_yy() + high.about_mean_yy() - slope * slope * xx};
}

/// The torque about which two parallel lines, of the readings up to @p window to either side, are furthest apart.
/// @param at  readings by ascending torque
/// @returns nothing where the branch does not reach so far beyond @p from and @p to, or no torque between them has
/// enough readings on both sides
std::optional<double> place_of_jump(Samples const& samples, std::vector<std::size_t> const& at, double from, double to,
                                    double window)
{
    std::optional<double> place;
    double highest = 0;
    auto const torque = [&](std::size_t k) { return samples.torque[at[k]]; };
    if (at.empty() || torque(0) > from - window || torque(at.size() - 1) < to + window)
        return std::nullopt;
    for (std::size_t split = fewest; split + fewest <= at.size(); ++split) {
        double const middle = std::midpoint(torque(split - 1), torque(split));
        if (middle < from || middle > to)
            continue;
        Side low, high;
        auto const add = [&](Side& side, std::size_t k) {
            side.add((torque(k) - middle) / window, samples.twist[at[k]] - samples.twist[at[split]]);
        };
        for (std::size_t k = split; k-- > 0 && torque(k) >= middle - window;)
            add(low, k);
        for (std::size_t k = split; k < at.size() && torque(k) <= middle + window; ++k)
            add(high, k);
        if (std::min(low.n, high.n) < fewest)
            continue;
        double const height = lines_beside(low, high).height;
        if (!place || height > highest) {
            place = middle;
            highest = height;
        }
    }
    return place;
}

/// The torque between those two readings whose split leaves the least squares of two parallel lines, of the readings up
/// to @p window from @p place.
/// @param at  readings by ascending torque
/// @returns nothing where a side has too few readings
std::optional<Crossing> crossing_about(Samples const& samples, std::vector<std::size_t> at, double place, double window)
{
    std::erase_if(at, [&](std::size_t i) { return std::abs(samples.torque[i] - place) > window; });
    if (at.size() < 2 * fewest)
        return std::nullopt;
    auto const add = [&](Side& side, std::size_t i, double sign) {
        side.add((samples.torque[i] - place) / window, samples.twist[i] - samples.twist[at[0]], sign);
    };
    Side low, high;
    for (std::size_t const i : at)
        add(high, i, 1);
    double least = std::numeric_limits<double>::infinity();
    std::size_t first_above = 0;
    for (std::size_t k = 1; k + fewest <= at.size(); ++k) {
        add(low, at[k - 1], 1);
        add(high, at[k - 1], -1);
        if (double const squares = lines_beside(low, high).squares; k >= fewest && squares < least) {
            least = squares;
            first_above = k;
        }
    }
    if (!std::isfinite(least))
        return std::nullopt;
    double const below = samples.torque[at[first_above - 1]], above = samples.torque[at[first_above]];
    return Crossing{std::midpoint(below, above), above - below};
}

/// Heights of the jump at @p crossing [rad] by the readings beyond the gap.
ByCurve heights_at(Samples const& samples, std::vector<std::size_t> const& at, double crossing, Reach const& reach,
                   Noise const& noise)
{
    CrossingReadings readings;
    for (std::size_t const i : at) {
        BesideCrossing const reading{samples.torque[i] - crossing, samples.twist[i]};
        double const distance = std::abs(reading.distance);
        if (distance < reach.gap || distance > 2 * reach.far)
            continue;
        readings.farther.push_back(reading);
        if (distance <= reach.far)
            readings.near.push_back(reading);
    }
    return extrapolations(readings, AtCrossing::jump, reach.far, noise);
}

/// By more than noise makes.
bool is_clear(ByCurve const& heights)
{
    constexpr double clear = 5;  // standard errors: beyond what the best of some hundred places reaches by chance
    return !heights.empty() && heights[line].value > clear * heights[line].both();
}

}  // namespace

double unloaded_torque(Samples const& samples, std::vector<LoadBranch> const& branches, Reach const& reach,
                       Noise const& noise)
{
    struct Place
    {
        Crossing crossing;
        double height, from, to;  // height 0: none that noise would not make
        bool rising;
    };
    std::vector<Place> places;
    double highest = 0;
    for (LoadBranch const& branch : branches) {
        std::vector<std::size_t> const at = by_torque(samples, branch);
        double const from = samples.torque[at.front()] + reach.far, to = samples.torque[at.back()] - reach.far;
        auto const place = from < to ? place_of_jump(samples, at, from, to, reach.far) : std::nullopt;
        auto const found = place ? crossing_about(samples, at, *place, reach.far) : std::nullopt;
        ByCurve const heights = found ? heights_at(samples, at, found->torque, reach, noise) : ByCurve{};
        places.push_back(
            {found.value_or(Crossing{}), is_clear(heights) ? heights[line].value : 0, from, to, branch.rising});
        highest = std::max(highest, places.back().height);
    }
    // A bend of a branch that does not cross the backlash, or noise of a single one, is no jump of all.
    auto const jump_of_all = [&](bool rising) -> std::optional<Crossing> {
        std::vector<double> torques, apart;
        for (Place const& each : places)
            if (each.rising == rising && each.height > highest / 2) {
                torques.push_back(each.crossing.torque);
                apart.push_back(each.crossing.apart);
            }
        if (torques.empty())
            return std::nullopt;
        double const middle = numeric::quantile(torques, 0.5);
        auto const crosses = [&](Place const& each) {
            return each.rising == rising && each.from < middle && middle < each.to;
        };
        auto const jumps = [&](double torque) { return std::abs(torque - middle) < reach.far / 2; };
        auto const crossing = std::ranges::count_if(places, crosses), jumping = std::ranges::count_if(torques, jumps);
        return 3 * jumping >= 2 * crossing ? std::optional(Crossing{middle, numeric::quantile(apart, 0.5)})
                                           : std::nullopt;
    };
    std::optional<Crossing> const up = jump_of_all(true), down = jump_of_all(false);
    if (!up || !down)
        return 0;
    double const middle = std::midpoint(up->torque, down->torque);
    return std::abs(middle) > std::max({reach.gap, up->apart, down->apart}) ? middle : 0;
}

std::optional<Jump> jump_of_play(Samples const& samples, LoadBranch const& branch, Found const& friction,
                                 Reach const& reach, Noise const& noise)
{
    constexpr double spread = 1.25;  // of the friction about its median
    double const beside = reach.far / 2, farthest = spread * friction.value + beside;
    double const known = branch.rising ? friction.value : -friction.value;
    std::vector<std::size_t> const at = by_torque(samples, branch);
    auto const place = branch.rising ? place_of_jump(samples, at, -beside, farthest, reach.far)
                                     : place_of_jump(samples, at, -farthest, beside, reach.far);
    auto const found = place ? crossing_about(samples, at, *place, reach.far) : std::nullopt;
    if (!found)
        return std::nullopt;
    auto const jump_at = [&](double crossing) {
        return Jump{heights_at(samples, at, crossing, reach, noise), false, std::abs(crossing) + reach.gap};
    };
    Jump jump = jump_at(std::abs(found->torque - known) < reach.gap / 2 ? known : found->torque);
    jump.seen = is_clear(jump.heights);
    if (!jump.seen && friction.value + friction.error > farthest)
        return std::nullopt;
    if (!jump.seen)
        jump = jump_at(known);
    return jump.heights.empty() ? std::nullopt : std::optional(jump);
}

}  // namespace hdconj::rig
