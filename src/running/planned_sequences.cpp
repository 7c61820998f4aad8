// SPDX-License-Identifier: GPL-3.0-or-later
#include "planned_sequences.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hdconj::running {
namespace {

/// Which rings of teeth have errors that differ from tooth to tooth.
struct RingsWithErrors
{
    explicit RingsWithErrors(Scene const& scene, RunningMotion const& motion)
    {
        bool const cup = scene.errors && scene.errors->flexspline,
                   spline = scene.errors && scene.errors->circular_spline;
        held = motion.turns_cup() ? spline : cup;
        turning = motion.turns_cup() ? cup : spline;
    }
    bool held = false, turning = false;
};

}  // namespace

std::vector<PlannedSequence> planned_sequences(Scene const& scene, RunTask const& task)
{
    constexpr int fewest_balances = 32, first_contacts_each = 16, positions_per_turn = 16;
    RingsWithErrors const rings(scene, task.motion);
    bool const elastic = task.torque > 0;
    int const held = task.motion.held_teeth(), turning = task.motion.turning_teeth();
    std::vector<PlannedSequence> sequences;
    auto const add = [&](RunSpan span, int period, int positions, bool under_torque) {
        SpanPlan plan = whole_pitch_plan(span, period, positions);
        plan.closed = span == RunSpan::output_turn || !(rings.held && rings.turning);
        sequences.push_back({std::move(plan), under_torque});
    };
    SpanPlan pitch = tooth_pitch_plan(task.positions);
    pitch.repeats = !rings.held && !rings.turning;
    sequences.push_back({pitch, false});
    if (elastic)
        sequences.push_back({pitch, true});
    if (rings.held || rings.turning) {
        int const period = rings.held ? held : turning;
        add(RunSpan::input_turn, period, first_contacts_each * task.positions, false);
        if (elastic)
            add(RunSpan::input_turn, period, std::max(fewest_balances, task.positions), true);
    }
    if (rings.held && rings.turning) {
        int const period = std::lcm(held, turning);
        add(RunSpan::output_turn, period, period / held * positions_per_turn, false);
    }
    return sequences;
}

}  // namespace hdconj::running
