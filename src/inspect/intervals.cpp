// SPDX-License-Identifier: GPL-3.0-or-later
#include "intervals.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hdconj::inspect {
namespace {

constexpr double outside = 0.05;  // of 95 %
/// Second differences of white noise overlap: n of them are worth n / (1 + 2 (16 + 1)/36) degrees of freedom (von
/// Neumann 1941 for first differences).
constexpr double differences_per_freedom = 35.0 / 18;

auto ends_of(std::vector<Candidate> const& candidates)
{
    return std::minmax_element(candidates.begin(), candidates.end(),
                               [](auto const& a, auto const& b) { return a.value < b.value; });
}

/// How many pairs of candidates may differ by @p range and more, found for a pair of @p variance. Pairs are counted by
/// their ends, each against the other extreme.
std::size_t rival_pairs(std::vector<Candidate> const& candidates, double range, double variance,
                        Intervals const& intervals)
{
    auto const [low, high] = ends_of(candidates);
    double const single = intervals.half_width(variance);
    std::size_t below = 0, above = 0;
    for (Candidate const& each : candidates) {
        double const reach = single + intervals.half_width(each.variance + std::max(low->variance, high->variance));
        below += high->value - each.value > range - reach ? 1U : 0U;
        above += each.value - low->value > range - reach ? 1U : 0U;
    }
    return below * above;
}

}  // namespace

Intervals::Intervals(double squares, double differences, double systematic) : systematic_(systematic)
{
    freedom_ = std::max(0.0, differences) / differences_per_freedom;
    noise_ = differences > 0 ? std::sqrt(squares / differences) : 0;
}

double Intervals::half_width(double variance, std::size_t rivals) const
{
    if (!(freedom_ > 0))
        return std::numeric_limits<double>::quiet_NaN();
    double const tail = outside / 2 / static_cast<double>(rivals);
    // of two noises that cancel each other rounding may leave less than nothing
    return systematic_ + noise_ * std::sqrt(std::max(0.0, variance)) * gsl_cdf_tdist_Qinv(tail, freedom_);
}

Uncertain Intervals::amplitude(double value, double variance) const
{
    // of two components over noise: twice Fisher's F(2, freedom), whose quantile has this closed form
    double const squares = freedom_ * (std::pow(outside, -2 / freedom_) - 1);
    double const of_zero = systematic_ + noise_ * std::sqrt(std::max(0.0, variance) * squares);
    return value > 2 * of_zero ? figure(value, variance) : Uncertain{value, of_zero};
}

LargestFigure largest_of(std::vector<Candidate> const& candidates, Intervals const& intervals)
{
    auto const largest = std::max_element(candidates.begin(), candidates.end(),
                                          [](Candidate const& a, Candidate const& b) { return a.value < b.value; });
    double const least = largest->value - intervals.half_width(largest->variance);
    auto const rivals = std::count_if(candidates.begin(), candidates.end(), [&](Candidate const& each) {
        return each.value + intervals.half_width(each.variance) > least;
    });
    auto const count = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, rivals));
    return {{largest->value, intervals.half_width(largest->variance, count)}, largest->tooth};
}

FigureRange range_of(std::vector<Candidate> const& candidates, Intervals const& intervals)
{
    auto const [low, high] = ends_of(candidates);
    double const variance = low == high ? 0 : low->variance + high->variance;
    double const range = high->value - low->value;
    std::size_t const pairs = std::max<std::size_t>(1, rival_pairs(candidates, range, variance, intervals));
    return {{range, intervals.half_width(variance, pairs)}, low->tooth, high->tooth};
}

LargestFigure largest_range_of(std::vector<std::vector<Candidate>> const& groups, Intervals const& intervals)
{
    double range = -1, variance = 0;
    int tooth = 0;
    for (auto const& group : groups) {
        auto const [low, high] = ends_of(group);
        if (high->value - low->value <= range)
            continue;
        range = high->value - low->value;
        variance = low == high ? 0 : low->variance + high->variance;
        tooth = high->tooth;
    }
    std::size_t pairs = 0;
    for (auto const& group : groups)
        pairs += rival_pairs(group, range, variance, intervals);
    return {{range, intervals.half_width(variance, std::max<std::size_t>(1, pairs))}, tooth};
}

}  // namespace hdconj::inspect
