// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj export: the elastic cup for other programs.
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/cup_files.hpp"
#include "hdconj/pipeline/elastic_cup.hpp"
#include "hdconj/scene/fault.hpp"
#include "outputs.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

struct ExportOptions
{
    std::string calculix;  ///< folder; empty: none
    std::string vtu;       ///< file; empty: none
    int steps = 48;
    bool contact = false;
};

/// What the contact deck has no elements for.
void refuse_contact(BearingChoice const& bearing)
{
    if (bearing.radial_stiffness) {
        throw InputError(Fault{"bearing.radial_stiffness", bearing.line, "", "in the contact deck the balls are rigid", "remove the key, or leave --contact out"});
    }
    if (bearing.balls) {
        throw InputError(Fault{"bearing.balls", bearing.line, "", "in the contact deck the balls are a line", "remove the key, or leave --contact out"});
    }
    if (bearing.width <= 0) {
        throw InputError(Fault{"bearing.width", bearing.line, "", "in the contact deck the bearing is a body, and has a width", "write width = 6.0, or leave --contact out"});
    }
}

int run_export(CommonOptions const& common, ExportOptions const& own)
{
    if (own.calculix.empty() && own.vtu.empty()) {
        throw InputError(Fault{"export", 0, "", "nothing is asked for", "write --calculix DIR or --vtu FILE"});
    }
    if (own.contact && own.calculix.empty()) {
        throw InputError(Fault{"--contact", 0, "", "is a deck for CalculiX", "write --calculix DIR too"});
    }
    Scene const scene = load_scene(common);
    if (own.contact && scene.bearing) {
        refuse_contact(*scene.bearing);
    }
    std::vector<OutputJob> jobs;
    if (!own.calculix.empty()) {
        jobs.push_back({"calculix", "--calculix", own.calculix, [&own] { check_calculix(own.calculix); }});
        jobs.back().is_folder = true;
    }
    if (!own.vtu.empty()) {
        jobs.push_back({"vtu", "--vtu", own.vtu, [&own] { check_target(own.vtu); }});
    }
    check_outputs(jobs, inputs_of(common, scene));
    auto const cup = elastic_cup(scene);
    if (!own.calculix.empty()) {
        write_calculix(*cup, own.calculix, own.steps, own.contact);
    }
    if (!own.vtu.empty()) {
        write_vtu(*cup, own.vtu, 2 * own.steps);
    }
    if (!common.quiet && !common.json) {
        std::cout << describe(*cup, elastic_cup_error(scene, *cup)) << '\n';
        for (auto const& name : {own.calculix, own.vtu}) {
            std::cout << (name.empty() ? "" : name + "\n");
        }
    }
    return exit_done;
}

}  // namespace

void add_export(CLI::App& program, CommonOptions& common)
{
    auto* const verb = program.add_subcommand("export", "the elastic cup for CalculiX and ParaView");
    auto const own = std::make_shared<ExportOptions>();
    add_scene_options(*verb, common);
    verb->add_option("--calculix", own->calculix, "folder for a CalculiX deck of the cup under its bearing's forces, and what it must come to")->check(name_fault);
    verb->add_flag("--contact", own->contact, "with --calculix: a second deck, cup and bearing as two bodies in contact");
    verb->add_option("--vtu", own->vtu, "file for ParaView: the cup with displacements and stress")->check(name_fault);
    verb->add_option("--steps", own->steps, "elements round half a lobe (deck), and twice as many round the whole (vtu) [48]")->check(CLI::Range(4, 720));
    verb->footer("The scene needs [coning] model = \"elastic\".\n"
                 "Examples:\n"
                 "  hdconj export type-50-elastic.toml --calculix deck && cd deck && ccx linear\n"
                 "  hdconj export type-50-elastic.toml --calculix deck --contact --steps 16 && cd deck && ccx contact\n"
                 "  hdconj export type-50-elastic.toml --vtu cup.vtu\n"
                 "Exit status: 0 done, 1 failed, 2 bad scene or bad command line.");
    verb->callback([&common, own] { common.action = [&common, own] { return run_export(common, *own); }; });
}

}  // namespace hdconj::cli
