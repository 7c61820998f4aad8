// SPDX-License-Identifier: GPL-3.0-or-later
#include "cleaning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "numeric/quantile.hpp"

namespace hdconj::rig {
namespace {

/// Standard deviation of independent noise: of what the values differ by from the middle of both neighbours.
double deviation_from_runs(std::vector<double> const& values)
{
    double const of_difference = std::sqrt(1.5);
    std::vector<double> differences;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
        differences.push_back((values[i] - std::midpoint(values[i - 1], values[i + 1])) / of_difference);
    return deviation_of(std::move(differences));
}

/// Readings at equal intervals, the first at @p first, and the line that most of them follow: its slope is the median
/// of those of all pairs (Theil, Sen), its height the median of what then remains.
struct LocalLine
{
    std::vector<double> values;
    double first, slope, at_zero;

    LocalLine(std::span<double const> readings, double at) : values(readings.begin(), readings.end()), first(at)
    {
        std::vector<double> slopes;
        for (std::size_t i = 0; i < values.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                slopes.push_back((values[i] - values[j]) / static_cast<double>(i - j));
        slope = numeric::quantile(std::move(slopes), 0.5);
        std::vector<double> heights;
        for (std::size_t i = 0; i < values.size(); ++i)
            heights.push_back(values[i] - slope * (first + static_cast<double>(i)));
        at_zero = numeric::quantile(std::move(heights), 0.5);
    }

    /// How far most readings are from it.
    [[nodiscard]] double median_distance() const
    {
        std::vector<double> distances;
        for (std::size_t i = 0; i < values.size(); ++i)
            distances.push_back(std::abs(values[i] - slope * (first + static_cast<double>(i)) - at_zero));
        return numeric::quantile(std::move(distances), 0.5);
    }
};

/// Marks the values that leave the line of their neighbours: of those on either side and of those before and after, so
/// that a corner is none.
void mark_strays(std::vector<double> const& values, std::vector<bool>& stray)
{
    constexpr std::size_t half = 3, window = 2 * half + 1;
    constexpr double deviation_per_median = 1.4826;  // of normal noise
    constexpr double of_all = 5, of_neighbours = 3, steps = 2;
    if (values.size() < window)
        return;
    double const usual = of_all * deviation_from_runs(values) + steps * smallest_step(values);
    std::span<double const> const all(values);
    for (std::size_t i = half; i + half < values.size(); ++i) {
        LocalLine const both(all.subspan(i - half, window), -static_cast<double>(half));
        LocalLine const before(all.subspan(i - half, half), -static_cast<double>(half)),
            after(all.subspan(i + 1, half), 1);
        double own = std::numeric_limits<double>::infinity();
        for (LocalLine const* line : {&both, &before, &after})
            own = std::min(own, std::abs(values[i] - line->at_zero));
        if (own > usual + of_neighbours * deviation_per_median * both.median_distance())
            stray[i] = true;
    }
}

/// A branch by ascending torque.
struct Sorted
{
    std::vector<std::size_t> at;  ///< positions in the samples
    Samples const& samples;

    Sorted(Samples const& of, LoadBranch const& branch) : at(by_torque(of, branch)), samples(of) {}
    /// Angle and time at a torque, between two samples; nothing outside.
    [[nodiscard]] std::optional<std::pair<double, double>> at_torque(double torque) const
    {
        auto const after = std::ranges::upper_bound(at, torque, {}, [&](std::size_t i) { return samples.torque[i]; });
        if (after == at.begin() || after == at.end())
            return std::nullopt;
        std::size_t const a = *std::prev(after), b = *after;
        double const share = (torque - samples.torque[a]) / (samples.torque[b] - samples.torque[a]);
        return std::pair(std::lerp(samples.twist[a], samples.twist[b], share),
                         std::lerp(samples.time[a], samples.time[b], share));
    }
};

/// Drift between two branches of the same sense.
std::optional<Found> drift_between(Samples const& samples, LoadBranch const& earlier, LoadBranch const& later,
                                   double largest)
{
    Sorted const before(samples, earlier);
    std::vector<Found> rates;
    for (std::size_t i = later.first; i <= later.last; ++i) {
        double const share = std::abs(samples.torque[i]) / largest;
        auto const then = before.at_torque(samples.torque[i]);
        if (then && share >= measured_at::near_zero && share <= measured_at::loaded)
            rates.push_back({(samples.twist[i] - then->first) / (samples.time[i] - then->second)});
    }
    constexpr std::size_t enough = 3;
    if (rates.size() < enough)
        return std::nullopt;
    Estimate const mean = mean_of(rates);
    return Found{mean.value, mean.error};
}

}  // namespace

double deviation_of(std::vector<double> values)
{
    for (double& each : values)
        each = std::abs(each);
    constexpr double quartile = 1.1503;  // of |x| for standard normal x
    return numeric::quantile(std::move(values), 0.75) / quartile;
}

double smallest_step(std::vector<double> values)
{
    std::ranges::sort(values);
    double const range = values.back() - values.front();
    constexpr double rounding = 1e-9;  // of the range: two spellings of one reading
    double step = range;
    for (std::size_t i = 1; i < values.size(); ++i) {
        double const here = values[i] - values[i - 1];
        step = here > rounding * range ? std::min(step, here) : step;
    }
    return step;
}

double rounding_of(std::vector<double> const& values, double step)
{
    constexpr double beside = 0.1;  // of a step: the step itself is known so well
    bool const lattice = step > 0 && std::ranges::all_of(values, [&](double each) {
                             double const steps = (each - values.front()) / step;
                             return std::abs(steps - std::round(steps)) < beside;
                         });
    return lattice ? step / std::sqrt(12.0) : 0;
}

std::vector<std::size_t> stray_readings(MeasuredCurve const& curve)
{
    std::vector<bool> stray(curve.twist.size());
    mark_strays(curve.twist, stray);
    mark_strays(curve.torque, stray);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < stray.size(); ++i)
        if (stray[i])
            found.push_back(i);
    return found;
}

std::optional<Found> drift_of(Samples const& samples, std::vector<LoadBranch> const& branches, double largest_torque)
{
    bool const from_rest =
        !branches.empty() && std::abs(samples.torque[branches.front().first]) < measured_at::loaded * largest_torque;
    std::vector<Found> rates;
    for (std::size_t i = from_rest ? 1 : 0; i + 2 < branches.size(); ++i)
        if (auto const rate = drift_between(samples, branches[i], branches[i + 2], largest_torque))
            rates.push_back(*rate);
    if (rates.empty())
        return std::nullopt;
    Estimate const mean = mean_of(rates);
    return Found{mean.value, mean.error};
}

}  // namespace hdconj::rig
