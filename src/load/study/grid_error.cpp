// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_error.hpp"

#include <algorithm>
#include <cmath>

#include "bearing_map.hpp"
#include "hdconj/error.hpp"
#include "load_problem.hpp"

namespace hdconj::load {
namespace {

/// How an error follows from the difference of two grids.
struct ErrorRule
{
    double LoadedState::*figure;
    /// Times grid_safety(). Chosen so that no estimate of twelve random drives was too small
    /// (docs/explanation/load.md).
    double factor;
};

constexpr ErrorRule error_rules[] = {{&LoadedState::twist, 1},
                                     {&LoadedState::stiffness, 1},
                                     {&LoadedState::contact_area, 2},
                                     {&LoadedState::contact_fraction, 2},
                                     {&LoadedState::fraction_within_gap, 2},
                                     {&LoadedState::carrying_fraction, 2},
                                     {&LoadedState::largest_pressure, 1},
                                     {&LoadedState::largest_force, 0.4},
                                     {&LoadedState::largest_line_load, 0.8},
                                     {&LoadedState::flank_pressure, 1},
                                     {&LoadedState::edge_force, 0.5},
                                     {&LoadedState::edge_fraction, 1},
                                     {&LoadedState::flowing_fraction, 1},
                                     {&LoadedState::wave_generator_force, 1},
                                     {&LoadedState::wave_generator_torque, 1.25},
                                     {&LoadedState::lobe_force, 1},
                                     {&LoadedState::lobe_force_across, 0.3},
                                     {&LoadedState::lobe_z, 1},
                                     {&LoadedState::ball_force, 0.5}};

/// Errors of @p a by its differences from @p b on a coarser grid. Two grids may agree by chance: no error is less than
/// what those of related figures make of it.
/// @param half_width  of the bearing [mm]
LoadedState error_between(LoadedState const& a, LoadedState const& b, double safety, double half_width)
{
    LoadedState d;
    for (auto const& [figure, factor] : error_rules)
        d.*figure = factor * safety * std::abs(a.*figure - b.*figure);
    auto const relative = [&](double LoadedState::*figure) {
        return a.*figure != 0 ? d.*figure / std::abs(a.*figure) : 0;
    };
    auto const raise = [&](double LoadedState::*figure, double least) {
        d.*figure = std::max(d.*figure, least * std::abs(a.*figure));
    };
    double const bearing = std::max(relative(&LoadedState::wave_generator_force), relative(&LoadedState::lobe_force));
    raise(&LoadedState::wave_generator_force, bearing);
    raise(&LoadedState::lobe_force, bearing);
    d.lobe_z = std::max(d.lobe_z, bearing * half_width);
    // Forces on single slices have no strip between slices: what is under pressure lies within the gap.
    if (a.contact_fraction == 0 && a.teeth > 0)
        d.contact_fraction = std::max(d.contact_fraction, a.fraction_within_gap);
    raise(&LoadedState::largest_pressure, relative(&LoadedState::contact_fraction) / 2);
    raise(&LoadedState::largest_force, relative(&LoadedState::twist));
    for (double LoadedState::*const figure : {&LoadedState::largest_line_load, &LoadedState::edge_force})
        raise(figure, relative(&LoadedState::largest_force));
    raise(&LoadedState::wave_generator_torque, relative(&LoadedState::twist) / 4);
    // Both grids may have all forces on edges where a finer one has some beside them, at a pressure that is unknown.
    raise(&LoadedState::edge_fraction, std::min(1.0, relative(&LoadedState::twist)));
    if (a.flank_pressure == 0)
        d.flank_pressure = a.largest_pressure;
    d.teeth = std::abs(a.teeth - b.teeth);
    d.balls = std::abs(a.balls - b.balls);
    return d;
}

}  // namespace

double stress_error(double fine, double coarse, double at_corners, double safety)
{
    constexpr double part = 0.25;
    return part * (safety * std::abs(fine - coarse) + at_corners);
}

namespace {

/// The twist of a branch is an integral over all contacts that have closed: relative to its size, none gets less than
/// the worst, or than itself where that is smaller. A stiffness is local: none gets less than the median.
void raise_along_branch(std::vector<LoadedState> const& states, std::vector<std::optional<LoadedState>>& errors)
{
    for (double LoadedState::*const figure : {&LoadedState::twist, &LoadedState::stiffness}) {
        std::vector<double> relative;
        for (std::size_t i = 0; i < states.size(); ++i)
            if (errors[i] && states[i].*figure != 0)
                relative.push_back((*errors[i]).*figure / std::abs(states[i].*figure));
        if (relative.empty())
            continue;
        std::ranges::sort(relative);
        double const least =
            figure == &LoadedState::twist ? std::min(relative.back(), 1.0) : relative[relative.size() / 2];
        for (std::size_t i = 0; i < states.size(); ++i)
            if (auto& error = errors[i])
                (*error).*figure = std::max((*error).*figure, least * std::abs(states[i].*figure));
    }
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
    constexpr double force = 0.4, ball = 0.15;  // they converge faster than the shape
    cup.wave_generator_force_error = force * safety * std::abs(cup.wave_generator_force - coarse.wave_generator_force);
    cup.ball_force_error = ball * safety * std::max(balls, std::abs(cup.ball_force - coarse.ball_force));
    cup.largest_stress_error =
        stress_error(cup.largest_stress, coarse.largest_stress, cup.largest_stress_error, safety);
    cup.estimated = true;
}

std::optional<TorqueContinuation> coarse_path(LoadProblem const& problem, LoadedDrive const& unloaded,
                                              TorqueContinuation const& fine)
{
    try {
        std::optional<Play> const play =
            fine.pressed ? play_of(problem, unloaded.shape) : play_about(problem, unloaded.shape, fine.middle);
        if (play)
            return torque_continuation(problem, unloaded, *play);
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        // There is nothing to compare with.
    }
    return std::nullopt;
}

BranchErrors branch_errors(TorqueContinuation const& coarse, TorqueBranch const& branch, double safety)
{
    constexpr double ball_factor = 0.5;  // as of the largest of them
    constexpr int most_failures = 3;     // torques without an equilibrium, after which no more are tried
    BranchErrors errors;
    errors.states.assign(branch.states.size(), std::nullopt);
    ElasticDrive const& drive = coarse.problem.drive;
    std::vector<std::size_t> solved;
    std::vector<double> balls;
    LoadedDrive at = coarse.start;
    for (std::size_t i = 0; i < branch.states.size() && i < solved.size() + most_failures; ++i) {
        try {
            at = advance(coarse, at, branch.states[i].torque);
        } catch (NumericalError const& error) {
            if (!error.is_infeasible())
                throw;
            continue;
        }
        errors.coarse.push_back(loaded_state(coarse.problem, at, coarse.middle));
        solved.push_back(i);
        balls.push_back(ball_distance(branch.bearing[i], bearing_map(drive, at.state), drive.response.sectors()));
        if (i + 1 == branch.states.size())
            errors.last_forces = at.forces;
    }
    if (solved.empty())
        return errors;
    if (branch.states.size() == 1)
        errors.coarse.back().stiffness = stiffness_at(coarse, at);
    else
        enter_stiffness(errors.coarse, free_twist(coarse, branch.states.back().torque));
    double const half_width = 0.5 * (drive.bearing_z.back() - drive.bearing_z.front());
    for (std::size_t k = 0; k < solved.size(); ++k) {
        LoadedState const& state = branch.states[solved[k]];
        LoadedState error = error_between(state, errors.coarse[k], safety, half_width);
        error.twist += state.gap_mismatch / coarse.problem.context.geometry.r_m;
        error.ball_force = std::max(error.ball_force, ball_factor * safety * balls[k]);
        errors.states[solved[k]] = error;
    }
    raise_along_branch(branch.states, errors.states);
    return errors;
}

}  // namespace hdconj::load
