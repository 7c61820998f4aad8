// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/measured.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "backlash.hpp"
#include "branch_figures.hpp"
#include "cleaning.hpp"
#include "fits.hpp"
#include "found.hpp"
#include "friction.hpp"
#include "hdconj/load.hpp"
#include "numeric/moments.hpp"

namespace hdconj {
namespace {

using rig::BranchFigures;
using rig::BranchLimits;
using rig::ByCurve;
using rig::Found;
using rig::LoadBranch;
using rig::mean_of;
using rig::Reach;
using rig::Samples;

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

/// What friction makes of the loop's width, by what is found under load.
///
/// Coulomb friction F moves the angle by F/k to either side, with k of the first stage. Friction that holds back an
/// angle, not a torque, may be that of the second stage: half of what both widths differ by is in the error.
Estimate width_by_friction(MeasuredStiffness const& found)
{
    bool const bent = found.first.count > 0 && found.second.count > 0;
    Estimate const& stiffness = bent ? found.first : found.whole;
    if (stiffness.count == 0)
        return {};
    double const width = 2 * found.friction.value / stiffness.value;
    double const of_second = bent ? 2 * found.friction.value / found.second.value : width;
    return {width,
            std::hypot(std::hypot(2 * found.friction.error, width * stiffness.error) / stiffness.value,
                       (width - of_second) / 2),
            found.loop_width.count};
}

/// Backlash, width of the loop and what friction makes of it. Where no branch shows the jump, that follows from the
/// friction: @p result has it, and the stiffness.
/// @param drift_error  standard error of the drift [rad per reading]
void add_loop(BranchFigures const& all, double drift_error, MeasuredStiffness& result)
{
    std::size_t const cycles = std::min(all.positive.size(), all.negative.size());
    result.cycles = static_cast<int>(cycles);
    std::vector<ByCurve> widths;
    double apart = 0;  // readings from one side to the other
    for (std::size_t i = 0; i < cycles; ++i) {
        ByCurve width;
        for (std::size_t j = 0; j < std::min(all.positive[i].size(), all.negative[i].size()); ++j) {
            Found const &positive = all.positive[i][j], &negative = all.negative[i][j];
            // The negative side was multiplied by -1.
            width.push_back({positive.value + negative.value, std::hypot(positive.error, negative.error),
                             std::hypot(positive.shared, negative.shared)});
        }
        widths.push_back(std::move(width));
        result.middle += (all.positive[i][0].value - all.negative[i][0].value) / 2 / static_cast<double>(cycles);
        apart += (all.negative_time[i] - all.positive_time[i]) / static_cast<double>(cycles);
    }
    auto const width = rig::means_of(widths), jump = rig::means_of(all.jumps);
    auto const with_drift = [&](Estimate each) {
        each.error = std::hypot(each.error, drift_error * apart);
        return each;
    };
    result.loop_width = with_drift(rig::extrapolated(width));
    if (jump.empty()) {
        result.friction_width = width_by_friction(result);
        result.backlash = {result.loop_width.value - result.friction_width.value,
                           std::hypot(result.loop_width.error, result.friction_width.error), result.loop_width.count};
        return;
    }
    result.backlash = rig::extrapolated(jump);
    // Width and jumps share half of their lines, so that the variance of the width counts half.
    std::vector<Estimate> by_friction;
    for (std::size_t j = 0; j < std::min(width.size(), jump.size()); ++j)
        by_friction.push_back({width[j].value - jump[j].value,
                               std::hypot(width[j].error / std::numbers::sqrt2, jump[j].error), result.cycles});
    result.friction_width = rig::extrapolated(by_friction);
    result.friction_width.error = std::hypot(result.friction_width.error, drift_error * apart / std::numbers::sqrt2);
}

/// Takes the drift out.
void remove_drift(MeasuredCurve const& curve, std::vector<LoadBranch> const& branches, Samples& samples,
                  BranchLimits& limits, MeasuredStiffness& result)
{
    auto const drift = rig::drift_of(samples, branches, result.largest_torque);
    if (!drift)
        return;
    double const intervals = static_cast<double>(curve.twist.size() - 1);
    result.drift = {drift->value * intervals, drift->error * intervals, 1};
    limits.drift_error = drift->error;
    for (std::size_t i = 0; i < samples.twist.size(); ++i)
        samples.twist[i] -= drift->value * samples.time[i];
}

/// The mean of a figure of two stages; nothing where a branch with a bend does not determine it, or where no more
/// branches are bent than straight: those that remain would be those that noise bends most.
Estimate of_bent_branches(BranchFigures const& all, std::vector<Found> const& figure)
{
    std::size_t const straight = static_cast<std::size_t>(all.straight), bent = all.whole.size() - straight;
    return figure.size() == bent && bent > straight ? mean_of(figure) : Estimate{};
}

Reach reach_of(MeasuredStiffness const& result)
{
    return {measured_at::no_load * result.largest_torque, measured_at::near_zero * result.largest_torque};
}

/// Takes out what the sensor of the torque shows without load.
void remove_torque_offset(std::vector<LoadBranch> const& branches, rig::Noise const& noise, Samples& samples,
                          MeasuredStiffness& result)
{
    result.torque_middle = rig::unloaded_torque(samples, branches, reach_of(result), noise);
    for (double& each : samples.torque)
        each -= result.torque_middle;
    auto const [low, high] = std::ranges::minmax(samples.torque);
    result.largest_torque = std::max(-low, high);
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
    auto const branches = rig::branches_of(samples.torque, measured_at::reversal * result.largest_torque);
    BranchLimits limits;
    double const step = rig::smallest_step(samples.twist);
    limits.noise.rounding = rig::rounding_of(samples.twist, step);  // without the drift none are steps
    result.angle_step = limits.noise.rounding > 0 ? step : 0;
    remove_drift(curve, branches, samples, limits, result);
    check_sense(curve, samples);
    limits.noise.deviation = rig::deviation_from_neighbours(samples, branches);
    remove_torque_offset(branches, limits.noise, samples, result);
    double const least = std::min(result.torque_middle - low, high - result.torque_middle);
    limits.loaded = measured_at::loaded * least;
    limits.reach = reach_of(result);
    Found const friction = rig::friction_torque(samples, branches, result.angle_step);
    BranchFigures const all = rig::branch_figures(samples, branches, friction, limits);
    if (all.positive.empty() || all.negative.empty())
        refuse(curve,
               std::string("the load is never taken off from the ") + (all.positive.empty() ? "positive" : "negative") +
                   " side",
               "write a whole load cycle: 0, T, 0, -T, 0; without unloading there is no width of the loop");
    result.friction = {friction.value, friction.error, static_cast<int>(branches.size()) - 1};
    result.first = of_bent_branches(all, all.first);
    result.second = of_bent_branches(all, all.second);
    result.knee = of_bent_branches(all, all.knee);
    result.whole = mean_of(all.whole);
    result.straight = all.straight;
    add_loop(all, limits.drift_error, result);
    // Nobody knows at which torque the flanks meet: all of these may contain the play and the friction.
    if (all.jumps.empty() && friction.value > limits.reach.gap) {
        result.backlash = result.friction_width = result.first = result.second = result.knee = result.whole = {};
        result.straight = 0;
    }
    return result;
}

}  // namespace hdconj
