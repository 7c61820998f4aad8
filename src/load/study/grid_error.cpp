// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_error.hpp"

#include <algorithm>
#include <cmath>

#include "bearing_map.hpp"
#include "hdconj/error.hpp"
#include "load_problem.hpp"

namespace hdconj::load {
namespace {

/// @p safety times the difference of each figure that is a number, the difference of those that count, and zero
/// elsewhere.
///
/// Two grids may agree by chance in one of several related figures. Stiffness, shares, largest force and pressure all
/// depend on which contacts are closed: relative to its size, none gets less than their median. Of the forces of the
/// bearing none gets less than the largest of them.
LoadedState error_between(LoadedState const& a, LoadedState const& b, double safety)
{
    LoadedState d;
    for (double LoadedState::*const figure :
         {&LoadedState::twist, &LoadedState::stiffness, &LoadedState::contact_area, &LoadedState::contact_fraction,
          &LoadedState::fraction_within_gap, &LoadedState::carrying_fraction, &LoadedState::largest_pressure,
          &LoadedState::largest_force, &LoadedState::wave_generator_force, &LoadedState::wave_generator_torque,
          &LoadedState::lobe_force, &LoadedState::lobe_force_across, &LoadedState::lobe_z, &LoadedState::ball_force})
        d.*figure = safety * std::abs(a.*figure - b.*figure);
    auto const relative_to_size = [&](double LoadedState::*figure) {
        return a.*figure != 0 ? d.*figure / std::abs(a.*figure) : 0;
    };
    auto const raise = [&](auto const& figures, double relative) {
        for (auto const figure : figures)
            d.*figure = std::max(d.*figure, relative * std::abs(a.*figure));
    };
    constexpr double LoadedState::*contacts[] = {&LoadedState::stiffness, &LoadedState::contact_fraction,
                                                 &LoadedState::fraction_within_gap, &LoadedState::largest_force,
                                                 &LoadedState::largest_pressure};
    std::vector<double> relative;
    for (auto const figure : contacts)
        relative.push_back(relative_to_size(figure));
    std::sort(relative.begin(), relative.end());
    double const median = relative[relative.size() / 2];
    raise(contacts, median);
    d.contact_area = std::max(d.contact_area, median * a.contact_area);
    constexpr double LoadedState::*bearing[] = {&LoadedState::wave_generator_force, &LoadedState::lobe_force,
                                                &LoadedState::ball_force};
    double largest = 0;
    for (auto const figure : bearing)
        largest = std::max(largest, relative_to_size(figure));
    raise(bearing, largest);
    d.teeth = std::abs(a.teeth - b.teeth);
    d.balls = std::abs(a.balls - b.balls);
    return d;
}

/// The loading path of @p curve on the coarse grid; nothing where that has no play or no balance without torque.
std::optional<TorqueContinuation> coarse_path(LoadProblem const& problem, LoadedDrive const& unloaded,
                                              LoadedCurve const& curve)
{
    try {
        std::optional<Play> const play =
            curve.play < 0 ? play_of(problem, unloaded.shape) : play_about(problem, unloaded.shape, curve.middle);
        if (play)
            return torque_continuation(problem, unloaded, *play);
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        // There is nothing to compare with.
    }
    return std::nullopt;
}

/// At one torque of a curve two grids may agree by chance: relative to its size, no twist gets less than the median.
void raise_twists_to_median(std::vector<LoadedState> const& states, std::vector<std::optional<LoadedState>>& errors)
{
    std::vector<double> relative;
    for (std::size_t i = 0; i < states.size(); ++i)
        if (errors[i] && states[i].twist != 0)
            relative.push_back(errors[i]->twist / std::abs(states[i].twist));
    if (relative.empty())
        return;
    std::sort(relative.begin(), relative.end());
    for (std::size_t i = 0; i < states.size(); ++i)
        if (auto& error = errors[i])
            error->twist = std::max(error->twist, relative[relative.size() / 2] * std::abs(states[i].twist));
}

}  // namespace

void estimate_errors(contact::ContactContext const& context, DrivePair const& drives, AssembledCup& cup)
{
    double const safety = grid_safety(cup.z.size());
    AssembledCup const coarse = assembled_cup(context, *drives.coarse);
    ElasticDrive const &fine_drive = drives.fine.model.drive, &coarse_drive = drives.coarse->model.drive;
    double const balls =
        ball_distance(bearing_map(fine_drive, drives.fine.unloaded.state),
                      bearing_map(coarse_drive, drives.coarse->unloaded.state), fine_drive.response.sectors());
    cup.coning_major_error = safety * std::abs(cup.coning_major - coarse.coning_major);
    cup.coning_minor_error = safety * std::abs(cup.coning_minor - coarse.coning_minor);
    cup.wave_generator_force_error = safety * std::abs(cup.wave_generator_force - coarse.wave_generator_force);
    cup.ball_force_error = safety * std::max(balls, std::abs(cup.ball_force - coarse.ball_force));
    cup.largest_stress_error += safety * std::abs(cup.largest_stress - coarse.largest_stress);
    cup.estimated = true;
}

CurveErrors curve_errors(contact::ContactContext const& context, AssembledDrive const& coarse,
                         contact::FlankGrid const& flanks, LoadedCurve const& curve)
{
    constexpr int most_failures = 3;  // torques without an equilibrium, after which no more are tried
    CurveErrors errors;
    errors.states.assign(curve.states.size(), std::nullopt);
    ElasticDrive const& drive = coarse.model.drive;
    contact::FlankGrid const grid = coarsened(flanks, coarse.grid.slices);
    LoadProblem const problem = load_problem(context, drive, grid);
    double const safety = grid_safety(flanks.slices());
    std::optional<TorqueContinuation> const path = coarse_path(problem, coarse.unloaded, curve);
    if (!path)
        return errors;
    errors.play = safety * std::abs(curve.play - width_of(path->play));
    LoadedDrive at = path->start;
    int failures = 0;
    for (std::size_t i = 0; i < curve.states.size() && failures < most_failures; ++i) {
        LoadedState const& state = curve.states[i];
        try {
            at = advance(*path, at, state.torque);
        } catch (NumericalError const& error) {
            if (!error.is_infeasible())
                throw;
            ++failures;
            continue;
        }
        LoadedState error = error_between(state, loaded_state(problem, at, path->middle), safety);
        error.twist += state.gap_mismatch / context.geometry.r_m;
        error.ball_force =
            std::max(error.ball_force,
                     safety * ball_distance(curve.bearing[i], bearing_map(drive, at.state), drive.response.sectors()));
        errors.states[i] = error;
        if (i == curve.rated)
            errors.rated_forces = at.forces;
    }
    raise_twists_to_median(curve.states, errors.states);
    return errors;
}

}  // namespace hdconj::load
