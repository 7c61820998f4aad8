// SPDX-License-Identifier: GPL-3.0-or-later
#include "losses.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/units.hpp"

namespace hdconj::running {
namespace {

/// Every second position of @p runs: half of what is known, for the error of the positions.
std::vector<LoadedRun> every_second(std::vector<LoadedRun> runs)
{
    for (LoadedRun& run : runs) {
        std::vector<WeighedContacts> kept;
        for (std::size_t i = 0; i < run.sliding.size(); i += 2)
            kept.push_back(std::move(run.sliding[i]));
        for (WeighedContacts& each : kept)
            each.weight = 1.0 / static_cast<double>(kept.size());
        run.sliding = std::move(kept);
    }
    return runs;
}

std::vector<EfficiencyRow> efficiency_rows(LossModel const& model, RunTask const& task,
                                           std::vector<LoadedRun> const& runs)
{
    std::vector<EfficiencyRow> rows;
    for (double const temperature : task.temperatures)
        for (double const speed : task.speeds)
            for (LoadedRun const& run : runs)
                rows.push_back(efficiency_at(model, run, speed, temperature));
    return rows;
}

/// The figures without their errors.
RunLosses losses_of(LossModel const& model, RunTask const& task, std::vector<LoadedRun> const& runs)
{
    RunLosses losses;
    losses.efficiency = efficiency_rows(model, task, runs);
    losses.starting_torque = resting_torque(model, runs.front());
    losses.back_driving = back_driving_torque(model, runs);
    losses.ball_load = runs.back().ball_load;
    losses.bearing_diameter = model.diameter;
    for (WeighedContacts const& position : runs.back().sliding)
        for (SlidingContact const& each : position.contacts)
            losses.largest_sliding = std::max(losses.largest_sliding, model.motion.cup_rate() * each.sliding);
    return losses;
}

/// Adds @p factor times the difference to @p other to the errors.
void add_errors(RunLosses const& other, double factor, RunLosses& losses)
{
    auto const add = [factor](double& error, double here, double there) { error += factor * std::abs(here - there); };
    for (std::size_t i = 0; i < losses.efficiency.size(); ++i) {
        EfficiencyRow& row = losses.efficiency[i];
        add(row.efficiency_error, row.efficiency, other.efficiency[i].efficiency);
        add(row.input_torque_error, row.input_torque, other.efficiency[i].input_torque);
    }
    add(losses.starting_torque_error, losses.starting_torque, other.starting_torque);
    if (losses.back_driving && other.back_driving)
        add(losses.back_driving_error, *losses.back_driving, *other.back_driving);
    add(losses.ball_load_error, losses.ball_load, other.ball_load);
    add(losses.largest_sliding_error, losses.largest_sliding, other.largest_sliding);
}

}  // namespace

std::vector<LoadedRun> loaded_runs(TurningDrive const& drive, RunTask const& task, SequenceObserver const& observer)
{
    std::vector<LoadedRun> runs{{0, {}, drive.assembled_ball_load()}};
    std::vector<double> spline_torques;
    for (double const torque : task.torques) {
        runs.push_back({torque, {}, 0});
        spline_torques.push_back(task.motion.spline_torque(torque));
    }
    double found = 0;
    for (double const pitches : tooth_pitch_plan(loss_positions).pitches) {
        if (observer.stop && observer.stop()) {
            if (observer.on_missing)
                observer.on_missing("stopped before all losses were known");
            break;
        }
        try {
            std::vector<Balance> balances = drive.balances(pitches, spline_torques, nullptr);
            ++found;
            for (std::size_t i = 0; i < balances.size(); ++i) {
                runs[i + 1].sliding.push_back({std::move(balances[i].sliding)});
                runs[i + 1].ball_load += balances[i].ball_load;
            }
        } catch (NumericalError const& error) {
            if (observer.on_missing)
                observer.on_missing(
                    fmt::format("no losses at {:.4g} pitches of the wave generator: {}", pitches, error.what()));
        }
        if (observer.on_position)
            observer.on_position();
    }
    if (found == 0)
        return {};
    for (std::size_t i = 1; i < runs.size(); ++i) {
        runs[i].ball_load /= found;
        for (WeighedContacts& each : runs[i].sliding)
            each.weight = 1 / found;
    }
    return runs;
}

RunLosses run_losses(LossModel const& model, RunTask const& task, std::vector<LoadedRun> const& runs,
                     std::vector<LoadedRun> const& coarse, double safety)
{
    RunLosses losses = losses_of(model, task, runs);
    losses.estimated = coarse.size() == runs.size();
    if (losses.estimated) {
        add_errors(losses_of(model, task, coarse), safety, losses);
        add_errors(losses_of(model, task, every_second(runs)), 1, losses);
    }
    return losses;
}

}  // namespace hdconj::running
