// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `check`: what is wrong with a scene, or what will be computed of it and why.
#include <fmt/format.h>

#include "hdconj/judgement.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "hdconj/wire_files.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

struct CheckArguments
{
    bool only_plan = false;
    std::string verb;  ///< empty: as the scene says
};

std::string headline(Scene const& scene)
{
    auto const& drive = scene.drive;
    return fmt::format("{}: module {:g} mm, {} and {} teeth, {} waves\n", drive.name, drive.module,
                       drive.flexspline_teeth, drive.circular_spline_teeth, scene.wave_generator.waves);
}

/// A scene with a table [contact] is meant for `contact`.
std::string usual_verb(Scene const& scene)
{
    return scene.contact && !scene.wants_neutral_curve() ? "contact" : "solve";
}

int run_check(CommonOptions const& common, CheckArguments const& own)
{
    auto reading = examine(common);
    if (reading.scene.wedm)
        append(reading.faults, check_named_dialects(reading.scene));
    refuse(std::move(reading.faults));
    // the limits of a design are those of a neutral curve that is known
    Notes const notes = reading.scene.wants_neutral_curve() ? Notes{} : judge(reading.scene);
    Work<Plan> work;
    work.compute = [&](ProgressLine const&) {
        return plan_of(reading.scene, own.verb.empty() ? usual_verb(reading.scene) : own.verb, "--for");
    };
    work.text = [&](Plan const& plan, Written const&) {
        return own.only_plan ? describe(plan) : headline(reading.scene) + describe(plan) + describe(notes);
    };
    work.json = [&](Plan const& plan, Written const&) {
        return check_json(scene_name(common), {}, &plan, notes) + '\n';
    };
    work.judgement = [&](Plan const&) { return notes; };
    return run_verb(common, work);
}

std::string families_text(std::string const& key, std::vector<scene::FamilyDescription> const& families)
{
    std::string text = key + ":\n";
    for (auto const& family : families)
        text += fmt::format("  \"{}\"  {}\n", family.name, family.meaning);
    return text;
}

}  // namespace

void add_check(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "check", "validate a scene and print what will be computed, and why", run_check);
    add_scene_options(verb, common);
    add_strict(verb, common);
    verb.add_flag("--plan", own.only_plan, "print the plan and nothing else");
    verb.add_option("--for", own.verb,
                    "the verb to plan for [contact where the scene has a table [contact], else solve]")
        ->check(CLI::IsMember({"solve", "contact", "load", "run"}));
    verb.footer("Families:\n" + families_text("flexspline.profile.family", profile::profile_families()) +
                families_text("wave_generator.family", wavegen::wave_generator_families()) +
                "Examples:\n"
                "  hdconj check drive.toml\n"
                "  hdconj check --set solver.kinematics=first-order\n"
                "  hdconj init - | hdconj check -");
}

}  // namespace hdconj::cli
