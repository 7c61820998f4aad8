// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `wedm`: from which outline, into which folder and dialects, and what is said about it.
#include "hdconj/pipeline/wedm.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>

#include "cli.hpp"
#include "hdconj/io/scene_reading.hpp"
#include "hdconj/io/stored_outline.hpp"
#include "hdconj/io/wire_files.hpp"
#include "hdconj/numeric/error.hpp"
#include "lists.hpp"
#include "outputs.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

/// What only `wedm` is asked.
struct WireOptions
{
    std::string part;                   ///< empty: as the scene says
    std::optional<double> tilt_deg;
    std::string output;                 ///< folder; empty: named after the drive
    std::string from;                   ///< result file; empty: the scene is solved
    std::vector<std::string> dialects;  ///< empty: as the scene says
    std::optional<std::string> decimals;
    std::string picture;                ///< empty: none
};

/// The words of the command line that stand for keys of the scene.
CommonOptions with_keys(CommonOptions const& common, WireOptions const& own)
{
    CommonOptions all = common;
    if (!own.part.empty()) {
        all.overrides.push_back("wedm.part=" + own.part);
    }
    if (own.tilt_deg) {
        all.overrides.push_back(fmt::format("tilt.angle_deg={}", *own.tilt_deg));
    }
    if (own.decimals) {
        all.overrides.push_back(fmt::format("wedm.decimals={}", *own.decimals));
    }
    return all;
}

/// A scene, and its outline where that was solved before.
struct Given
{
    Scene scene;
    std::optional<CircularSplineOutline> outline;
};

/// The scene of a result file is the file's own; --set may change what the wire is to do.
Given stored(CommonOptions const& common, WireOptions const& own)
{
    if (!common.scene.empty()) {
        throw InputError(Fault{"--from", 0, own.from, "a result holds its own scene, and " + scene_name(common) + " is given too",
                               "leave one of them out; --set changes keys of the table [wedm]"});
    }
    if (own.tilt_deg) {
        throw InputError(Fault{"--from", 0, own.from, "the stored outline has the tilt that it was solved with, and --tilt asks for another",
                               "leave one of them out"});
    }
    for (auto const& override : common.overrides) {
        std::string const key = override.substr(override.starts_with('!') ? 1 : 0, override.find('=') - (override.starts_with('!') ? 1 : 0));
        if (key != "wedm" && !key.starts_with("wedm.")) {
            throw InputError(Fault{"--from", 0, own.from, "the stored outline was solved with another scene than one with --set " + override,
                                   "change keys of the table [wedm] only, or leave --from out"});
        }
    }
    auto result = read_outline(own.from);
    auto reading = examine_scene(result.scene, own.from, {}, common.overrides);
    examine_geometry(reading);
    if (!reading.faults.empty()) {
        throw InputError(std::move(reading.faults));
    }
    return {std::move(reading.scene), std::move(result.outline)};
}

Given given(CommonOptions const& common, WireOptions const& own)
{
    CommonOptions const all = with_keys(common, own);
    Given found = own.from.empty() ? Given{load_scene(all), {}} : stored(all, own);
    if (Faults faults = check_wedm(found.scene); !faults.empty()) {
        throw InputError(std::move(faults));
    }
    return found;
}

std::vector<std::string> dialects_of(WireOptions const& own, Scene const& scene)
{
    if (!own.dialects.empty() || !scene.wedm) {
        return own.dialects;
    }
    std::istringstream words(scene.wedm->dialects);
    return {std::istream_iterator<std::string>(words), {}};
}

/// The flexspline is cut in two.
bool cuts_flexspline(Scene const& scene)
{
    return scene.wedm->part == WirePart::flexspline;
}

void check_targets(WireOptions const& own, fs::path const& folder, std::vector<std::string> const& dialects, Scene const& scene, std::vector<InputFile> const& read)
{
    std::string const place = own.dialects.empty() ? "wedm.dialects" : "--dialect";
    std::size_t const set_ups = cuts_flexspline(scene) ? 2 : 1;
    std::vector<OutputJob> jobs = {{"wire", "--output", folder, [&] { check_wire_files(folder, dialects, place); }}};
    jobs.back().is_folder = true;
    if (!own.picture.empty()) {
        jobs.push_back({"picture", "--picture", own.picture, [&] { check_wire_pictures(own.picture, set_ups); }});
        auto const names = wire_picture_names(own.picture, set_ups);
        jobs.back().members = names.rings;
        jobs.back().members.insert(jobs.back().members.end(), {names.tooth, names.residual});
    }
    check_outputs(jobs, read);
}

/// The wire of @p scene; of the outline @p start where it is solved.
WireSetUps programs_of(Scene const& scene, std::optional<CircularSplineOutline> const& outline, StageObserver const& on_stage)
{
    return outline && !cuts_flexspline(scene) ? WireSetUps{wire_program(scene, *outline)} : wire_set_ups(scene, on_stage);
}

/// The least of some coarser tolerances with which @p dialects hold the program; nothing where none does.
std::optional<double> fitting_tolerance(Given const& given, std::vector<std::string> const& dialects)
{
    Scene scene = given.scene;
    auto outline = given.outline;
    if (!outline && !cuts_flexspline(scene)) {
        outline = solve(wire_scene(scene)).circular_spline;
    }
    double const first = scene.wedm->tolerance;
    for (double power = 1e-6; power < scene.drive.module; power *= 10) {
        for (double const digit : {1.0, 2.0, 4.0, 6.0, 8.0}) {
            scene.wedm->tolerance = digit * power;
            if (scene.wedm->tolerance <= first || !check_wedm(scene).empty()) {
                continue;
            }
            try {
                if (unfit_dialects(programs_of(scene, outline, {}), dialects).empty()) {
                    return scene.wedm->tolerance;
                }
            } catch (std::runtime_error const&) {
                continue;  // a program that fails its checks helps nobody
            }
        }
    }
    return {};
}

