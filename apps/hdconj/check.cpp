// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj check: what is wrong with a scene, or what will be computed of it and why.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "cli.hpp"
#include "hdconj/pipeline/load.hpp"
#include "hdconj/io/scene_json.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/plan.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::cli {
namespace {

struct CheckOptions
{
    bool only_plan = false;
    std::string verb;  ///< empty: as the scene says
};

void print_headline(Scene const& scene)
{
    auto const& drive = scene.drive;
    std::cout << drive.name << ": module " << drive.module << " mm, " << drive.flexspline_teeth << " and "
              << drive.circular_spline_teeth << " teeth, " << scene.wave_generator.waves << " waves\n";
}

void print_text(CommonOptions const& common, CheckOptions const& own, Scene const& scene, Plan const& plan)
{
    if (common.quiet) {
        return;
    }
    if (!own.only_plan) {
        print_headline(scene);
    }
    std::cout << describe(plan);
}

/// The verb whose plan is drawn: a scene with a table [contact] is meant for `contact`.
Verb verb_of(CheckOptions const& own, Scene const& scene)
{
    if (own.verb == "load") {
        return Verb::load;
    }
    bool const contact = own.verb.empty() ? scene.contact.has_value() : own.verb == "contact";
    return contact ? Verb::contact : Verb::solve;
}

/// Effects that are read but not computed are no fault of the scene, so the plan of the rest is printed; but `solve`
/// would refuse, and so does check.
int run_check(CommonOptions const& common, CheckOptions const& own)
{
    auto const reading = examine(common);
    bool const is_right = reading.faults.empty();
    auto const& faults = reading.faults;
    auto const verb = is_right ? verb_of(own, reading.scene) : Verb::solve;
    auto const plan = is_right ? std::optional(make_plan(verb == Verb::load ? loaded_scene(reading.scene) : reading.scene, verb)) : std::nullopt;
    if (common.json) {
        std::cout << check_json(scene_name(common), faults, plan ? &*plan : nullptr) << '\n';
    } else if (plan) {
        print_text(common, own, reading.scene, *plan);
    }
    if (!faults.empty()) {
        throw InputError(faults);
    }
    return exit_done;
}

std::string families_text(std::string const& key, std::vector<FamilyDescription> const& families)
{
    std::string text = key + ":\n";
    for (auto const& family : families) {
        text += "  \"" + std::string(family.name) + "\"  " + std::string(family.meaning) + "\n";
    }
    return text;
}

}  // namespace

void add_check(CLI::App& program, CommonOptions& common)
{
    auto* const verb = program.add_subcommand("check", "validate a scene and print what will be computed, and why");
    auto const own = std::make_shared<CheckOptions>();
    add_scene_options(*verb, common);
    verb->add_flag("--plan", own->only_plan, "print the plan and nothing else");
    verb->add_option("--for", own->verb, "the verb to plan for [contact where the scene has a table [contact], else solve]")
        ->check(CLI::IsMember({"solve", "contact", "load"}));
    verb->footer("Families:\n" + families_text("flexspline.profile.family", profile_families()) +
                 families_text("wave_generator.family", wave_generator_families()) +
                 "Examples:\n"
                 "  hdconj check drive.toml\n"
                 "  hdconj check --set solver.kinematics=first-order\n"
                 "  hdconj init - | hdconj check -");
    verb->callback([&common, own] { common.action = [&common, own] { return run_check(common, *own); }; });
}

}  // namespace hdconj::cli
