// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the parts of a report.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/report.hpp"
#include "hdconj/solve.hpp"
#include "stored_result.hpp"

namespace hdconj {
namespace {

bool is_asked(ReportOptions const& options, ReportPart part)
{
    return std::find(options.parts.begin(), options.parts.end(), part) != options.parts.end();
}

/// Runs @p compute; what keeps it from a result is said in `left_out`.
template <class Compute>
void compute_or_name(ReportedDrive& drive, std::string_view part, Compute const& compute)
{
    try {
        compute();
    } catch (InputError const& error) {
        drive.left_out.push_back({std::string(part), error.what(), true});
    } catch (NumericalError const& error) {
        drive.left_out.push_back({std::string(part), error.what(), true});
    }
}

/// The same of a part that may not be asked for, or not any more.
template <class Compute>
void try_part(ReportedDrive& drive, ReportOptions const& options, ReportPart part, Compute const& compute)
{
    std::string const name(to_string(part));
    if (!is_asked(options, part))
        drive.left_out.push_back({name, "not asked for; hdconj report --with " + name + " computes it"});
    else if (options.stop && options.stop())
        drive.left_out.push_back({name, "the run was stopped before", true});
    else
        compute_or_name(drive, name, compute);
}

}  // namespace

std::vector<std::string> missing_of(Report const& report)
{
    std::vector<std::string> missing;
    for (auto const& drive : report.drives)
        for (LeftOut const& each : drive.left_out)
            if (each.failed)
                missing.push_back(fmt::format("{}: {}: {}", drive.solution.scene.drive.name, each.part, each.why));
    for (auto const& drive : report.failed)
        missing.push_back(fmt::format("{}: {}", drive.name, drive.why));
    return missing;
}

Faults check_report(Scene const& scene)
{
    if (!scene.wants_neutral_curve())
        return {};
    return {{"wave_generator.family", 0, "wanted", "the neutral curve is not known, and a report shows the drive on it",
             "write hdconj solve SCENE --completed DRIVE.toml, and report DRIVE.toml"}};
}

Faults check_report(ReportOptions const& options)
{
    Faults faults = check_options(options.contact);
    for (auto const& [option, is_given, part] :
         {std::tuple{"--tilt", !options.contact.tilts.empty(), ReportPart::contact},
          std::tuple{"--revolution", options.contact.revolution != 0, ReportPart::contact},
          std::tuple{"--no-curve", !options.load.curve, ReportPart::load}})
        if (is_given && !is_asked(options, part))
            faults.push_back({option, 0, "", fmt::format("is of the part {}, which is not asked for", to_string(part)),
                              fmt::format("write --with {} too, or leave it out", to_string(part))});
    return faults;
}

Fault idle_option(std::string const& option)
{
    return {option, 0, "", "changes how a scene is computed, and only result files are given",
            "leave it out, or give the scene in place of its result file"};
}

Faults check_without_scene(ReportOptions const& options)
{
    Faults faults;
    for (auto const& [option, is_given] :
         {std::pair{"--tilt", !options.contact.tilts.empty()},
          std::pair{"--revolution", options.contact.revolution != 0}, std::pair{"--no-curve", !options.load.curve}})
        if (is_given)
            faults.push_back(idle_option(option));
    return faults;
}

ReportedDrive report_drive(Scene const& scene, ReportOptions const& options, StageObserver const& on_stage,
                           Progress const& progress)
{
    LoadOptions load = options.load;
    RunOptions run = options.run;
    load.stop = run.stop = options.stop;
    ReportedDrive drive;
    drive.solution = solve(scene, on_stage);
    try_advice(drive.solution);
    try_part(drive, options, ReportPart::contact, [&] {
        if (Faults faults = check_contact(scene, options.contact); !faults.empty())
            throw InputError(std::move(faults));
        drive.contact = study_contact(scene, options.contact, on_stage, progress);
        for (auto const& cause : drive.contact->missing)
            drive.left_out.push_back({"contact", cause, true});
    });
    try_part(drive, options, ReportPart::load, [&] {
        if (Faults faults = check_load(scene, load); !faults.empty())
            throw InputError(std::move(faults));
        drive.load = study_load(scene, load, on_stage, progress);
        for (auto const& cause : drive.load->missing)
            drive.left_out.push_back({"load", cause, true});
        if (drive.load->teeth.phi.empty())
            drive.left_out.push_back(
                {"teeth under torque", "the scene has errors of the rings, by which each space stands elsewhere"});
    });
    try_part(drive, options, ReportPart::run, [&] {
        if (Faults faults = check_run(scene, run); !faults.empty())
            throw InputError(std::move(faults));
        drive.run = study_run(scene, run, on_stage, progress);
        for (auto const& cause : drive.run->missing)
            drive.left_out.push_back({"run", cause, true});
    });
    try_part(drive, options, ReportPart::wedm, [&] {
        if (Faults faults = check_wedm(scene); !faults.empty())
            throw InputError(std::move(faults));
        drive.wire = wire_set_ups(scene, on_stage);
    });
    try_part(drive, options, ReportPart::design, [&] { drive.design = design_beside(drive.solution); });
    compute_or_name(drive, "teeth in mesh", [&] { drive.teeth = turning_teeth(scene, drive.outline().z, on_stage); });
    return drive;
}

ReportedDrive complete_drive(ReportedDrive drive, ReportOptions const& options, StageObserver const& on_stage)
{
    report::Json const& parts = drive.stored->parts;
    bool const is_loaded =
        parts.contains("load") ||
        (parts.contains("run") && parts.at("run").at("groups").at("running").at("attributes").value("elastic", 0) != 0);
    for (ReportPart const part : {ReportPart::contact, ReportPart::load, ReportPart::run, ReportPart::wedm}) {
        std::string const name(to_string(part));
        if (!drive.stored->parts.contains(name))
            drive.left_out.push_back({name,
                                      "the result file holds none; hdconj report SCENE --with " + name + " has it",
                                      is_asked(options, part)});
    }
    Scene const& scene = drive.solution.scene;
    try_part(drive, options, ReportPart::design, [&] { drive.design = design_beside(solve(scene, on_stage)); });
    compute_or_name(drive, "teeth in mesh", [&] {
        drive.teeth =
            turning_teeth(is_loaded ? loaded_scene(scene) : scene, drive.solution.circular_spline.z, on_stage);
        drive.origin += fmt::format(" The motion of the teeth {}computed from the scene that the file holds.",
                                    drive.design ? "and the comparison with the design rules were " : "was ");
    });
    return drive;
}

}  // namespace hdconj
