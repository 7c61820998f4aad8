// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `load`: which torques, surfaces and tilts, which files, what a test rig measured, and what is said about it.
#include "hdconj/pipeline/load.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/load_files.hpp"
#include "hdconj/io/measured_file.hpp"
#include "hdconj/scene/schema.hpp"
#include "lists.hpp"
#include "outputs.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

constexpr double nmm_per_nm = 1000;

/// What only `load` is asked.
struct VerbOptions
{
    std::optional<double> torque_nm;
    std::optional<int> points;
    std::vector<double> tilts_deg;
    std::vector<std::string> surfaces;
    std::vector<std::string> kinds;
    bool no_curve = false;
    std::string output;    ///< result file; empty: named after the drive
    std::string picture;   ///< empty: none
    std::string vtu;
    std::string measured;  ///< CSV file; empty: none
    std::string output_member;  ///< of the rig: "cup", "circular-spline"; empty: the cup
    RigOptions rig;
};

/// Everything about the targets that can be known, and how each is written.
struct Job
{
    OutputJob output;
    std::function<std::vector<WrittenFile>(LoadStudy const&, Measurement const*)> write;
};

std::vector<Job> jobs_of(VerbOptions const& own, Scene const& scene)
{
    fs::path const result = own.output.empty() ? fs::path(file_name(scene.drive.name) + "-load.h5") : fs::path(own.output);
    std::vector<Job> jobs;
    jobs.push_back({{"hdf5", "--output", result, [result] { check_target(result); }}, [result](LoadStudy const& study, Measurement const* measured) {
                        return std::vector<WrittenFile>{timed("hdf5", result, [&] { write_hdf5(study, result, measured); })};
                    }});
    if (!own.vtu.empty()) {
        fs::path const vtu = own.vtu;
        jobs.push_back({{"vtu", "--vtu", vtu, [vtu] { check_target(vtu); }}, [vtu](LoadStudy const& study, Measurement const*) {
                            return std::vector<WrittenFile>{timed("vtu", vtu, [&] { write_cup_vtu(study, vtu); })};
                        }});
    }
    if (!own.picture.empty()) {
        fs::path const picture = own.picture;
        jobs.push_back({{"picture", "--picture", picture, [picture] { check_load_pictures(picture); }},
                        [picture](LoadStudy const& study, Measurement const* measured) { return write_load_pictures(study, picture, measured); }});
        auto const [curve, pressure, cup, stress, balls] = load_picture_names(picture);
        jobs.back().output.members = {curve, pressure, cup, stress, balls};
    }
    return jobs;
}

LoadOptions options_of(VerbOptions const& own)
{
    LoadOptions options;
    for (double const tilt : own.tilts_deg) {
        options.tilts.push_back(tilt * rad_per_deg);
    }
    options.surfaces = own.surfaces;
    options.kinds = own.kinds;
    if (own.torque_nm) {
        options.torque = *own.torque_nm * nmm_per_nm;
    }
    options.points = own.points;
    options.curve = !own.no_curve;
    return options;
}

/// Options that have nothing to work on.
void check_options(VerbOptions const& own, Faults& faults)
{
    if (own.no_curve && own.points) {
        faults.push_back({"--points", 0, std::to_string(*own.points), "--no-curve leaves no curve that could have points", "leave one of them out"});
    }
    auto const needs_measured = [&](char const* option, std::optional<double> const& given) {
        if (own.measured.empty() && given) {
            faults.push_back({option, 0, fmt::format("{:g}", *given), "there is no measured curve that it could be about", "write --measured with the name of a CSV file, or leave it out"});
        }
    };
    if (own.measured.empty() && !own.output_member.empty()) {
        faults.push_back({"--output-member", 0, own.output_member, "there is no measured curve that it could be about", "write --measured with the name of a CSV file, or leave it out"});
    }
    needs_measured("--torque-constant", own.rig.torque_constant);
    needs_measured("--counts-per-turn", own.rig.counts_per_turn);
    needs_measured("--ratio", own.rig.ratio);
    needs_measured("--efficiency", own.rig.efficiency);
}

/// How often the wave generator turns for a turn of the output; of a scene with faults any number will do.
double ratio_of(Scene const& scene, bool cup)
{
    int const z_f = scene.drive.flexspline_teeth, z_c = scene.drive.circular_spline_teeth;
    return z_c != z_f && z_f > 0 ? std::abs(static_cast<double>(cup ? z_f : z_c) / (z_c - z_f)) : 1;
}

