// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `export`: the elastic cup for other programs.
#include "arguments.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/mesh_files.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

struct ExportArguments
{
    std::string calculix;  ///< folder
    std::string vtu;
    int steps = 48;
    bool contact = false;
};

/// Elements round half a lobe below which CalculiX's test for convergence, that the number of closed contact points no
/// longer changes, is met by chance.
constexpr int fewest_contact_steps = 12;

/// What the contact deck has no elements for.
void refuse_contact(BearingChoice const& bearing)
{
    auto const refuse_key = [&](std::string const& key, std::string const& reason, std::string const& remedy) {
        throw InputError(Fault{"bearing." + key, bearing.line, "", "in the contact deck " + reason,
                               remedy + ", or leave --contact out"});
    };
    if (bearing.radial_stiffness)
        refuse_key("radial_stiffness", "the balls are rigid", "remove the key");
    if (bearing.balls)
        refuse_key("balls", "the balls are a line", "remove the key");
    if (bearing.width <= 0)
        refuse_key("width", "the bearing is a body, and has a width", "write width = 6.0");
}

int run_export(CommonOptions const& common, ExportArguments const& own)
{
    if (own.calculix.empty() && own.vtu.empty())
        throw InputError(Fault{"export", 0, "", "nothing is asked for", "write --calculix DIR or --vtu FILE"});
    if (own.contact && own.calculix.empty())
        throw InputError(Fault{"--contact", 0, "", "is a deck for CalculiX", "write --calculix DIR too"});
    if (own.contact && own.steps < fewest_contact_steps)
        throw InputError(Fault{"--steps", 0, std::to_string(own.steps),
                               "with few contact points CalculiX may end in a state in which some still change between "
                               "open and closed",
                               "write --steps 24, or at least " + std::to_string(fewest_contact_steps)});
    Scene const scene = loaded_scene(load_drive(common));
    if (own.contact && scene.bearing)
        refuse_contact(*scene.bearing);
    using Cup = decltype(elastic_cup(scene));
    Work<Cup> work;
    work.inputs = inputs_of(common, scene);
    add_file(
        work, "calculix", "--calculix", own.calculix,
        [&](Cup const& cup, std::filesystem::path const& folder) {
            write_calculix(*cup, folder, own.steps, own.contact);
        },
        check_calculix);
    if (!own.calculix.empty())
        work.outputs.back().target.is_folder = true;
    add_file(
        work, "vtu", "--vtu", own.vtu,
        [&](Cup const& cup, std::filesystem::path const& file) { write_vtu(*cup, file, 2 * own.steps); },
        check_ending("--vtu", ".vtu", "ParaView"));
    work.compute = [&](ProgressLine const&) { return elastic_cup(scene); };
    work.text = [&](Cup const& cup, Written const& written) {
        std::string text = describe(*cup, elastic_cup_error(scene, *cup)) + '\n';
        for (auto const& name : names_of(written))
            text += name + '\n';
        return text;
    };
    work.json = [&](Cup const& cup, Written const& written) {
        return summary_json(*cup, elastic_cup_error(scene, *cup), written);
    };
    return run_verb(common, work);
}

}  // namespace

void add_export(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] = add_verb(program, common, "export", "the elastic cup for CalculiX and ParaView", run_export);
    add_scene_options(verb, common);
    add_name(verb, "--calculix", own.calculix,
             "folder for a CalculiX deck of the cup under its bearing's forces, and what it must come to");
    verb.add_flag("--contact", own.contact, "with --calculix: a second deck, cup and bearing as two bodies in contact");
    add_name(verb, "--vtu", own.vtu, "file for ParaView: the cup with displacements and stress");
    verb.add_option("--steps", own.steps,
                    "elements round half a lobe (deck; at least 12 with --contact), and twice as many round the whole "
                    "(vtu) [48]")
        ->check(whole_number(4, 720));
    verb.footer(
        "A scene without [coning] has an elastic cup whose teeth stand in the middle of the bearing, as in load.\n"
        "Examples:\n"
        "  hdconj export --calculix deck && cd deck && ccx linear && python3 compare.py linear\n"
        "  hdconj export --calculix deck --contact --steps 24 && cd deck && ccx contact && python3 compare.py contact\n"
        "  hdconj export drive.toml --vtu cup.vtu\n"
        "Exit status: 0 done, 1 failed, 2 bad scene or bad command line.");
}

}  // namespace hdconj::cli
