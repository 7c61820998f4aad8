// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/plan.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

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
    std::string const solved = scene.is_reverse() ? "always: the largest flexspline tooth without interference"
                                                  : "always: the space that the flexspline's teeth sweep";
    std::string const elastic = "coning.model = \"elastic\": displacements of the cup";
    std::vector<PlannedStage> stages{{Stage::profile, tooth + ".family = " + in_quotes(scene.given_profile().family)}};
    if (scene.is_elastic() && scene.bearing)
        stages.push_back({Stage::cup, std::string("coning.model = \"elastic\", bearing.type = ") +
                                          (scene.bearing->elastic ? "\"elastic\"" : "\"rigid\"")});
    std::vector<PlannedStage> const always{
        {Stage::neutral_curve, "wave_generator.family = " + in_quotes(scene.wave_generator.shape.family) +
                                   ", waves = " + std::to_string(scene.wave_generator.waves)},
        {Stage::motion, scene.is_elastic() ? elastic + " (solver.kinematics has no effect)"
                                           : "solver.kinematics = " + in_quotes(to_string(scene.solver.kinematics))},
        {Stage::envelope, "always: where the " + swept + " tooth can touch"},
        {Stage::region, solved}};
    stages.insert(stages.end(), always.begin(), always.end());
    return stages;
}

bool has_slices(Scene const& scene)
{
    return scene.slices && scene.slices->count > 1;
}

/// Stages that look for the neutral curve between both teeth.
Plan wanted_plan(Scene const& scene)
{
    return {
        {{Stage::profile, "flexspline.profile.family = " + in_quotes(scene.flexspline.profile.family) +
                              ", circular_spline.profile.family = " + in_quotes(scene.circular_spline.profile->family)},
         {Stage::neutral_curve, "wave_generator.family = \"wanted\": where both flanks touch, solver.kinematics = " +
                                    in_quotes(to_string(scene.solver.kinematics))},
         {Stage::interference, "always: both teeth on the closed curve over a full turn"}},
        {}};
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
    auto const add = [&absent](bool is_absent, char const* name, std::string_view remedy) {
        if (is_absent)
            absent.push_back({name, std::string(remedy)});
    };
    auto const& spline = scene.circular_spline;
    add(spline.backlash_offset <= 0 && !spline.automatic_backlash, "backlash",
        "circular_spline.backlash_offset above 0");
    add(spline.root_clearance <= 0 && !scene.is_reverse(), "root clearance", "circular_spline.root_clearance above 0");
    add(!scene.coning, "coning", "a table [coning]");
    add(!scene.tilt, "tilt", "a table [tilt]");
    add(!scene.slices, "slices", "a table [slices]");
    add(scene.coning && !cones(scene, verb), "coning of the surface",
        scene.is_elastic()
            ? "[slices] with surface \"ruled\" or \"per-slice\", or the verb contact: one outline is that of z = 0"
            : "[slices] with surface \"ruled\" or \"per-slice\", or the verb contact: one outline is that of z = 0, "
              "where coning changes nothing");
    add(scene.tilt && !has_slices(scene), "tilt of the surface",
        "[slices] with count above 1: at z = 0 the tilt moves nothing");
    if (verb == Verb::load) {
        add(!scene.compliance, "members in series", "a table [compliance]");
        add(!scene.bearing || !scene.bearing->ball_diameter, "yielding balls",
            "bearing.ball_diameter, with bearing.balls");
        add(!scene.bearing || scene.bearing->clearance <= 0, "bearing clearance", "bearing.clearance above 0");
    }
    // what the verbs load and run alone read
    auto const add_for_load = [&](bool is_there, char const* name, char const* table) {
        add((verb == Verb::load) != is_there, name, is_there ? "the verbs load and run" : table);
    };
    add_for_load(scene.tip_relief.has_value(), "tip relief", "a table [tip_relief]");
    add_for_load(scene.end_relief.has_value(), "end relief", "a table [end_relief]");
    add_for_load(scene.flow.has_value(), "flow of the flanks", "a table [flow]");
    add_for_load(scene.errors.has_value(), "errors", "a table [errors]");
    add(verb != Verb::contact, "contact", "the verb contact");
    add(verb != Verb::load, "load", "the verb load");
    return absent;
}

/// What the bearing does beside pushing.
std::string bearing_effects(Scene const& scene)
{
    if (!scene.bearing)
        return "";
    BearingChoice const& bearing = *scene.bearing;
    return (bearing.ball_diameter ? ", bearing.ball_diameter = " + in_mm(*bearing.ball_diameter) : "") +
           (bearing.clearance > 0 ? ", bearing.clearance = " + in_mm(bearing.clearance) : "");
}

/// The keys that [compliance] has.
std::string members_in_series(Compliance const& compliance)
{
    std::string keys;
    for (auto const& [key, given] :
         {std::pair("flange", compliance.flange.has_value()), std::pair("hub", compliance.hub.has_value()),
          std::pair("shaft", compliance.shaft.has_value()),
          std::pair("outer_radius", compliance.outer_radius.has_value())})
        if (given)
            keys += (keys.empty() ? "compliance." : ", ") + std::string(key);
    return keys;
}

/// Which profile errors a table gives, each after a comma.
std::string profile_reason(double slope, scene::NumberRows const& form)
{
    return (slope != 0 ? ", profile_slope = " + in_mm(slope) : "") +
           (!form.empty() ? ", profile_form of " + std::to_string(form.size()) + " rows" : "");
}

