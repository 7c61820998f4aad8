// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_scene.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/option_faults.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "load/study/loaded_scene.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj {
namespace {

/// Torque on the output; a scene's [load] means the circular spline [N mm].
double largest_torque(Scene const& scene, RunOptions const& options)
{
    if (options.torque)
        return *options.torque;
    running::RunningMotion const motion(scene.drive, scene.running.value_or(RunRequest()).output);
    return scene.load && scene.load->torque ? *scene.load->torque / motion.turn_rate() : 0;
}

LoadOptions load_options(Scene const& scene, RunOptions const& options)
{
    running::RunningMotion const motion(scene.drive, scene.running.value_or(RunRequest()).output);
    LoadOptions result;
    result.torque = motion.spline_torque(largest_torque(scene, options));
    result.curve = false;
    result.errors = options.errors;
    return result;
}

}  // namespace

std::string to_string(RunSpan span)
{
    return span == RunSpan::tooth_pitch ? "tooth_pitch" : span == RunSpan::input_turn ? "input_turn" : "output_turn";
}

Faults check_run(Scene const& scene, RunOptions const& options)
{
    double const torque = largest_torque(scene, options);
    Faults faults;
    if (torque < 0 || !std::isfinite(torque))
        faults.push_back({"--torque", 0, fmt::format("{:g}", torque / newton_metre),
                          "a drive that runs has a torque of 0 or more on its output",
                          "write a torque in N m such as --torque 28, or 0 for first contact only"});
    else if (torque > 0)
        faults = load::check_either_sense(scene, load_options(scene, options));
    else
        faults = check_contact(scene, {});
    std::string const usual = scene::usual_torque(scene.drive);
    if (torque == 0 && scene.friction && options.torque)
        faults.push_back({"friction", scene.friction->line, "", "--torque is 0, and without torque no power is lost",
                          "leave --torque out where [load] has a torque, write one above 0, or remove this table"});
    else if (torque == 0 && scene.friction)
        faults.push_back(
            {"friction", scene.friction->line, "", "nothing says under which torque the drive loses power",
             "write torque = " + usual + ", in N m, in [load], or --torque " + usual + ", or remove this table"});
    require_whole(faults, "--positions", options.positions, scene::bounds::fewest_positions,
                  scene::bounds::most_positions, "one such as 16");
    return faults;
}

Plan plan_run(Scene const& scene, RunOptions const& options)
{
    bool const elastic = largest_torque(scene, options) > 0;
    Plan plan = make_plan(elastic ? loaded_scene(scene, load_options(scene, options)) : scene, Verb::load);
    auto const is_of_load = [](PlannedStage const& each) {
        return each.stage == Stage::influence || each.stage == Stage::assembly || each.stage == Stage::compliance;
    };
    if (!elastic)
        std::erase_if(plan.stages, is_of_load);
    for (PlannedStage& each : plan.stages)
        if (each.stage == Stage::load)
            each = {Stage::run,
                    std::string("run: ") +
                        (elastic ? "first contact and balance" : "first contact in the shape that is prescribed") +
                        " at positions of the wave generator" +
                        (scene.friction ? fmt::format(", friction.flanks = {:g}", scene.friction->flanks) : "")};
    std::erase_if(plan.absent, [](AbsentEffect const& each) { return each.name == "members in series"; });
    if (!scene.friction)
        plan.absent.push_back({"friction", "a table [friction]"});
    if (!elastic)
        plan.absent.push_back({"torque", "load.torque above 0"});
    return plan;
}

namespace running {

RunTask run_task(Scene const& scene, RunOptions const& options)
{
    constexpr int standard_positions = 16;
    RunRequest const request = scene.running.value_or(RunRequest());
    RunTask task{RunningMotion(scene.drive, request.output), largest_torque(scene, options)};
    task.positions = options.positions.value_or(request.positions > 0 ? request.positions : standard_positions);
    task.torques = request.torques;
    if (task.torques.empty())
        for (double const part : {0.1, 0.25, 0.5, 1.0})
            task.torques.push_back(part * task.torque);
    std::ranges::sort(task.torques);
    task.torques.erase(std::unique(task.torques.begin(), task.torques.end()), task.torques.end());
    task.speeds = request.speeds.empty() ? std::vector{500 * rpm, 1000 * rpm, 2000 * rpm, 3500 * rpm} : request.speeds;
    task.temperatures = request.temperatures.empty() ? std::vector{40.0} : request.temperatures;
    return task;
}

Scene checked_run_scene(Scene const& scene, RunOptions const& options)
{
    throw_if_any(check_run(scene, options));
    throw_if_any(check_scene(scene));
    return largest_torque(scene, options) > 0 ? loaded_scene(scene, load_options(scene, options)) : scene;
}

}  // namespace running
}  // namespace hdconj