/// What was asked for by name is an error; what was not is left out, and said.
void judge_unfit(Given const& given, std::vector<std::string> const& dialects, WireSetUps& programs)
{
    for (auto const& unfit : unfit_dialects(programs, dialects)) {
        if (dialects.empty()) {
            programs.front().warnings.push_back(fmt::format("dialect {} is left out: {}: {}", unfit.name, unfit.place, unfit.cause));
            continue;
        }
        auto const tolerance = fitting_tolerance(given, dialects);
        throw NumericalError("wire files", fmt::format("{}, {}", unfit.name, unfit.place),
                             unfit.cause + "; " + (tolerance ? fmt::format("write wedm.tolerance = {:g}, or another dialect", *tolerance) : "write another dialect"));
    }
}

int run_wedm(CommonOptions const& common, WireOptions const& own)
{
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes a failed write, with its reason
    Given const start = given(common, own);
    auto const dialects = dialects_of(own, start.scene);
    bool const flexspline = cuts_flexspline(start.scene);
    fs::path const folder = own.output.empty() ? fs::path(file_name(start.scene.drive.name) + (flexspline ? "-flexspline" : "") + "-wedm") : fs::path(own.output);
    auto inputs = inputs_of(common, start.scene);
    for (auto const& input : input_of("--from", own.from)) {
        inputs.push_back(input);
    }
    check_targets(own, folder, dialects, start.scene, inputs);
    Progress const progress(!common.quiet);
    WireSetUps programs = programs_of(start.scene, start.outline, [&](Stage stage) { progress.say(to_string(stage)); });
    progress.say("wire files");
    judge_unfit(start, dialects, programs);
    auto const files = write_wire_files(programs, folder, dialects);
    std::vector<WrittenFile> pictures;
    if (!own.picture.empty()) {
        progress.say("picture");
        pictures = write_wire_pictures(programs, own.picture);
    }
    progress.clear();
    if (common.json) {
        std::cout << summary_json(programs, files, folder, pictures);
    } else if (!common.quiet) {
        std::cout << summary_text(programs, files) << "\nwritten into " << folder.string() << '\n';
    }
    if (common.json && !common.quiet) {
        std::cerr << "wrote " << files.size() << " files into " << folder.string() << '\n';
    }
    for (auto const& picture : pictures) {
        if (!common.quiet) {
            std::cerr << "wrote " << picture.file.string() << '\n';
        }
    }
    return exit_done;
}

std::string dialects_text()
{
    std::string text = "Dialects:\n";
    for (auto const& dialect : wire_dialects()) {
        text += fmt::format("  {:<12}{}{}\n", dialect.name, dialect.meaning,
                            dialect.verified() ? fmt::format(" [read by: {}]", dialect.verified_by) : " [not verified on hardware]");
    }
    return text;
}

}  // namespace

void add_wedm(CLI::App& program, CommonOptions& common)
{
    auto* verb = program.add_subcommand("wedm", "coordinate files for cutting the circular spline, or the flexspline, by wire");
    add_scene_options(*verb, common);
    auto own = std::make_shared<WireOptions>();
    verb->add_option("--part", own->part, "circular-spline or flexspline, key wedm.part [the scene's, or circular-spline]")
        ->check([](std::string const& given) { return word_fault(given, {"circular-spline", "flexspline"}); })
        ->type_name("WORD");
    verb->add_option("--tilt", own->tilt_deg, "tilt of the circular spline's teeth, key tilt.angle_deg [the scene's, or 0]")
        ->check([](std::string const& given) { return angle_fault(given, "an angle in degrees such as 0.2"); })
        ->type_name("DEG");
    verb->add_option("-o,--output", own->output, "folder to make [the drive's name and -wedm, in this folder]")->check(name_fault)->type_name("DIR");
    verb->add_option("--from", own->from, "take scene and outline from a result file in place of solving")->check(name_fault)->type_name("FILE.h5");
    add_list(*verb, "--dialect", [own](std::string const& given) { own->dialects.push_back(given); }, {}, "files to write, see below [the scene's, or all that fit]")->type_name("NAME,...");
    verb->add_option("--decimals", own->decimals, "of coordinates in mm, key wedm.decimals [the scene's, or 4]")
        ->check([](std::string const& given) { return number_fault(given, "write a whole number such as 4"); })
        ->type_name("N");
    verb->add_option("--picture", own->picture, "drawings NAME-tooth, NAME-ring, NAME-residual; needs gnuplot")
        ->check(name_fault)
        ->type_name("NAME.svg|NAME.png");
    verb->footer(dialects_text() +
                 "The wire's diameter and spark gap stand in the scene, table [wedm]; there is no default for them.\n"
                 "Nothing is written unless every file, read back, gives both faces again to one unit of its last digit.\n"
                 "Examples:\n"
                 "  hdconj wedm drive.toml --tilt 0.2 -o cut --picture cut.svg\n"
                 "  hdconj wedm --tilt 0.2 --dialect dxf,csv --decimals 5 -o cut\n"
                 "  hdconj wedm drive.toml --part flexspline --set wedm.overlap=0.05\n"
                 "  hdconj wedm --from drive.h5 --set wedm.wire_diameter=0.07");
    verb->callback([&common, own] { common.action = [&common, own] { return run_wedm(common, *own); }; });
}

}  // namespace hdconj::cli