std::optional<Measurement> measurement_of(VerbOptions const& own, Scene const& scene, Faults& faults)
{
    if (own.measured.empty()) {
        return std::nullopt;
    }
    bool const cup = own.output_member != "circular-spline";
    auto reading = examine_measured(own.measured, own.rig, ratio_of(scene, cup));
    if (!reading.faults.empty()) {
        faults.insert(faults.end(), reading.faults.begin(), reading.faults.end());
        return std::nullopt;
    }
    if (cup && scene.drive.flexspline_teeth > 0) {
        reading.curve.rig.angle_per_spline = static_cast<double>(scene.drive.circular_spline_teeth) / scene.drive.flexspline_teeth;
    }
    // What is wrong with the loop stands beside what is wrong with the scene.
    try {
        MeasuredStiffness const found = measured_stiffness(reading.curve);
        return Measurement{std::move(reading.curve), found};
    } catch (InputError const& error) {
        faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        return std::nullopt;
    }
}

/// All that is given, or all that is wrong with it.
struct Given
{
    Scene scene;
    LoadOptions options;
    std::optional<Measurement> measured;
};

Given given(CommonOptions const& common, VerbOptions const& own)
{
    auto reading = examine(common);
    Faults faults = std::move(reading.faults);
    LoadOptions options = options_of(own);
    bool const sound = faults.empty();
    if (sound) {
        auto const load = check_load(reading.scene, options);
        faults.insert(faults.end(), load.begin(), load.end());
    }
    sort_by_place(faults);
    check_options(own, faults);
    auto measured = measurement_of(own, reading.scene, faults);
    if (!faults.empty()) {
        throw InputError(std::move(faults));
    }
    return {std::move(reading.scene), std::move(options), std::move(measured)};
}

int run_load(CommonOptions const& common, VerbOptions const& own)
{
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes a failed write, with its reason
    Given const start = given(common, own);
    auto const jobs = jobs_of(own, start.scene);
    std::vector<OutputJob> outputs;
    for (auto const& job : jobs) {
        outputs.push_back(job.output);
    }
    auto inputs = inputs_of(common, start.scene);
    for (auto const& input : input_of("--measured", own.measured)) {
        inputs.push_back(input);
    }
    check_outputs(outputs, inputs);
    hdconj::cli::Progress const progress(!common.quiet);
    LoadStudy const study = load(start.scene, start.options, [&](Stage stage) { progress.say(to_string(stage)); },
                                 [&](std::string const& what, double share) { progress.say(what, share); }, [&](std::string const& line) { progress.keep(line); });
    Measurement const* const measured = start.measured ? &*start.measured : nullptr;
    std::vector<WrittenFile> written;
    for (auto const& job : jobs) {
        progress.say(job.output.kind);
        auto const files = job.write(study, measured);
        written.insert(written.end(), files.begin(), files.end());
    }
    progress.clear();
    if (common.json) {
        std::cout << summary_json(study, written, measured);
    } else if (!common.quiet) {
        std::cout << summary_text(study, written, measured);
    }
    if (common.json && !common.quiet) {
        for (auto const& each : written) {
            std::cerr << "wrote " << each.file.string() << '\n';
        }
    }
    return status_of_cases(study.missing, study.cases.size());
}

constexpr char const* footer =
    "The cup is elastic, pressed on its wave generator without friction; teeth touch, part and share the torque as their gaps allow.\n"
    "Wave generator and cup's flange are held, the torque on the circular spline runs 0, T, 0, -T: its twist, backlash, two stages of stiffness, pressure, stress.\n"
    "Where the cup is the output, angles are z_c/z_f times as large, torques z_f/z_c.\n"
    "Absolute stiffness depends on how far the bearing gives way, which is a key of the scene and no more than its value is right.\n"
    "A measured curve is a CSV file whose first line names columns and units, such as\n"
    "  angle [arcmin], torque [N m]          angle deg, arcmin, arcsec, rad, mrad; torque N m, N mm, mN m\n"
    "  current [A], position [counts]        a motor with --torque-constant, its encoder with --counts-per-turn\n"
    "with one or more cycles 0, T, 0, -T, 0: its backlash is the width of the loop at zero torque, its stages two lines each.\n"
    "Of several surfaces, kinds or tilts those that cannot be made are named, the others written, and the exit status is 1.\n"
    "Examples:\n"
    "  hdconj load drive.toml --picture drive.svg --vtu cup.vtu\n"
    "  hdconj load drive.toml --surface tilted --kind radial,draft --tilt 0,0.1,0.2 --no-curve\n"
    "  hdconj load drive.toml --measured log.csv --torque-constant 0.119 --counts-per-turn 2000 --picture both.svg";

