// SPDX-License-Identifier: GPL-3.0-or-later
#include "losses.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "load/grids/grid_error.hpp"

namespace hdconj::running {
namespace {

// Of the safety of `load`: with 9 slices eight drives of 15 to 80 mm and ratios 30 to 160 are within it of 33 slices,
// and so is type-50. The largest sliding is that of a single contact.
constexpr double of_losses = 2, of_extreme = 1.75;

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
RunLosses losses_of(LossModel const& model, RunTask const& task, LossRuns const& runs)
{
    RunLosses losses;
    losses.efficiency = efficiency_rows(model, task, runs.asked);
    losses.starting_torque = resting_torque(model, runs.asked.front());
    losses.back_driving = back_driving_torque(model, runs.with_between());
    losses.ball_load = runs.asked.back().ball_load;
    losses.bearing_diameter = model.diameter;
    for (WeighedContacts const& position : runs.asked.back().sliding)
        for (SlidingContact const& each : position.contacts)
            losses.largest_sliding = std::max(losses.largest_sliding, model.motion.cup_rate() * each.sliding);
    return losses;
}

/// Adds @p factor times the difference to @p coarser, the next one first, to the errors. Where a coarser grid finds no
/// back-driving torque, it is taken as the largest torque.
void add_errors(std::vector<RunLosses> const& coarser, double factor, RunLosses& losses)
{
    auto const add = [&](double& error, auto const& figure) {
        std::vector<double> values(coarser.size());
        std::ranges::transform(coarser, values.begin(), figure);
        error += factor * load::grid_difference(figure(losses), values);
    };
    for (std::size_t i = 0; i < losses.efficiency.size(); ++i)
        // the parts that grids change: their sum may agree by chance
        for (double EfficiencyRow::*const part : {&EfficiencyRow::flanks, &EfficiencyRow::bearing_load})
            add(losses.efficiency[i].input_torque_error,
                [i, part](RunLosses const& each) { return each.efficiency[i].*part; });
    add(losses.starting_torque_error, [](RunLosses const& each) { return each.starting_torque; });
    double const largest = losses.efficiency.back().torque;
    if (losses.back_driving)
        add(losses.back_driving_error,
            [largest](RunLosses const& each) { return each.back_driving.value_or(largest); });
    add(losses.ball_load_error, [](RunLosses const& each) { return each.ball_load; });
    add(losses.largest_sliding_error, [](RunLosses const& each) { return each.largest_sliding; });
}

/// The drive under each of @p torques at @ref loss_positions even positions over a tooth pitch; nothing where no
/// position has balances.
std::vector<LoadedRun> runs_under(std::vector<double> const& torques, TurningDrive const& drive,
                                  RunningMotion const& motion, SequenceObserver const& observer)
{
    std::vector<LoadedRun> runs;
    std::vector<double> spline_torques;
    for (double const torque : torques) {
        runs.push_back({torque, {}, 0});
        spline_torques.push_back(motion.spline_torque(torque));
    }
    double found = 0;
    for (double const pitches : tooth_pitch_plan(loss_positions).pitches) {
        if (observer.is_stopped()) {
            if (observer.on_missing)
                observer.on_missing("stopped before all losses were known");
            break;
        }
        try {
            std::vector<Balance> balances = drive.balances(pitches, spline_torques, nullptr);
            ++found;
            for (std::size_t i = 0; i < balances.size(); ++i) {
                runs[i].sliding.push_back({std::move(balances[i].sliding)});
                runs[i].ball_load += balances[i].ball_load;
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
    for (LoadedRun& run : runs) {
        run.ball_load /= found;
        for (WeighedContacts& each : run.sliding)
            each.weight = 1 / found;
    }
    return runs;
}

/// Width of the interval of the torques of @p runs, in order of size, in which @p torque lies [N mm].
double interval_about(std::vector<LoadedRun> const& runs, double torque)
{
    auto const after = std::ranges::lower_bound(runs, torque, {}, &LoadedRun::torque);
    return after == runs.begin() || after == runs.end() ? 0 : after->torque - std::prev(after)->torque;
}

}  // namespace

std::vector<LoadedRun> LossRuns::with_between() const
{
    std::vector<LoadedRun> all = asked;
    all.insert(all.end(), between.begin(), between.end());
    std::ranges::stable_sort(all, {}, &LoadedRun::torque);
    return all;
}

LossRuns loss_runs(LossModel const& model, TurningDrive const& drive, RunTask const& task,
                   SequenceObserver const& observer)
{
    LossRuns runs;
    std::vector<LoadedRun> loaded = runs_under(task.torques, drive, model.motion, observer);
    if (loaded.empty())
        return runs;
    runs.asked = {{0, {}, drive.assembled_ball_load()}};
    std::ranges::move(loaded, std::back_inserter(runs.asked));
    constexpr int most = 8;
    constexpr double enough = 1e-3;  // of the torque
    SequenceObserver const unseen{observer.stop, {}, {}};
    std::optional<double> now = back_driving_torque(model, runs.asked);
    runs.unsettled = now ? interval_about(runs.asked, *now) : 0;
    for (int i = 0; i < most && now && *now > 0; ++i) {
        std::vector<LoadedRun> added = runs_under({*now}, drive, model.motion, unseen);
        if (added.empty())
            break;
        runs.between.push_back(std::move(added.front()));
        std::optional<double> const next = back_driving_torque(model, runs.with_between());
        runs.unsettled = std::abs(next.value_or(*now) - *now);
        now = next;
        if (now && runs.unsettled <= enough * *now)
            break;
    }
    return runs;
}

LossRuns loss_runs_like(LossRuns const& like, TurningDrive const& drive, RunTask const& task,
                        SequenceObserver const& observer)
{
    SequenceObserver const silent = observer.silent(), unseen{observer.stop, {}, {}};
    LossRuns runs{{{0, {}, drive.assembled_ball_load()}}, {}, 0};
    std::vector<LoadedRun> loaded = runs_under(task.torques, drive, task.motion, silent);
    std::ranges::move(loaded, std::back_inserter(runs.asked));
    for (LoadedRun const& each : like.between)
        std::ranges::move(runs_under({each.torque}, drive, task.motion, unseen), std::back_inserter(runs.between));
    return runs;
}

RunLosses run_losses(LossModel const& model, RunTask const& task, LossRuns const& runs,
                     std::vector<LossRuns> const& coarser, double safety)
{
    RunLosses losses = losses_of(model, task, runs);
    std::vector<RunLosses> others;
    for (LossRuns const& each : coarser)
        if (each.asked.size() == runs.asked.size())
            others.push_back(losses_of(model, task, each));
    losses.estimated = !others.empty();
    if (losses.estimated) {
        add_errors(others, of_losses * safety, losses);
        losses.largest_sliding_error *= of_extreme;
        add_errors({losses_of(model, task, {every_second(runs.asked), every_second(runs.between), 0})}, 1, losses);
        losses.back_driving_error += runs.unsettled;
        for (EfficiencyRow& row : losses.efficiency)
            if (row.input_torque != 0)
                row.efficiency_error = row.efficiency * row.input_torque_error / row.input_torque;
    }
    return losses;
}

}  // namespace hdconj::running