/// Which errors there are.
std::string errors_reason(Errors const& errors)
{
    std::string text =
        "errors.seed = " + std::to_string(errors.seed) + profile_reason(errors.profile_slope, errors.profile_form);
    auto const add = [&](std::string const& ring, std::optional<RingErrors> const& of) {
        if (!of)
            return;
        text += "; " + ring + ": " +
                (of->pitch.empty() ? "pitch_deviation = " + in_mm(of->pitch_deviation) : "pitch of each tooth") +
                ", eccentricity = " + in_mm(of->eccentricity) + ", wobble_deg = " + number_text(to_deg(of->wobble)) +
                profile_reason(of->profile_slope, of->profile_form);
    };
    add("flexspline", errors.flexspline);
    add("circular_spline", errors.circular_spline);
    if (auto const& cam = errors.wave_generator)
        text +=
            "; wave_generator: eccentricity = " + in_mm(cam->eccentricity) +
            (cam->cam_deviation.empty() ? ""
                                        : ", cam_deviation of " + std::to_string(cam->cam_deviation.size()) + " rows");
    return text;
}

/// Two columns; an empty string for no rows.
std::string in_columns(std::vector<std::pair<std::string, std::string>> const& rows)
{
    std::size_t width = 0;
    for (auto const& [left, right] : rows)
        width = std::max(width, left.size());
    std::string text;
    for (auto const& [left, right] : rows)
        text += "  " + left + std::string(width + 2 - left.size(), ' ') + right + "\n";
    return text;
}

}  // namespace

bool Plan::has(Stage stage) const
{
    return std::ranges::find(stages, stage, &PlannedStage::stage) != stages.end();
}

std::string to_string(Stage stage)
{
    constexpr std::array names{"profile",  "cup",        "neutral_curve",  "motion",    "envelope",
                               "region",   "backlash",   "root_clearance", "outline",   "interference",
                               "coning",   "surface",    "tilt",           "clearance", "gap_map",
                               "contact",  "tip_relief", "end_relief",     "errors",    "influence",
                               "assembly", "compliance", "load",           "run"};
    return names.at(static_cast<std::size_t>(stage));
}

Plan make_plan(Scene const& scene, Verb verb)
{
    if (scene.wants_neutral_curve())
        return wanted_plan(scene);
    Plan plan{base_stages(scene), absent_effects(scene, verb)};
    auto const add = [&plan](Stage stage, std::string reason) { plan.stages.push_back({stage, std::move(reason)}); };
    auto const& spline = scene.circular_spline;
    if (spline.backlash_offset > 0)
        add(Stage::backlash, "circular_spline.backlash_offset = " + in_mm(spline.backlash_offset));
    add(Stage::outline, "solver.tolerance = " + in_mm(scene.solver.tolerance));
    if (spline.root_clearance > 0)
        add(Stage::root_clearance, "circular_spline.root_clearance = " + in_mm(spline.root_clearance));
    add(Stage::interference, "always: the finished pair over a full turn");
    if (cones(scene, verb))
        add(Stage::coning, "coning.model = " + in_quotes(to_string(scene.coning->model)));
    if (has_slices(scene)) {
        add(Stage::surface, "slices.count = " + std::to_string(scene.slices->count) +
                                ", surface = " + in_quotes(to_string(scene.slices->surface)));
    } else if (verb != Verb::solve) {
        add(Stage::surface, verb == Verb::contact ? "contact: points of both flanks" : "load: points of both flanks");
    }
    if (scene.tilt && has_slices(scene))
        add(Stage::tilt, "tilt.angle_deg = " + number_text(scene.tilt->angle / deg) +
                             ", kind = " + in_quotes(to_string(scene.tilt->kind)));
    if (verb != Verb::solve || spline.automatic_backlash)
        add(Stage::clearance, spline.automatic_backlash ? "circular_spline.backlash_offset = \"auto\""
                              : verb == Verb::contact
                                  ? "contact: every slice over a full turn"
                                  : "load: more side clearance where the assembled teeth would interfere");
    if (verb == Verb::contact) {
        add(Stage::gap_map, "contact: gaps of all teeth");
        add(Stage::contact, "contact: first contact, contact area, backlash");
    }
    if (verb == Verb::load) {
        if (scene.tip_relief)
            add(Stage::tip_relief, "tip_relief.amount = " + in_mm(scene.tip_relief->amount) +
                                       ", from_height = " + in_mm(scene.tip_relief->from_height));
        if (scene.end_relief)
            add(Stage::end_relief, "end_relief.amount = " + in_mm(scene.end_relief->amount) +
                                       ", length = " + in_mm(scene.end_relief->length));
        if (scene.errors)
            add(Stage::errors, errors_reason(*scene.errors));
        add(Stage::influence, "load: deformation of the cup by unit forces");
        add(Stage::assembly, "load: the cup on its wave generator, without torque" + bearing_effects(scene));
        if (scene.compliance)
            add(Stage::compliance, members_in_series(*scene.compliance) + ": in series with the teeth");
        add(Stage::load, "load: torque on the teeth" +
                             (scene.flow ? ", flow.pressure = " + number_text(scene.flow->pressure) + " MPa" : ""));
    }
    return plan;
}

std::string describe(Plan const& plan)
{
    std::vector<std::pair<std::string, std::string>> stages, absent;
    for (auto const& planned : plan.stages)
        stages.emplace_back(to_string(planned.stage), planned.reason);
    for (auto const& effect : plan.absent)
        absent.emplace_back(effect.name, effect.remedy);
    return "will be computed, in this order:\n" + in_columns(stages) +
           (absent.empty() ? "" : "absent, and what turns it on:\n" + in_columns(absent));
}

}  // namespace hdconj
