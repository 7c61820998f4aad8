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

}  // namespace

std::optional<Jump> jump_at_zero(Samples const& samples, LoadBranch const& branch, double largest_torque)
{
    constexpr std::size_t least = 3;
    constexpr double clear = 5;  // standard errors: beyond what the best of some hundred places reaches by chance
    std::vector<std::size_t> at;
    std::size_t positive = 0;
    for (std::size_t i = branch.first; i <= branch.last; ++i) {
        double const share = std::abs(samples.torque[i]) / largest_torque;
        if (share >= measured_at::no_load && share <= measured_at::near_zero) {
            at.push_back(i);
            positive += samples.torque[i] > 0 ? 1 : 0;
        }
    }
    auto const [from, to] = std::minmax(samples.torque[branch.first], samples.torque[branch.last]);
    double const window = measured_at::near_zero * largest_torque;
    if (from > -window || to < window || positive < least || at.size() - positive < least)
        return std::nullopt;
    std::ranges::stable_sort(at, {}, [&](std::size_t i) { return samples.torque[i]; });
    double mean = 0;
    for (std::size_t const i : at)
        mean += samples.twist[i] / static_cast<double>(at.size());
    auto const add = [&](Side& side, std::size_t i, double sign) {
        side.add(samples.torque[i] / largest_torque, samples.twist[i] - mean, sign);
    };
    Side low, high;
    for (std::size_t const i : at)
        add(high, i, 1);
    Fit best;
    std::size_t best_split = 0;
    for (std::size_t split = 1; split + least <= at.size(); ++split) {
        add(low, at[split - 1], 1);
        add(high, at[split - 1], -1);
        if (split < least)
            continue;
        Fit const fit = lines_beside(low, high);
        if (fit.squares < best.squares) {
            best = fit;
            best_split = split;
        }
    }
    if (!std::isfinite(best.squares))
        return std::nullopt;
    // A height that chance would make of noise, at the best of so many places, says no more than its own size.
    double const count = static_cast<double>(at.size());
    double const error = std::sqrt(std::max(0.0, best.squares) / (count - 3) * best.factor);
    bool const seen = std::abs(best.height) > clear * error;
    double const beyond = std::max(-samples.torque[at[best_split - 1]], samples.torque[at[best_split]]);
    return Jump{{best.height, seen ? error : std::max(error, std::abs(best.height))}, seen, beyond};
}

}  // namespace hdconj::rig
