// SPDX-License-Identifier: GPL-3.0-or-later
#include "branch_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "backlash.hpp"
#include "hdconj/load.hpp"

namespace hdconj::rig {
namespace {

struct Sample
{
    double twist = 0, torque = 0;
};

/// Straight line of the angle over the torque. The torque was set and the angle read.
struct Line
{
    Found at_zero, slope;
};

/// None where all torques are one.
std::optional<Line> line_through(std::span<Sample const> samples, Noise const& noise)
{
    auto const [least, most] = std::ranges::minmax_element(samples, {}, &Sample::torque);
    if (samples.empty() || !(least->torque < most->torque))
        return std::nullopt;
    auto const count = static_cast<Eigen::Index>(samples.size());
    Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(count, 2);
    Eigen::VectorXd angles(count);
    double const scale = most->torque;
    for (Eigen::Index i = 0; i < count; ++i) {
        columns(i, 1) = samples[static_cast<std::size_t>(i)].torque / scale;
        angles[i] = samples[static_cast<std::size_t>(i)].twist;
    }
    Found slope = fitted(columns, angles, Eigen::Vector2d(0, 1), noise);
    for (double* each : {&slope.value, &slope.error, &slope.shared})
        *each /= scale;
    return Line{fitted(columns, angles, Eigen::Vector2d(1, 0), noise), slope};
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

/// Angle at zero torque by curves through the end of an unloading branch, without the readings that have no load. Where
/// these are fewer than three, by the two next to zero; those without load are left out where that leaves two within
/// twice the reach.
ByCurve rest_of(std::vector<Sample> samples, BranchLimits const& limits)
{
    constexpr std::ptrdiff_t enough = 3, two = 2;
    std::ranges::stable_sort(samples, {}, &Sample::torque);
    std::vector<BesideCrossing> all;
    for (Sample const& each : samples)
        all.push_back({each.torque, each.twist});
    auto const up_to = [&](double torque) {
        return std::ranges::upper_bound(all, torque, {}, &BesideCrossing::distance);
    };
    auto const loaded = std::ranges::lower_bound(all, limits.reach.gap, {}, &BesideCrossing::distance);
    auto from = loaded, to = up_to(limits.reach.far);
    if (to - from < enough) {
        if (up_to(2 * limits.reach.far) - from < two)
            from = all.begin();
        to = from + std::min(two, all.end() - from);
    }
    auto const end = std::max(up_to(2 * limits.reach.far), from + std::min(enough, all.end() - from));
    if (to - from < two || from->distance == (to - 1)->distance)
        return {};
    return extrapolations({{from, to}, {from, end}}, AtCrossing::angle, limits.reach.far, limits.noise);
}

/// Adds the stages of a loading branch. Lines of the angle over the torque are fitted: noise of the angle on the other
/// axis would make every stiffness too small.
void add_loading(std::vector<Sample> samples, BranchLimits const& limits, BranchFigures& all)
{
    double const from = samples.front().twist;  // the angle grows from zero whatever it counts from
    double const drift_error =
        limits.drift_error * static_cast<double>(samples.size()) / samples.back().torque;  // angle per torque
    std::erase_if(samples, [&](Sample const& each) { return each.torque < limits.engaged; });
    for (Sample& each : samples)
        each.twist -= from;
    auto const line = line_through(samples, limits.noise);
    if (!line)
        return;
    auto const stiffness = [&](Found const& compliance) {
        double const square = compliance.value * compliance.value;
        return Found{1 / compliance.value, std::hypot(compliance.error, drift_error) / square,
                     compliance.shared / square};
    };
    all.whole.push_back(stiffness(line->slope));
    std::vector<double> torque, twist;
    for (Sample const& each : samples) {
        torque.push_back(each.torque);
        twist.push_back(each.twist);
    }
    StiffnessStages const stages = stiffness_stages(torque, twist);
    if (!stages.found) {
        ++all.straight;
        return;
    }
    auto const knee = std::ranges::partition_point(samples, [&](Sample const& each) {
        return each.torque <= stages.knee_twist;  // the axes are exchanged
    });
    auto const shared = [&](std::span<Sample const> part) {
        auto const own = line_through(part, limits.noise);
        return own ? own->slope.shared : 0;
    };
    auto const add = [](std::vector<Found>& to, Found const& found) {
        if (std::isfinite(found.error))
            to.push_back(found);
    };
    add(all.first, stiffness({stages.first, stages.first_error, shared({samples.begin(), knee})}));
    add(all.second, stiffness({stages.second, stages.second_error, shared({knee, samples.end()})}));
    add(all.knee, {stages.knee_twist, stages.knee_twist_error,
                   std::numbers::sqrt2 * limits.noise.rounding / std::abs(stages.first - stages.second)});
}

/// Adds both sides of one branch: a branch from one load to the opposite one unloads first, then loads.
void add_branch(Samples const& curve, LoadBranch const& branch, BranchLimits const& limits, BranchFigures& all)
{
    for (double const sign : {1.0, -1.0}) {
        double const at_first = sign * curve.torque[branch.first], at_last = sign * curve.torque[branch.last];
        if (std::max(at_first, at_last) < limits.loaded)
            continue;
        auto const samples = loaded_part(curve, branch, sign);
        if (at_last > at_first) {
            add_loading(samples, limits, all);
        } else if (at_last <= limits.reach.far) {
            if (auto const rest = rest_of(samples, limits); !rest.empty()) {
                bool const above = sign > 0;
                (above ? all.positive : all.negative).push_back(rest);
                (above ? all.positive_time : all.negative_time)
                    .push_back(curve.time[branch.first + samples.size() - 1]);
            }
        }
    }
}

}  // namespace

BranchFigures branch_figures(Samples const& samples, std::vector<LoadBranch> const& branches, Found const& friction,
                             BranchLimits limits)
{
    BranchFigures all;
    limits.engaged = limits.reach.gap;
    for (auto const& branch : branches) {
        if (auto const jump = jump_of_play(samples, branch, friction, limits.reach, limits.noise)) {
            all.jumps.push_back(jump->heights);
            limits.engaged = std::max(limits.engaged, jump->engaged);
        }
    }
    for (auto const& branch : branches)
        add_branch(samples, branch, limits, all);
    return all;
}

}  // namespace hdconj::rig
