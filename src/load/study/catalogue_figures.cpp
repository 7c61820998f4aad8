// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "load/grids/grid_error.hpp"
#include "torque_branch.hpp"

namespace hdconj::load {
namespace {

/// Figures of CatalogueFigures on one grid.
struct Slopes
{
    std::array<double, 3> k = {};  ///< K1, K2, K3 [N mm/rad]
    double lost_motion = 0;        ///< [rad]
};

std::optional<Slopes> slopes_of(CatalogueTorques const& torques, CurveBranches const& curve)
{
    if (curve.forth.empty() || !(torques.second < std::abs(curve.forth.back().torque)))
        return std::nullopt;
    double const sign = std::copysign(1, curve.forth.back().torque);
    LoadedState const* const at[] = {state_at(curve.forth, sign * torques.first),
                                     state_at(curve.forth, sign * torques.second), &curve.forth.back()};
    LoadedState const* const lost[] = {state_at(curve.forth, sign * torques.lost_motion),
                                       state_at(curve.back, -sign * torques.lost_motion)};
    if (!at[0] || !at[1] || !lost[0] || !lost[1])
        return std::nullopt;
    Slopes result;
    double torque = 0, twist = curve.free;
    for (std::size_t i = 0; i < result.k.size(); ++i) {
        result.k[i] = (at[i]->torque - torque) / (at[i]->twist - twist);
        torque = at[i]->torque;
        twist = at[i]->twist;
    }
    result.lost_motion = std::abs(lost[0]->twist - lost[1]->twist);
    return result;
}

/// The polygon of the states at even torques.
StiffnessStages lines_of(CurveBranches const& curve)
{
    constexpr int samples = 100;
    if (curve.forth.size() < 2)
        return {};
    std::vector<double> torques, twists;
    double const rated = curve.forth.back().torque;
    std::size_t k = 0;  // of the state at whose end the interval lies
    for (int i = 1; i <= samples; ++i) {
        double const torque = i == samples ? rated : rated * i / samples;
        while (std::abs(curve.forth[k].torque) < std::abs(torque))
            ++k;
        bool const first = k == 0 || curve.forth[k - 1].torque == 0;
        double const from = first ? 0 : curve.forth[k - 1].torque;
        double const twist = first ? curve.free : curve.forth[k - 1].twist;
        double const along = (torque - from) / (curve.forth[k].torque - from);
        torques.push_back(torque);
        twists.push_back(twist + along * (curve.forth[k].twist - twist));
    }
    return stiffness_stages(twists, torques);
}

/// Every second state of `forth` from @p first on, and the last.
CurveBranches thinned(CurveBranches const& curve, std::size_t first)
{
    CurveBranches result{.forth = {}, .back = {}, .free = curve.free};
    for (std::size_t i = first; i + 1 < curve.forth.size(); i += 2)
        result.forth.push_back(curve.forth[i]);
    if (!curve.forth.empty())
        result.forth.push_back(curve.forth.back());
    return result;
}

constexpr double StiffnessStages::*figures_of_stages[] = {&StiffnessStages::first, &StiffnessStages::second,
                                                          &StiffnessStages::knee, &StiffnessStages::knee_twist};
constexpr double StiffnessStages::*errors_of_stages[] = {&StiffnessStages::first_error, &StiffnessStages::second_error,
                                                         &StiffnessStages::knee_error,
                                                         &StiffnessStages::knee_twist_error};

/// Adds to the errors of @p stages what the chords between the states of @p curve cut off. On a smooth curve that error
/// is of second order in the distance of the states: lines through every second state differ by three times as much.
/// There are two such halves. The larger difference is taken 1.5 times, because a half may agree by chance. The knee
/// may agree in both, so its relative error is at least that of the slopes.
void add_chord_errors(CurveBranches const& curve, StiffnessStages& stages)
{
    constexpr double safety = 1.5;
    StiffnessStages const halves[] = {lines_of(thinned(curve, 0)), lines_of(thinned(curve, 1))};
    double relative = 0;
    for (std::size_t i = 0; i < std::size(figures_of_stages); ++i) {
        double const value = stages.*figures_of_stages[i];
        double difference = 0;
        for (StiffnessStages const& half : halves)
            difference = std::max(difference, safety * std::abs(value - half.*figures_of_stages[i]));
        if (i < 2 && value != 0)
            relative = std::max(relative, difference / std::abs(value));
        stages.*errors_of_stages[i] += i < 2 ? difference : std::max(difference, relative * std::abs(value));
    }
}

void raise(double& error, double least)
{
    error = std::max(error, least);
}

/// Raises the errors of the knee to how far two lines with the errors of their slopes may meet from it: far, where they
/// are nearly parallel, but on the curve.
void add_slope_errors(CurveBranches const& curve, StiffnessStages& stages)
{
    if (stages.knee == 0 || stages.first == stages.second)
        return;
    LoadedState const& last = curve.forth.back();
    double const relative = (stages.first_error + stages.second_error) / std::abs(stages.second - stages.first);
    raise(stages.knee_error, std::min(relative * std::abs(stages.knee), std::abs(last.torque)));
    raise(stages.knee_twist_error, std::min(relative * std::abs(stages.knee_twist), std::abs(last.twist)));
}

}  // namespace

std::optional<CatalogueFigures> catalogue_figures(CatalogueTorques const& torques, CurveBranches const& fine,
                                                  std::vector<CurveBranches> const& coarser, double safety,
                                                  double relative_twist, double series)
{
    std::optional<Slopes> const found = slopes_of(torques, fine);
    if (!found)
        return std::nullopt;
    CatalogueFigures result{.torque = torques,
                            .k1 = {found->k[0]},
                            .k2 = {found->k[1]},
                            .k3 = {found->k[2]},
                            .lost_motion = found->lost_motion};
    std::array<std::vector<double>, 3> k;
    std::vector<double> lost_motion;
    for (CurveBranches const& curve : coarser) {
        std::optional<Slopes> const other = slopes_of(torques, curve);
        if (!other)
            break;
        for (std::size_t i = 0; i < k.size(); ++i)
            k[i].push_back(other->k[i]);
        lost_motion.push_back(other->lost_motion);
    }
    if (lost_motion.empty())
        return result;
    // Grids may agree by chance in one of them: relative to its size, none gets less than the worst. Those of K1 are
    // the largest. Times the safety, see grid_error.cpp.
    constexpr double lost_motion_factor = 4.2;
    constexpr std::array slope_factors{1.65, 0.9, 0.9};
    double relative = 0;
    for (std::size_t i = 0; i < k.size(); ++i)
        relative = std::max(relative, safety * grid_difference(found->k[i], k[i]) / found->k[i]);
    Stiffness* const slopes[] = {&result.k1, &result.k2, &result.k3};
    for (std::size_t i = 0; i < k.size(); ++i)
        slopes[i]->error = slope_factors[i] * relative * slopes[i]->value;
    result.lost_motion_error = std::max(lost_motion_factor * safety * grid_difference(found->lost_motion, lost_motion),
                                        relative_twist * (result.lost_motion - 2 * torques.lost_motion * series));
    result.estimated = true;
    return result;
}

StiffnessStages stages_of(CurveBranches const& fine, std::vector<CurveBranches> const& coarser, double safety)
{
    StiffnessStages stages = lines_of(fine);
    std::vector<StiffnessStages> others;
    for (CurveBranches const& curve : coarser)
        others.push_back(lines_of(curve));
    std::vector<double> values(others.size());
    constexpr double factor = 1.35;  // of the error over the difference, times the safety, see grid_error.cpp
    for (std::size_t i = 0; i < std::size(figures_of_stages); ++i) {
        std::ranges::transform(others, values.begin(), figures_of_stages[i]);
        stages.*errors_of_stages[i] =
            values.empty() ? 0 : factor * safety * grid_difference(stages.*figures_of_stages[i], values);
    }
    if (!coarser.empty())
        add_chord_errors(fine, stages);
    // Grids may agree by chance in one of them. So the first line and the knee have at least the relative error of the
    // worse line; the second line, at larger torques, a third of it: those of 170 drives are within 0.6 of their
    // errors.
    constexpr double share_of_second = 1.0 / 3;
    double relative = 0;
    for (std::size_t i = 0; i < 2; ++i)
        if (stages.*figures_of_stages[i] != 0)
            relative = std::max(relative, stages.*errors_of_stages[i] / std::abs(stages.*figures_of_stages[i]));
    for (std::size_t i = 0; i < std::size(figures_of_stages); ++i)
        raise(stages.*errors_of_stages[i],
              (i == 1 ? share_of_second : 1) * relative * std::abs(stages.*figures_of_stages[i]));
    add_slope_errors(fine, stages);
    return stages;
}

}  // namespace hdconj::load
