// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `load`: the drive under torque, beside what a test rig measured.
#include "hdconj/load.hpp"

#include <fmt/format.h>

#include <optional>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/measured.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "interrupt.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct LoadArguments
{
    std::optional<double> torque_nm;
    std::optional<int> points;
    CaseArguments cases;
    bool no_curve = false;
    bool no_errors = false;
    std::string output;  ///< result file; empty: named after the scene file
    std::string picture;
    std::string vtu;
    std::string measured;       ///< CSV file
    std::string output_member;  ///< of the rig: "cup", "circular-spline"; empty: the cup
    RigOptions rig;
};

void add_files(Work<LoadStudy>& work, CommonOptions const& common, LoadArguments const& own, Scene const& scene,
               Measurement const* measured)
{
    add_file(work, "hdf5", "--output", output_name(common, own.output, scene, "-load.h5"),
             [measured](LoadStudy const& study, fs::path const& file) { write_hdf5(study, file, measured); });
    add_file(work, "vtu", "--vtu", own.vtu, write_cup_vtu, check_ending("--vtu", ".vtu", "ParaView"));
    if (own.picture.empty())
        return;
    fs::path const picture = own.picture;
    auto const [curve, stiffness, pressure, flank, residual, cup, stress, balls] = load_picture_names(picture);
    work.outputs.push_back(
        {{"picture",
          "--picture",
          picture,
          [picture] { check_load_pictures(picture); },
          {curve, stiffness, pressure, flank, residual, cup, stress, balls}},
         [picture, measured](LoadStudy const& study) { return write_load_pictures(study, picture, measured); }});
}

LoadOptions options_of(LoadArguments const& own)
{
    LoadOptions options;
    own.cases.enter(options);
    if (own.torque_nm)
        options.torque = *own.torque_nm * newton_metre;
    options.points = own.points;
    options.curve = !own.no_curve;
    options.errors = !own.no_errors;
    return options;
}

/// Options that have nothing to work on.
void check_options(LoadArguments const& own, Faults& faults)
{
    if (own.no_curve && own.points)
        faults.push_back({"--points", 0, std::to_string(*own.points),
                          "--no-curve leaves no curve that could have points", "leave one of them out"});
    if (!own.measured.empty())
        return;
    auto const refuse_option = [&](char const* option, std::string const& value) {
        faults.push_back({option, 0, value, "no measured curve is given that it could apply to",
                          "write --measured with the name of a CSV file, or leave it out"});
    };
    if (!own.output_member.empty())
        refuse_option("--output-member", own.output_member);
    for (auto const& [option, given] : {std::pair("--torque-constant", own.rig.torque_constant),
                                        {"--counts-per-turn", own.rig.counts_per_turn},
                                        {"--ratio", own.rig.ratio},
                                        {"--efficiency", own.rig.efficiency}})
        if (given)
            refuse_option(option, fmt::format("{:g}", *given));
}

/// Faults of the measured loop are reported together with those of the scene.
std::optional<Measurement> measurement_of(LoadArguments const& own, Scene const& scene, Faults& faults)
{
    if (own.measured.empty())
        return std::nullopt;
    auto const member = from_word<OutputMember>(own.output_member).value_or(OutputMember::cup);
    auto reading = examine_measurement(own.measured, own.rig, member, scene.drive.flexspline_teeth,
                                       scene.drive.circular_spline_teeth);
    append(faults, reading.faults);
    return std::move(reading.measurement);
}

int run_load(CommonOptions const& common, LoadArguments const& own)
{
    auto const reading = examine_drive(common);
    Scene const& scene = reading.scene;
    LoadOptions options = options_of(own);
    options.stop = is_stopped;
    Faults faults = reading.faults;
    if (faults.empty())
        append(faults, check_load(scene, options));
    sort_by_place(faults);
    check_options(own, faults);
    auto const measurement = measurement_of(own, scene, faults);
    Measurement const* const measured = measurement ? &*measurement : nullptr;
    Work<LoadStudy> work;
    work.faults = std::move(faults);
    work.inputs = inputs_of(common, scene);
    append(work.inputs, input_of("--measured", own.measured));
    add_files(work, common, own, scene, measured);
    work.compute = [&](ProgressLine const& progress) {
        stop_at_interrupt();
        try {
            return study_load(scene, options, progress.stages(), progress.shares(),
                              [&](std::string const& line) { progress.keep(line); });
        } catch (NumericalError const& error) {
            if (error.code() == ErrorCode::stopped)
                end_by_interrupt();
            throw;
        }
    };
    work.text = [&](LoadStudy const& study, Written const& written) { return summary_text(study, written, measured); };
    work.json = [&](LoadStudy const& study, Written const& written) { return summary_json(study, written, measured); };
    work.status = [](LoadStudy const& study) { return status_of_missing(study.missing); };
    work.judgement = [](LoadStudy const& study) { return study.solution.judgement; };
    return run_verb(common, work);
}

