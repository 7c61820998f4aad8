// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/plan.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"

namespace hdconj {
namespace {

std::string in_mm(double value)
{
    return number_text(value) + " mm";
}

std::vector<PlannedStage> base_stages(Scene const& scene)
{
    std::string const tooth = scene.is_reverse() ? "circular_spline.profile" : "flexspline.profile";
    std::string const swept = scene.is_reverse() ? "circular-spline" : "flexspline";
    std::string const solved = scene.is_reverse() ? "always: the flexspline tooth that no circular-spline tooth enters"
                                                  : "always: the space that no flexspline tooth enters from outside";
    std::string const elastic = "coning.model = \"elastic\": displacements of the cup";
    std::vector<PlannedStage> stages{{Stage::profile, tooth + ".family = " + in_quotes(scene.given_profile().family)}};
    if (scene.is_elastic() && scene.bearing) {
        stages.push_back({Stage::cup, std::string("coning.model = \"elastic\", bearing.type = ") +
                                          (scene.bearing->elastic ? "\"elastic\"" : "\"rigid\"")});
    }
    for (PlannedStage const& stage : std::vector<PlannedStage>{
             {Stage::neutral_curve, "wave_generator.family = " + in_quotes(scene.wave_generator.shape.family) +
                                        ", waves = " + std::to_string(scene.wave_generator.waves)},
             {Stage::motion, scene.is_elastic()
                                 ? elastic + " (solver.kinematics is not asked)"
                                 : "solver.kinematics = " + in_quotes(to_string(scene.solver.kinematics))},
             {Stage::envelope, "always: where the " + swept + " tooth can touch"},
             {Stage::region, solved}}) {
        stages.push_back(stage);
    }
    return stages;
}

bool has_slices(Scene const& scene)
{
    return scene.slices && scene.slices->count > 1;
}

/// Whether slices need motions of their own.
bool cones(Scene const& scene, Verb verb)
{
    bool const own_outlines = has_slices(scene) && scene.slices->surface != ToothSurface::tilted;
    return scene.coning &&
           (verb != Verb::solve || own_outlines || (scene.circular_spline.automatic_backlash && has_slices(scene)));
}

std::vector<AbsentEffect> absent_effects(Scene const& scene, Verb verb)
{
    std::vector<AbsentEffect> absent;
    if (scene.circular_spline.backlash_offset <= 0 && !scene.circular_spline.automatic_backlash) {
        absent.push_back({"backlash", "circular_spline.backlash_offset above 0"});
    }
    if (scene.circular_spline.root_clearance <= 0 && !scene.is_reverse()) {
        absent.push_back({"root clearance", "circular_spline.root_clearance above 0"});
    }
    if (!scene.coning) {
        absent.push_back({"coning", "a table [coning]"});
    }
    if (!scene.tilt) {
        absent.push_back({"tilt", "a table [tilt]"});
    }
    if (!scene.slices) {
        absent.push_back({"slices", "a table [slices]"});
    }
    if (scene.is_elastic() && !cones(scene, verb)) {
        absent.push_back(
            {"coning of the surface",
             "[slices] with surface \"ruled\" or \"per-slice\", or the verb contact: one outline is that of z = 0"});
    } else if (scene.coning && !cones(scene, verb)) {
        absent.push_back({"coning of the surface",
                          "[slices] with surface \"ruled\" or \"per-slice\", or the verb contact: one outline is that "
                          "of z = 0, which the cone leaves as it is"});
    }
    if (scene.tilt && !has_slices(scene)) {
        absent.push_back({"tilt of the surface", "[slices] with count above 1: at z = 0 the tilt moves nothing"});
    }
    if (verb != Verb::contact) {
        absent.push_back({"contact", "the verb contact"});
    }
    if (verb != Verb::load) {
        absent.push_back({"load", "the verb load"});
    }
    return absent;
}

std::size_t widest(std::vector<std::string> const& texts)
{
    std::size_t width = 0;
    for (auto const& text : texts)
        width = std::max(width, text.size());
    return width;
}

/// Two columns; an empty string for no rows.
std::string in_columns(std::vector<std::string> const& left, std::vector<std::string> const& right)
{
    std::size_t const width = widest(left) + 2;
    std::string text;
    for (std::size_t i = 0; i < left.size(); ++i)
        text += "  " + left[i] + std::string(width - left[i].size(), ' ') + right[i] + "\n";
    return text;
}

}  // namespace

bool Plan::has(Stage stage) const
{
    return std::any_of(stages.begin(), stages.end(),
                       [stage](PlannedStage const& planned) { return planned.stage == stage; });
}

std::string to_string(Stage stage)
{
    switch (stage) {
        case Stage::profile:
            return "profile";
        case Stage::cup:
            return "cup";
        case Stage::neutral_curve:
            return "neutral_curve";
        case Stage::motion:
            return "motion";
        case Stage::envelope:
            return "envelope";
        case Stage::region:
            return "region";
        case Stage::backlash:
            return "backlash";
        case Stage::root_clearance:
            return "root_clearance";
        case Stage::outline:
            return "outline";
        case Stage::interference:
            return "interference";
        case Stage::coning:
            return "coning";
        case Stage::surface:
            return "surface";
        case Stage::tilt:
            return "tilt";
        case Stage::clearance:
            return "clearance";
        case Stage::gap_map:
            return "gap_map";
        case Stage::contact:
            return "contact";
        case Stage::influence:
            return "influence";
        case Stage::assembly:
            return "assembly";
        case Stage::load:
            return "load";
    }
    return "unknown";
}

Plan make_plan(Scene const& scene, Verb verb)
{
    Plan plan{base_stages(scene), absent_effects(scene, verb)};
    auto const& spline = scene.circular_spline;
    if (spline.backlash_offset > 0) {
        plan.stages.push_back({Stage::backlash, "circular_spline.backlash_offset = " + in_mm(spline.backlash_offset)});
    }
    plan.stages.push_back({Stage::outline, "solver.tolerance = " + in_mm(scene.solver.tolerance)});
    if (spline.root_clearance > 0) {
        plan.stages.push_back(
            {Stage::root_clearance, "circular_spline.root_clearance = " + in_mm(spline.root_clearance)});
    }
    plan.stages.push_back({Stage::interference, "always: the finished pair over a full turn"});
    if (cones(scene, verb)) {
        plan.stages.push_back({Stage::coning, "coning.model = " + in_quotes(to_string(scene.coning->model))});
    }
    if (has_slices(scene)) {
        plan.stages.push_back({Stage::surface, "slices.count = " + std::to_string(scene.slices->count) +
                                                   ", surface = " + in_quotes(to_string(scene.slices->surface))});
    } else if (verb != Verb::solve) {
        plan.stages.push_back(
            {Stage::surface, verb == Verb::contact ? "contact: points of both flanks" : "load: points of both flanks"});
    }
    if (scene.tilt && has_slices(scene)) {
        plan.stages.push_back({Stage::tilt, "tilt.angle_deg = " + number_text(scene.tilt->angle / deg) +
                                                ", kind = " + in_quotes(to_string(scene.tilt->kind))});
    }
    if (verb != Verb::solve || spline.automatic_backlash) {
        plan.stages.push_back(
            {Stage::clearance, spline.automatic_backlash ? "circular_spline.backlash_offset = \"auto\""
                               : verb == Verb::contact
                                   ? "contact: every slice over a full turn"
                                   : "load: side clearance, if the scene's leaves the assembled teeth none"});
    }
    if (verb == Verb::contact) {
        plan.stages.push_back({Stage::gap_map, "contact: gaps of all teeth"});
        plan.stages.push_back({Stage::contact, "contact: first touch, area, play"});
    }
    if (verb == Verb::load) {
        plan.stages.push_back({Stage::influence, "load: the wall gives way"});
        plan.stages.push_back({Stage::assembly, "load: the wave generator presses where it touches"});
        plan.stages.push_back({Stage::load, "load: torque on the teeth"});
    }
    return plan;
}

std::string describe(Plan const& plan)
{
    std::vector<std::string> names;
    std::vector<std::string> reasons;
    for (auto const& planned : plan.stages) {
        names.push_back(to_string(planned.stage));
        reasons.push_back(planned.reason);
    }
    std::string text = "will be computed, in this order:\n" + in_columns(names, reasons);
    names.clear();
    reasons.clear();
    for (auto const& effect : plan.absent) {
        names.push_back(effect.name);
        reasons.push_back(effect.remedy);
    }
    return names.empty() ? text : text + "absent, and what turns it on:\n" + in_columns(names, reasons);
}

}  // namespace hdconj
