// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/measured.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hdconj/load.hpp"
#include "numeric/moments.hpp"

namespace hdconj {
namespace {

struct Sample
{
    double twist = 0, torque = 0;
};

/// Samples from one turning point of the torque to the next, both included.
struct Branch
{
    std::size_t first = 0, last = 0;
    bool rising = false;
};

/// Turning points: extremes from which the torque comes back by more than @p reversal.
std::vector<Branch> branches_of(std::vector<double> const& torque, double reversal)
{
    std::vector<Branch> branches;
    std::size_t begin = 0, low = 0, high = 0;
    int sense = 0;
    for (std::size_t i = 0; i < torque.size(); ++i) {
        high = torque[i] > torque[high] ? i : high;
        low = torque[i] < torque[low] ? i : low;
        if (sense >= 0 && torque[high] - torque[i] > reversal) {
            if (high > begin)
                branches.push_back({begin, high, true});
            begin = high;
            low = i;
            sense = -1;
        } else if (sense <= 0 && torque[i] - torque[low] > reversal) {
            if (low > begin)
                branches.push_back({begin, low, false});
            begin = low;
            high = i;
            sense = 1;
        }
    }
    if (begin + 1 < torque.size())
        branches.push_back({begin, torque.size() - 1, torque.back() > torque[begin]});
    return branches;
}

/// A fitted value and its standard error from the residuals of the fit.
struct Found
{
    double value = 0, error = 0;
};

/// Straight line y(x) by least squares.
struct Line
{
    double slope = 0, slope_error = 0, at_zero = 0, at_zero_error = 0;
};

/// None where all x are one.
std::optional<Line> line_through(std::vector<double> const& x, std::vector<double> const& y)
{
    numeric::Moments const m = numeric::moments(x, y);
    if (!(m.xx > 0))
        return std::nullopt;
    double const n = static_cast<double>(x.size()), slope = m.xy / m.xx;
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        squares += std::pow(y[i] - m.mean_y - slope * (x[i] - m.mean_x), 2);
    double const variance = x.size() > 2 ? squares / (n - 2) : 0;
    return Line{slope, std::sqrt(variance / m.xx), m.mean_y - slope * m.mean_x,
                std::sqrt(variance * (1 / n + m.mean_x * m.mean_x / m.xx))};
}

/// The samples of a branch whose torque has the sign @p sign, in order of time, multiplied by it.
std::vector<Sample> loaded_part(MeasuredCurve const& curve, Branch const& branch, double sign)
{
    std::vector<Sample> samples;
    for (std::size_t i = branch.first; i <= branch.last; ++i)
        if (sign * curve.torque[i] >= 0)
            samples.push_back({sign * curve.twist[i], sign * curve.torque[i]});
    return samples;
}

/// Angle at zero torque by a line through the end of an unloading branch. The torque was set and the angle read, so the
/// angle is fitted over the torque.
std::optional<Found> rest_of(std::vector<Sample> samples, double largest, double angle_step)
{
    std::vector<double> torque, twist;
    for (auto const& each : samples) {
        if (each.torque >= measured_at::no_load * largest && each.torque <= measured_at::near_zero * largest) {
            torque.push_back(each.torque);
            twist.push_back(each.twist);
        }
    }
    constexpr std::size_t enough = 3;
    bool const coarse = torque.size() < enough;
    if (coarse) {
        if (samples.size() < 2)
            return std::nullopt;
        std::ranges::stable_sort(samples, {}, &Sample::torque);
        torque = {samples[0].torque, samples[1].torque};
        twist = {samples[0].twist, samples[1].twist};
    }
    auto const line = line_through(torque, twist);
    if (!line)
        return std::nullopt;
    // Rounding to a step has the standard deviation step/sqrt(12), which two samples cannot show as a residual.
    return Found{line->at_zero, coarse ? angle_step / std::sqrt(12.0) : line->at_zero_error};
}

Estimate estimate(std::vector<Found> const& found)
{
    Estimate result;
    result.count = static_cast<int>(found.size());
    double const n = result.count;
    double own = 0, squares = 0;
    for (auto const& each : found) {
        result.value += each.value / n;
        own += each.error * each.error / n;
    }
    for (auto const& each : found)
        squares += std::pow(each.value - result.value, 2);
    double const scatter = found.size() > 1 ? squares / (n - 1) : 0;
    result.error = found.empty() ? 0 : std::sqrt(std::max(own, scatter) / n);
    return result;
}

double smallest_step(std::vector<double> twist)
{
    std::sort(twist.begin(), twist.end());
    double const range = twist.back() - twist.front();
    constexpr double rounding = 1e-9;  // of the range: two spellings of one reading
    double step = range;
    for (std::size_t i = 1; i < twist.size(); ++i) {
        double const here = twist[i] - twist[i - 1];
        step = here > rounding * range ? std::min(step, here) : step;
    }
    return step;
}

[[noreturn]] void refuse(MeasuredCurve const& curve, std::string const& reason, std::string const& remedy)
{
    throw InputError(Fault{"--measured", 0, curve.file, reason, remedy});
}

void check_sizes(MeasuredCurve const& curve)
{
    if (curve.twist.size() != curve.torque.size())
        throw std::logic_error("a measured curve with more torques than angles, or fewer");
    constexpr std::size_t least = 8;  // two points on each of the four parts of a cycle
    if (curve.twist.size() < least)
        refuse(curve, "holds " + std::to_string(curve.twist.size()) + " samples, too few for a load cycle",
               "write at least the torques 0, T/2, T, T/2, 0, -T/2, -T, -T/2, 0 with their angles");
}

/// Torque and angle must grow together where the drive is loaded.
void check_sense(MeasuredCurve const& curve)
{
    numeric::Moments const m = numeric::moments(curve.torque, curve.twist);
    constexpr double related = 0.3;  // correlation; of a loop with as much play as twist it is above 0.8
    auto const [least, most] = std::minmax_element(curve.twist.begin(), curve.twist.end());
    if (*least == *most || std::abs(m.xy) < related * std::sqrt(m.xx * m.yy))
        refuse(curve, "angle and torque do not depend on each other",
               "write the columns of a load cycle: torque up, down to 0, to the other side, and back");
    if (m.xy < 0)
        refuse(curve, "the torque falls while the angle grows: one of them counts the other way round",
               curve.rig.counts_per_turn != 0 ? "turn the sign of --counts-per-turn round"
                                              : "turn the sign of one column round");
}

/// Results of all branches.
struct Collected
{
    std::vector<Found> first, second, knee, whole;  ///< of loading branches
    std::vector<Found> positive, negative;          ///< angles at zero torque of unloading branches, by side
    int straight = 0;                               ///< loading branches without a bend
};

/// Adds the stages of a loading branch.
void add_loading(std::vector<Sample> const& samples, double largest, Collected& all)
{
    std::vector<double> twist, torque;
    for (auto const& each : samples) {
        if (each.torque >= measured_at::no_load * largest) {
            twist.push_back(each.twist);
            torque.push_back(each.torque);
        }
    }
    auto const line = line_through(twist, torque);
    if (!line)
        return;
    all.whole.push_back({line->slope, line->slope_error});
    StiffnessStages const stages = stiffness_stages(twist, torque);
    if (stages.found) {
        all.first.push_back({stages.first, stages.first_error});
        all.second.push_back({stages.second, stages.second_error});
        all.knee.push_back({stages.knee, stages.knee_error});
    } else {
        ++all.straight;
    }
}

/// Adds both sides of one branch: a branch from one load to the opposite one unloads first, then loads.
void add_branch(MeasuredCurve const& curve, Branch const& branch, MeasuredStiffness const& known, double loaded,
                Collected& all)
{
    for (double const sign : {1.0, -1.0}) {
        double const at_first = sign * curve.torque[branch.first], at_last = sign * curve.torque[branch.last];
        if (std::max(at_first, at_last) < loaded)
            continue;
        auto const samples = loaded_part(curve, branch, sign);
        if (at_last > at_first) {
            add_loading(samples, known.largest_torque, all);
        } else if (at_last <= measured_at::near_zero * known.largest_torque) {
            if (auto const rest = rest_of(samples, known.largest_torque, known.angle_step))
                (sign > 0 ? all.positive : all.negative).push_back(*rest);
        }
    }
}

}  // namespace

MeasuredStiffness measured_stiffness(MeasuredCurve const& curve)
{
    check_sizes(curve);
    MeasuredStiffness result;
    auto const [least, most] = std::minmax_element(curve.torque.begin(), curve.torque.end());
    result.largest_torque = std::max(-*least, *most);
    if (!(std::min(-*least, *most) > measured_at::loaded / 2 * result.largest_torque))
        refuse(curve, "the torque has one sign only, or nearly so", "write a whole load cycle: 0, T, 0, -T, 0");
    check_sense(curve);
    result.angle_step = smallest_step(curve.twist);
    Collected all;
    for (auto const& branch : branches_of(curve.torque, measured_at::reversal * result.largest_torque))
        add_branch(curve, branch, result, measured_at::loaded * std::min(-*least, *most), all);
    if (all.positive.empty() || all.negative.empty())
        refuse(curve,
               std::string("the load is never taken off from the ") + (all.positive.empty() ? "positive" : "negative") +
                   " side",
               "write a whole load cycle: 0, T, 0, -T, 0; without unloading there is no width of the loop");
    std::size_t const cycles = std::min(all.positive.size(), all.negative.size());
    result.cycles = static_cast<int>(cycles);
    std::vector<Found> widths;
    for (std::size_t i = 0; i < cycles; ++i) {
        auto const &positive = all.positive[i], &negative = all.negative[i];
        // The negative side was multiplied by -1.
        widths.push_back({positive.value + negative.value, std::hypot(positive.error, negative.error)});
        result.middle += (positive.value - negative.value) / 2 / static_cast<double>(cycles);
    }
    result.backlash = estimate(widths);
    result.first = estimate(all.first);
    result.second = estimate(all.second);
    result.knee = estimate(all.knee);
    result.whole = estimate(all.whole);
    result.straight = all.straight;
    return result;
}

}  // namespace hdconj