constexpr char const* load_footer =
    "The cup is elastic and sits on its wave generator without friction. Each pair of teeth carries as much of the "
    "torque as its gap allows.\n"
    "Wave generator and flange of the cup are held. The torque on the circular spline runs from -T to T, as often as "
    "the stiffness needs, or in even steps with --points.\n"
    "Results are twist, backlash, stiffness, pressure and stress. K1, K2 and K3 are stiffnesses as catalogues define "
    "them: from 0 to T1, from T1 to T2 and from T2 on,\n"
    "where load.first_torque and load.second_torque are T1 and T2. Two straight lines through the curve are given for "
    "comparison with a test rig.\n"
    "Where the cup is the output, angles are z_c/z_f times as large and torques z_f/z_c times (teeth of the circular "
    "spline and of the flexspline).\n"
    "The stiffness is as right as the radial stiffness of the bearing, a key of the scene.\n"
    "A measured curve is a CSV file whose first line names columns and units, such as\n"
    "  angle [arcmin], torque [N m]          angle deg, arcmin, arcsec, rad, mrad; torque N m, N mm, mN m\n"
    "  current [A], position [counts]        a motor with --torque-constant, its encoder with --counts-per-turn\n"
    "with one or more cycles 0, T, 0, -T, 0. Its backlash is the width of the loop at zero torque. Two lines are "
    "fitted to each loading branch.\n"
    "Ctrl-C stops after the torque that is computed and keeps what is there; once more ends the run.\n"
    "A surface, kind or tilt that has no result is named with its cause. The others are written, and the exit status "
    "is 1.\n"
    "Examples:\n"
    "  hdconj load drive.toml --picture drive.svg --vtu cup.vtu\n"
    "  hdconj load drive.toml --surface tilted --kind radial,draft --tilt 0,0.1,0.2 --no-curve\n"
    "  hdconj load drive.toml --measured log.csv --torque-constant 0.119 --counts-per-turn 2000 --picture both.svg";

void add_rig(CLI::App& verb, LoadArguments& own)
{
    add_name(verb, "--measured", own.measured, "torque-angle curve of a test rig, to compare with the simulation",
             "FILE.csv");
    add_option(verb, "--torque-constant", own.rig.torque_constant,
               "of the rig's motor in N m/A; negative where current and angle count in opposite senses", "NM/A",
               finite_number("write N m per A such as --torque-constant 0.119"));
    add_option(verb, "--counts-per-turn", own.rig.counts_per_turn,
               "of the encoder on the motor, after quadrature multiplication", "N",
               finite_number("write counts per turn of the motor such as --counts-per-turn 2000"));
    add_option(verb, "--ratio", own.rig.ratio, "motor turns per turn of the output [the scene's]", "I",
               finite_number("write a ratio such as --ratio 100"));
    add_option(verb, "--efficiency", own.rig.efficiency, "static efficiency between motor and output [1]", "ETA",
               finite_number("write a number above 0 and at most 1, such as --efficiency 0.8"));
    add_option(verb, "--output-member", own.output_member,
               "member that turns at the rig's output: cup, circular-spline [cup]", "WORD", one_of<OutputMember>());
}

}  // namespace

void add_load(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] = add_verb(program, common, "load",
                                "the elastic cup and the teeth under torque: stiffness, pressure, stress", run_load);
    add_scene_options(verb, common);
    add_strict(verb, common);
    add_option(verb, "--torque", own.torque_nm, "largest torque on the circular spline in N m [the scene's]", "NM",
               positive_number("write a torque in N m such as --torque 28"));
    add_option(verb, "--points", own.points, "even torques from 0 to T [as many as needed]", "N",
               whole_number(1, scene::bounds::most_torques));
    add_case_options(verb, own.cases, "tilt angles in degrees, such as 0,0.1,0.2 [the scene's]");
    verb.add_flag("--no-curve", own.no_curve, "the largest torque only: no curve, no K1, K2, K3");
    verb.add_flag("--no-errors", own.no_errors, "one grid alone: the same figures without their errors, in less time");
    add_name(verb, "-o,--output", own.output, "result file, HDF5 [the scene file's name and -load.h5, in this folder]",
             "FILE");
    add_name(
        verb, "--picture", own.picture,
        "drawings NAME-curve, -stiffness, -residual, -pressure, -flank, -cup, -stress and -balls, as far as there is "
        "something to draw; needs gnuplot",
        "NAME.svg|NAME.png");
    add_name(verb, "--vtu", own.vtu, "the deformed cup with its stress, for ParaView", "FILE.vtu");
    add_rig(verb, own);
    verb.footer(load_footer);
}

}  // namespace hdconj::cli
