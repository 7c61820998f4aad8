// SPDX-License-Identifier: GPL-3.0-or-later
#include "backlash.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cleaning.hpp"

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

/// Readings of a branch by ascending torque, without those that have no load.
std::vector<std::size_t> loaded_readings(Samples const& samples, LoadBranch const& branch, double no_load)
{
    std::vector<std::size_t> at = by_torque(samples, branch);
    std::erase_if(at, [&](std::size_t i) { return std::abs(samples.torque[i]) < no_load; });
    return at;
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

/// Readings that a jump is fitted to, by their distance from a torque [N mm].
struct Neighbourhood
{
    double centre, window;
};

/// Height of the jump between the readings below and from @p first_above on.
Found height_of(Samples const& samples, std::vector<std::size_t> const& at, std::size_t first_above,
                Neighbourhood const& near, Noise const& noise)
{
    auto const count = static_cast<Eigen::Index>(at.size()), above = static_cast<Eigen::Index>(first_above);
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count, 3);
    Eigen::VectorXd angles(count);
    columns.col(0).head(above).setOnes();
    columns.col(1).tail(count - above).setOnes();
    for (Eigen::Index i = 0; i < count; ++i) {
        std::size_t const k = at[static_cast<std::size_t>(i)];
        columns(i, 2) = (samples.torque[k] - near.centre) / near.window;
        angles[i] = samples.twist[k];
    }
    return fitted(columns, angles, Eigen::Vector3d(-1, 1, 0), noise);
}

/// The jump between the readings @p at of a neighbourhood at the torque @p split; without one, between those two
/// readings that leave the least squares.
/// @param at  readings by ascending torque
/// @returns nothing where a side has too few readings; Jump::seen is left to the caller
std::optional<Jump> jump_about(Samples const& samples, std::vector<std::size_t> at, Neighbourhood const& near,
                               std::optional<double> split, Noise const& noise)
{
    std::erase_if(at, [&](std::size_t i) { return std::abs(samples.torque[i] - near.centre) > near.window; });
    if (at.size() < 2 * fewest)
        return std::nullopt;
    double const count = static_cast<double>(at.size());
    double mean = 0;
    for (std::size_t const i : at)
        mean += samples.twist[i] / count;
    auto const add = [&](Side& side, std::size_t i, double sign) {
        side.add((samples.torque[i] - near.centre) / near.window, samples.twist[i] - mean, sign);
    };
    Side low, high;
    for (std::size_t const i : at)
        add(high, i, 1);
    Fit best;
    std::size_t first_above = 0;
    for (std::size_t k = 1; k + fewest <= at.size(); ++k) {
        add(low, at[k - 1], 1);
        add(high, at[k - 1], -1);
        if (k < fewest || (split && (samples.torque[at[k - 1]] > *split || samples.torque[at[k]] <= *split)))
            continue;
        Fit const fit = lines_beside(low, high);
        if (fit.squares < best.squares) {
            best = fit;
            first_above = k;
        }
    }
    if (!std::isfinite(best.squares))
        return std::nullopt;
    return Jump{height_of(samples, at, first_above, near, noise), false,
                std::max(-samples.torque[at[first_above - 1]], samples.torque[at[first_above]])};
}

constexpr double clear = 5;  // standard errors: beyond what the best of some hundred places reaches by chance

}  // namespace

double unloaded_torque(Samples const& samples, std::vector<LoadBranch> const& branches, double window,
                       Noise const& noise)
{
    struct Place
    {
        double torque, height, from, to;
        bool rising;
    };
    std::vector<Place> places;  // height 0: none that noise would not make
    double highest = 0;
    for (LoadBranch const& branch : branches) {
        std::vector<std::size_t> const at = by_torque(samples, branch);
        double const from = samples.torque[at.front()] + window, to = samples.torque[at.back()] - window;
        auto const place = from < to ? place_of_jump(samples, at, from, to, window) : std::nullopt;
        auto const jump = place ? jump_about(samples, at, {*place, window}, std::nullopt, noise) : std::nullopt;
        bool const seen = jump && jump->height.value > clear * jump->height.both();
        places.push_back({place.value_or(0), seen ? jump->height.value : 0, from, to, branch.rising});
        highest = std::max(highest, places.back().height);
    }
    // A bend of a branch that does not cross the backlash, or noise of a single one, is no jump of all.
    auto const jump_of_all = [&](bool rising) -> std::optional<double> {
        std::vector<double> torques;
        for (Place const& each : places)
            if (each.rising == rising && each.height > highest / 2)
                torques.push_back(each.torque);
        if (torques.empty())
            return std::nullopt;
        double const middle = quantile(torques, 0.5);
        auto const crosses = [&](Place const& each) {
            return each.rising == rising && each.from < middle && middle < each.to;
        };
        auto const jumps = [&](double torque) { return std::abs(torque - middle) < window / 2; };
        auto const crossing = std::ranges::count_if(places, crosses), jumping = std::ranges::count_if(torques, jumps);
        return 3 * jumping >= 2 * crossing ? std::optional(middle) : std::nullopt;
    };
    std::optional<double> const up = jump_of_all(true), down = jump_of_all(false);
    double const middle = up && down ? std::midpoint(*up, *down) : 0;
    return std::abs(middle) > window / 2 ? middle : 0;
}

std::optional<Jump> jump_of_play(Samples const& samples, LoadBranch const& branch, double friction, double window,
                                 double no_load, Noise const& noise)
{
    constexpr double spread = 1.25;  // of the friction about its median
    double const beside = window / 2, still = window / 4;
    std::vector<std::size_t> const at = loaded_readings(samples, branch, no_load);
    auto const place = branch.rising ? place_of_jump(samples, at, -beside, spread * friction + beside, window)
                                     : place_of_jump(samples, at, -spread * friction - beside, beside, window);
    if (!place)
        return std::nullopt;
    auto const about = [&](double centre, std::optional<double> split) {
        return jump_about(samples, at, {std::abs(centre) > still ? centre : 0, window}, split, noise);
    };
    std::optional<Jump> best = about(*place, std::nullopt);
    if (!best)
        return std::nullopt;
    best->seen = best->height.value > clear * best->height.both();
    if (best->seen)
        return best;
    double const crossing = branch.rising ? friction : -friction;
    if (std::optional<Jump> const known = about(crossing, crossing))
        return known;
    best->height.error = std::max(best->height.error, std::abs(best->height.value));
    return best;
}

}  // namespace hdconj::rig
