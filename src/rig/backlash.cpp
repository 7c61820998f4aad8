// SPDX-License-Identifier: GPL-3.0-or-later
#include "backlash.hpp"

#include <limits>
#include <numeric>

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

constexpr std::size_t least = 3;  // readings on one side

struct Fit
{
    double height = 0, squares = std::numeric_limits<double>::infinity(), factor = 0;
};

/// Two parallel lines through both sides; @c factor times the variance of a sample is that of the height.
Fit lines_beside(Side const& low, Side const& high)
{
    double const xx = low.about_mean_xx() + high.about_mean_xx();
    double const slope = (low.about_mean_xy() + high.about_mean_xy()) / xx;
    double const apart = high.x / high.n - low.x / low.n;
    return {high.y / high.n - low.y / low.n - slope * apart,
            low.about_mean_yy() + high.about_mean_yy() - slope * slope * xx,
            1 / low.n + 1 / high.n + apart * apart / xx};
}

/// Readings of a branch by ascending torque, without those that have no load.
std::vector<std::size_t> loaded_readings(Samples const& samples, LoadBranch const& branch, double no_load)
{
    std::vector<std::size_t> at;
    for (std::size_t i = branch.first; i <= branch.last; ++i)
        if (std::abs(samples.torque[i]) >= no_load)
            at.push_back(i);
    std::ranges::stable_sort(at, {}, [&](std::size_t i) { return samples.torque[i]; });
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
    for (std::size_t split = least; split + least <= at.size(); ++split) {
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
        if (std::min(low.n, high.n) < least)
            continue;
        double const height = lines_beside(low, high).height;
        if (!place || height > highest) {
            place = middle;
            highest = height;
        }
    }
    return place;
}

/// Readings that a jump is fitted to: by their distance from a torque, in units of a scale [N mm].
struct Neighbourhood
{
    double centre, window, scale;
};

/// The jump between the readings @p at of a neighbourhood at the torque @p split; without one, between those two
/// readings that leave the least squares.
/// @param at  readings by ascending torque
/// @returns nothing where a side has too few readings; Jump::seen is left to the caller
std::optional<Jump> jump_about(Samples const& samples, std::vector<std::size_t> at, Neighbourhood const& near,
                               std::optional<double> split)
{
    std::erase_if(at, [&](std::size_t i) { return std::abs(samples.torque[i] - near.centre) > near.window; });
    if (at.size() < 2 * least)
        return std::nullopt;
    double const count = static_cast<double>(at.size());
    double mean = 0;
    for (std::size_t const i : at)
        mean += samples.twist[i] / count;
    auto const add = [&](Side& side, std::size_t i, double sign) {
        side.add((samples.torque[i] - near.centre) / near.scale, samples.twist[i] - mean, sign);
    };
    Side low, high;
    for (std::size_t const i : at)
        add(high, i, 1);
    Fit best;
    std::size_t first_above = 0;
    for (std::size_t k = 1; k + least <= at.size(); ++k) {
        add(low, at[k - 1], 1);
        add(high, at[k - 1], -1);
        if (k < least || (split && (samples.torque[at[k - 1]] > *split || samples.torque[at[k]] <= *split)))
            continue;
        Fit const fit = lines_beside(low, high);
        if (fit.squares < best.squares) {
            best = fit;
            first_above = k;
        }
    }
    if (!std::isfinite(best.squares))
        return std::nullopt;
    double const error = std::sqrt(std::max(0.0, best.squares) / (count - 3) * best.factor);
    return Jump{
        {best.height, error}, false, std::max(-samples.torque[at[first_above - 1]], samples.torque[at[first_above]])};
}

}  // namespace

double friction_torque(Samples const& samples, std::vector<LoadBranch> const& branches)
{
    std::vector<double> halves;
    for (std::size_t b = 0; b + 1 < branches.size(); ++b) {
        std::vector<std::size_t> next(branches[b + 1].last - branches[b + 1].first + 1);
        std::iota(next.begin(), next.end(), branches[b + 1].first);
        auto const twist = [&](std::size_t i) { return samples.twist[i]; };
        std::ranges::stable_sort(next, {}, twist);
        for (std::size_t i = branches[b].first; i <= branches[b].last; ++i) {
            auto const above = std::ranges::upper_bound(next, samples.twist[i], {}, twist);
            if (above == next.begin() || above == next.end())
                continue;
            std::size_t const low = above[-1], high = *above;
            double const share = (samples.twist[i] - samples.twist[low]) / (samples.twist[high] - samples.twist[low]);
            double const half = (samples.torque[i] - std::lerp(samples.torque[low], samples.torque[high], share)) / 2;
            halves.push_back(branches[b].rising ? half : -half);
        }
    }
    if (halves.empty())
        return 0;
    auto const middle = halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2);
    std::ranges::nth_element(halves, middle);
    return std::max(0.0, *middle);
}

std::optional<Jump> jump_of_play(Samples const& samples, LoadBranch const& branch, double largest_torque,
                                 double friction)
{
    constexpr double clear = 5;      // standard errors: beyond what the best of some hundred places reaches by chance
    constexpr double spread = 1.25;  // of the friction about its median
    double const window = measured_at::near_zero * largest_torque, beside = window / 2, still = window / 4;
    std::vector<std::size_t> const at = loaded_readings(samples, branch, measured_at::no_load * largest_torque);
    auto const place = branch.rising ? place_of_jump(samples, at, -beside, spread * friction + beside, window)
                                     : place_of_jump(samples, at, -spread * friction - beside, beside, window);
    if (!place)
        return std::nullopt;
    auto const about = [&](double centre, std::optional<double> split) {
        return jump_about(samples, at, {std::abs(centre) > still ? centre : 0, window, largest_torque}, split);
    };
    std::optional<Jump> best = about(*place, std::nullopt);
    if (!best)
        return std::nullopt;
    best->seen = best->height.value > clear * best->height.error;
    if (best->seen)
        return best;
    double const crossing = branch.rising ? friction : -friction;
    if (std::optional<Jump> const known = about(crossing, crossing))
        return known;
    best->height.error = std::max(best->height.error, std::abs(best->height.value));
    return best;
}

}  // namespace hdconj::rig
