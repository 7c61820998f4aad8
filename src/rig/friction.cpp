// SPDX-License-Identifier: GPL-3.0-or-later
#include "friction.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "cleaning.hpp"
#include "found.hpp"
#include "numeric/quantile.hpp"

namespace hdconj::rig {
namespace {

/// Readings of about one angle.
struct SameAngle
{
    double twist = 0, torque = 0;  ///< means [rad, N mm]
};

/// The readings of a branch by ascending angle, those within half a @p step of the encoder in one: an angle that the
/// encoder holds while the torque moves on belongs to the middle of these torques.
std::vector<SameAngle> by_angle(Samples const& samples, LoadBranch const& branch, double step)
{
    std::vector<std::size_t> order(branch.last - branch.first + 1);
    std::iota(order.begin(), order.end(), branch.first);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return samples.twist[i]; });
    std::vector<SameAngle> angles;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        SameAngle sum;
        for (; end < order.size() && samples.twist[order[end]] <= samples.twist[order[begin]] + step / 2; ++end) {
            sum.twist += samples.twist[order[end]];
            sum.torque += samples.torque[order[end]];
        }
        double const count = static_cast<double>(end - begin);
        angles.push_back({sum.twist / count, sum.torque / count});
    }
    return angles;
}

/// Half the differences between a branch and the next one at the angles of its readings.
std::vector<double> half_differences(std::vector<SameAngle> const& branch, std::vector<SameAngle> const& following,
                                     bool rising)
{
    std::vector<double> halves;
    for (SameAngle const& here : branch) {
        auto const above = std::ranges::upper_bound(following, here.twist, {}, &SameAngle::twist);
        if (above == following.begin() || above == following.end())
            continue;
        SameAngle const &low = above[-1], &high = *above;
        double const share = (here.twist - low.twist) / (high.twist - low.twist);
        double const off = (here.torque - std::lerp(low.torque, high.torque, share)) / 2;
        halves.push_back(rising ? off : -off);
    }
    return halves;
}

}  // namespace

Found friction_torque(Samples const& samples, std::vector<LoadBranch> const& branches, double step)
{
    std::vector<double> halves;
    std::vector<Found> pairs;
    std::vector<std::vector<SameAngle>> angles;
    for (LoadBranch const& branch : branches)
        angles.push_back(by_angle(samples, branch, step));
    for (std::size_t b = 0; b + 1 < branches.size(); ++b) {
        std::vector<double> const own = half_differences(angles[b], angles[b + 1], branches[b].rising);
        if (own.empty())
            continue;
        pairs.push_back({numeric::quantile(own, 0.5)});
        halves.insert(halves.end(), own.begin(), own.end());
    }
    if (halves.empty())
        return {};
    // A step rounds each angle, which changes the torque by the slope of the curve. All branches may share these
    // errors, so only the angles of one branch average them; neighbouring angles may share them too.
    constexpr double of_neighbours = 2;
    auto const range = [](std::vector<double> const& values) {
        auto const [low, high] = std::ranges::minmax(values);
        return high - low;
    };
    std::size_t const most = std::ranges::max(angles, {}, &std::vector<SameAngle>::size).size();
    double const by_rounding = of_neighbours * step / std::sqrt(12.0) * range(samples.torque) / range(samples.twist) /
                               std::sqrt(static_cast<double>(most));
    double const median = numeric::quantile(halves, 0.5), n = static_cast<double>(halves.size());
    for (double& each : halves)
        each -= median;
    constexpr double of_median = 1.2533;  // its standard error over that of the mean, of normal noise
    return {std::max(0.0, median),
            std::hypot(mean_of(pairs).error, of_median * deviation_of(halves) / std::sqrt(n), by_rounding)};
}

}  // namespace hdconj::rig