auto number_check(std::string const& remedy)
{
    return [remedy](std::string const& given) { return number_fault(given, remedy); };
}

}  // namespace

void add_load(CLI::App& program, CommonOptions& common)
{
    auto* verb = program.add_subcommand("load", "the elastic cup and the teeth under torque: stiffness, pressure, stress");
    add_scene_options(*verb, common);
    auto own = std::make_shared<VerbOptions>();
    verb->add_option("--torque", own->torque_nm, "largest torque on the circular spline in N m [the scene's]")
        ->check([](std::string const& given) { return positive_fault(given, "write a torque in N m such as --torque 28"); })
        ->type_name("NM");
    verb->add_option("--points", own->points, "torques on the way up [the scene's]")->check(CLI::Range(1, 1000))->type_name("N");
    add_list(*verb, "--tilt", [own](std::string const& given) { own->tilts_deg.push_back(angle_deg(given)); }, [](std::string const& given) { return angle_fault(given); },
             "tilt angles in degrees, such as 0,0.1,0.2 [the scene's]")
        ->type_name("DEG,...");
    add_list(*verb, "--surface", [own](std::string const& given) { own->surfaces.push_back(given); },
             [](std::string const& given) { return word_fault(given, {"tilted", "ruled", "per-slice"}); },
             "how the teeth of the circular spline are made: tilted, ruled, per-slice [the scene's, or tilted]")
        ->type_name("WORD,...");
    add_list(*verb, "--kind", [own](std::string const& given) { own->kinds.push_back(given); }, [](std::string const& given) { return word_fault(given, {"radial", "draft"}); },
             "what tilt means: radial, outline moved along its radii, or draft, along its normal [the scene's, or radial]")
        ->type_name("WORD,...");
    verb->add_flag("--no-curve", own->no_curve, "the largest torque only: no curve, no stages");
    verb->add_option("-o,--output", own->output, "result file, HDF5 [the drive's name and -load.h5, in this folder]")->check(name_fault)->type_name("FILE");
    verb->add_option("--picture", own->picture, "drawings NAME-curve, NAME-pressure, NAME-cup, NAME-stress and, of single balls, NAME-balls; needs gnuplot")->check(name_fault)->type_name("NAME.svg|NAME.png");
    verb->add_option("--vtu", own->vtu, "the deformed cup with its stress, for ParaView")->check(name_fault)->type_name("FILE.vtu");
    verb->add_option("--measured", own->measured, "torque-angle curve of a test rig, to be laid over the simulation")->check(name_fault)->type_name("FILE.csv");
    verb->add_option("--torque-constant", own->rig.torque_constant, "of the rig's motor in N m/A; negative where current and angle count in opposite senses")
        ->check(number_check("write N m per A such as --torque-constant 0.119"))
        ->type_name("NM/A");
    verb->add_option("--counts-per-turn", own->rig.counts_per_turn, "of the encoder on the motor, after multiplication")
        ->check(number_check("write counts per turn of the motor such as --counts-per-turn 2000"))
        ->type_name("N");
    verb->add_option("--ratio", own->rig.ratio, "motor turns per turn of the output [the scene's]")->check(number_check("write a ratio such as --ratio 100"))->type_name("I");
    verb->add_option("--efficiency", own->rig.efficiency, "static efficiency between motor and output [1]")->check(number_check("write a share such as --efficiency 0.8"))->type_name("ETA");
    verb->add_option("--output-member", own->output_member, "what turns at the rig's output: cup, circular-spline [cup]")
        ->check([](std::string const& word) { return word_fault(word, {"cup", "circular-spline"}); })
        ->type_name("WORD");
    verb->footer(footer);
    verb->callback([&common, own] { common.action = [&common, own] { return run_load(common, *own); }; });
}

}  // namespace hdconj::cli
