// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `report`: drives as one HTML file.
#include "hdconj/report.hpp"

#include <fmt/format.h>

#include <iterator>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct ReportArguments
{
    std::vector<std::string> scenes;
    std::vector<std::string> parts;
    std::vector<std::string> tilts_deg;
    int revolution = 0;
    bool no_curve = false;
    std::string output;
};

/// The scenes, each with --set and --threads; faults of all in one report.
std::vector<Scene> scenes_of(CommonOptions common, ReportArguments const& own, std::vector<InputFile>& inputs)
{
    std::vector<Scene> scenes;
    Faults faults;
    for (std::string const& name : own.scenes.empty() ? std::vector<std::string>{""} : own.scenes) {
        common.scene = name;
        try {
            scenes.push_back(load_scene(common));
            append(inputs, inputs_of(common, scenes.back()));
            append(faults, check_report(scenes.back()));
        } catch (InputError const& error) {
            append(faults, error.faults());
        }
    }
    refuse(std::move(faults));
    return scenes;
}

ReportOptions options_of(ReportArguments const& own)
{
    ReportOptions options;
    options.parts = values_of<ReportPart>(own.parts);
    CaseArguments const cases{own.tilts_deg, {}, {}};
    cases.enter(options.contact);
    options.contact.revolution = own.revolution;
    options.load.curve = !own.no_curve;
    return options;
}

std::vector<std::string> failures(std::vector<ReportedDrive> const& drives)
{
    std::vector<std::string> missing;
    for (auto const& drive : drives)
        for (LeftOut const& each : drive.left_out)
            if (each.failed)
                missing.push_back(fmt::format("{}: {}: {}", drive.solution.scene.drive.name, each.part, each.why));
    return missing;
}

int run_report(CommonOptions const& common, ReportArguments const& own)
{
    using Drives = std::vector<ReportedDrive>;
    Work<Drives> work;
    std::vector<Scene> const scenes = scenes_of(common, own, work.inputs);
    ReportOptions const options = options_of(own);
    CommonOptions first = common;
    first.scene = own.scenes.empty() ? "" : own.scenes.front();
    add_file(
        work, "html", "--output", output_name(first, own.output, scenes.front(), ".html"),
        [](Drives const& drives, fs::path const& file) { file::write_text_atomically(file, report_page(drives)); });
    work.compute = [&](ProgressLine const& progress) {
        Drives drives;
        for (Scene const& scene : scenes)
            drives.push_back(report_drive(scene, options, progress.stages(), progress.shares()));
        return drives;
    };
    work.text = [](Drives const&, Written const& written) {
        return fmt::format("report: {}, {} kB\n", written.front().file.string(),
                           fs::file_size(written.front().file) / 1000);
    };
    work.status = [](Drives const& drives) { return status_of_missing(failures(drives)); };
    return run_verb(common, work);
}

constexpr char const* report_footer =
    "The page opens from disk, without a network, in any browser. It shows every figure with its error, the teeth as\n"
    "they turn, and the parts that --with names. What is missing is named in the page with its cause.\n"
    "Several scenes are compared. The drive while it runs is not computed, and a design from wishes is a scene first.\n"
    "A part that is asked for and has no result is named with its cause. The rest is written, and the exit status is "
    "1.\n"
    "Examples:\n"
    "  hdconj report drive.toml -o drive.html --with contact,load\n"
    "  hdconj report first.toml second.toml -o both.html";

}  // namespace

void add_report(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "report", "drives as one HTML page: figures, turning teeth, load, wire", run_report);
    verb.add_option("SCENE", own.scenes, "scene files in TOML; - for standard input; absent: the built-in drive")
        ->check(is_name);
    add_computing_options(verb, common);
    add_name(verb, "-o,--output", own.output, "the page [the first scene file's name and .html, in this folder]",
             "FILE.html");
    add_list(verb, "--with", own.parts, "what else is computed: solve, contact, load, wedm [solve]", "LIST",
             one_of<ReportPart>());
    add_list(verb, "--tilt", own.tilts_deg, "tilt angles in degrees for contact, such as 0,0.1,0.2 [the scene's]",
             "LIST", angle("an angle in degrees such as 0.2"));
    add_option(verb, "--revolution", own.revolution, "angles of the wave generator at which contact is computed", "N",
               whole_number(1, 10000));
    verb.add_flag("--no-curve", own.no_curve, "load at the largest torque only: no curve");
    verb.footer(report_footer);
}

}  // namespace hdconj::cli
