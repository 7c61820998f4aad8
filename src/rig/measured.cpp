// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/measured.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "backlash.hpp"
#include "cleaning.hpp"
#include "found.hpp"
#include "hdconj/load.hpp"
#include "numeric/moments.hpp"

namespace hdconj {
namespace {

using rig::Found;
using rig::LoadBranch;
using rig::mean_of;
using rig::Samples;

struct Sample
{
    double twist = 0, torque = 0;
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
std::vector<Sample> loaded_part(Samples const& curve, LoadBranch const& branch, double sign)
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
void check_sense(MeasuredCurve const& curve, Samples const& samples)
{
    numeric::Moments const m = numeric::moments(samples.torque, samples.twist);
    constexpr double related = 0.3;  // correlation; of a loop with as much play as twist it is above 0.8
    auto const [least, most] = std::ranges::minmax(samples.twist);
    if (least == most || std::abs(m.xy) < related * std::sqrt(m.xx * m.yy))
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
    std::vector<Found> first, second, knee, whole;     ///< of loading branches
    std::vector<Found> positive, negative;             ///< angles at zero torque of unloading branches, by side
    std::vector<double> positive_time, negative_time;  ///< when the load was off
    std::vector<Found> jumps;                          ///< from one side of the backlash to the other
    int straight = 0;                                  ///< loading branches without a bend
};

/// Adds the stages of a loading branch. The torque was set and the angle read, so that lines of the angle over the
/// torque are fitted; noise of the angle on the other axis would make every stiffness too small.
/// @param engaged  torque from which the flanks touch [N mm]
/// @param drift_error  standard error of the drift over the branch, as an angle per torque [rad/(N mm)]
void add_loading(std::vector<Sample> const& samples, double engaged, double drift_error, Collected& all)
{
    std::vector<double> twist, torque;
    for (auto const& each : samples) {
        if (each.torque >= engaged) {
            twist.push_back(each.twist - samples.front().twist);  // grows from zero whatever the angles count from
            torque.push_back(each.torque);
        }
    }
    auto const line = line_through(torque, twist);
    if (!line)
        return;
    auto const stiffness = [&](double compliance, double error) {
        return Found{1 / compliance, std::hypot(error, drift_error) / (compliance * compliance)};
    };
    all.whole.push_back(stiffness(line->slope, line->slope_error));
    StiffnessStages const stages = stiffness_stages(torque, twist);
    if (stages.found) {
        all.first.push_back(stiffness(stages.first, stages.first_error));
        all.second.push_back(stiffness(stages.second, stages.second_error));
        all.knee.push_back({stages.knee_twist, stages.knee_twist_error});
    } else {
        ++all.straight;
    }
}

/// What all branches share.
struct BranchLimits
{
    double loaded = 0;       ///< torque that a branch of a load cycle reaches [N mm]
    double engaged = 0;      ///< torque from which the flanks touch in every loading branch [N mm]
    double drift_error = 0;  ///< standard error of the drift [rad per reading]
};

/// Adds both sides of one branch: a branch from one load to the opposite one unloads first, then loads.
void add_branch(Samples const& curve, LoadBranch const& branch, MeasuredStiffness const& known, BranchLimits limits,
                Collected& all)
{
    for (double const sign : {1.0, -1.0}) {
        double const at_first = sign * curve.torque[branch.first], at_last = sign * curve.torque[branch.last];
        if (std::max(at_first, at_last) < limits.loaded)
            continue;
        auto const samples = loaded_part(curve, branch, sign);
        if (at_last > at_first) {
            add_loading(samples, limits.engaged, limits.drift_error * static_cast<double>(samples.size()) / at_last,
                        all);
        } else if (at_last <= measured_at::near_zero * known.largest_torque) {
            if (auto const rest = rest_of(samples, known.largest_torque, known.angle_step)) {
                bool const above = sign > 0;
                (above ? all.positive : all.negative).push_back(*rest);
                (above ? all.positive_time : all.negative_time)
                    .push_back(curve.time[branch.first + samples.size() - 1]);
            }
        }
    }
}

/// The log without stray readings, with the time of each.
Samples kept_samples(MeasuredCurve const& curve, std::vector<std::size_t> const& strays)
{
    Samples kept;
    double const middle = static_cast<double>(curve.twist.size() - 1) / 2;
    for (std::size_t i = 0; i < curve.twist.size(); ++i) {
        if (std::ranges::binary_search(strays, i))
            continue;
        kept.time.push_back(static_cast<double>(i) - middle);
        kept.twist.push_back(curve.twist[i]);
        kept.torque.push_back(curve.torque[i]);
    }
    return kept;
}

/// Backlash, width of the loop and friction of all branches.
/// @param drift_error  standard error of the drift [rad per reading]
/// @param rounding     standard deviation of an angle by the encoder's steps, which all branches may share [rad]
void add_loop(Collected const& all, double drift_error, double rounding, MeasuredStiffness& result)
{
    std::size_t const cycles = std::min(all.positive.size(), all.negative.size());
    result.cycles = static_cast<int>(cycles);
    std::vector<Found> widths;
    double apart = 0;  // readings from one side to the other
    for (std::size_t i = 0; i < cycles; ++i) {
        auto const &positive = all.positive[i], &negative = all.negative[i];
        // The negative side was multiplied by -1.
        widths.push_back({positive.value + negative.value, std::hypot(positive.error, negative.error)});
        result.middle += (positive.value - negative.value) / 2 / static_cast<double>(cycles);
        apart += (all.negative_time[i] - all.positive_time[i]) / static_cast<double>(cycles);
    }
    result.loop_width = mean_of(widths);
    double const of_both = std::numbers::sqrt2 * rounding;  // a width and a jump have two ends
    result.loop_width.error = std::hypot(result.loop_width.error, drift_error * apart, of_both);
    result.backlash = all.jumps.empty() ? result.loop_width : mean_of(all.jumps);
    if (all.jumps.empty())
        return;
    result.backlash.error = std::hypot(result.backlash.error, of_both);
    // Width and jumps share half of their lines, so that the variance of the width counts half.
    double const error = std::hypot(result.loop_width.error / std::numbers::sqrt2, result.backlash.error);
    result.friction_width = {result.loop_width.value - result.backlash.value, error, result.cycles};
}

}  // namespace

MeasuredStiffness measured_stiffness(MeasuredCurve const& curve)
{
    check_sizes(curve);
    MeasuredStiffness result;
    result.strays = rig::stray_readings(curve);
    Samples samples = kept_samples(curve, result.strays);
    auto const [low, high] = std::ranges::minmax(samples.torque);
    result.largest_torque = std::max(-low, high);
    if (!(std::min(-low, high) > measured_at::loaded / 2 * result.largest_torque))
        refuse(curve, "the torque has one sign only, or nearly so", "write a whole load cycle: 0, T, 0, -T, 0");
    check_sense(curve, samples);
    result.angle_step = rig::smallest_step(samples.twist);
    double const rounding = rig::rounding_of(samples.twist, result.angle_step);
    auto const branches = rig::branches_of(samples.torque, measured_at::reversal * result.largest_torque);
    Found drift;
    if (auto const found = rig::drift_of(samples, branches, result.largest_torque)) {
        drift = *found;
        double const readings = static_cast<double>(curve.twist.size());
        result.drift = {drift.value * readings, drift.error * readings, 1};
        for (std::size_t i = 0; i < samples.twist.size(); ++i)
            samples.twist[i] -= drift.value * samples.time[i];
    }
    BranchLimits limits{measured_at::loaded * std::min(-low, high), measured_at::no_load * result.largest_torque,
                        drift.error};
    Collected all;
    double const friction = rig::friction_torque(samples, branches);
    for (auto const& branch : branches) {
        if (auto const jump = rig::jump_of_play(samples, branch, result.largest_torque, friction)) {
            all.jumps.push_back(jump->height);
            limits.engaged = std::max(limits.engaged, jump->engaged);
        }
    }
    for (auto const& branch : branches)
        add_branch(samples, branch, result, limits, all);
    if (all.positive.empty() || all.negative.empty())
        refuse(curve,
               std::string("the load is never taken off from the ") + (all.positive.empty() ? "positive" : "negative") +
                   " side",
               "write a whole load cycle: 0, T, 0, -T, 0; without unloading there is no width of the loop");
    add_loop(all, drift.error, rounding, result);
    result.first = mean_of(all.first);
    result.second = mean_of(all.second);
    result.knee = mean_of(all.knee);
    result.whole = mean_of(all.whole);
    result.straight = all.straight;
    // Nobody knows at which torque the flanks meet: all of these may contain the play and the friction.
    if (all.jumps.empty() && friction > measured_at::no_load * result.largest_torque) {
        result.backlash = result.first = result.second = result.knee = result.whole = {};
        result.straight = 0;
    }
    return result;
}

}  // namespace hdconj
