// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `report`: drives as one HTML file.
#include "hdconj/report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <variant>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/schema.hpp"
#include "interrupt.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct ReportArguments
{
    std::vector<std::string> sources;  ///< scenes and result files
    std::vector<std::string> parts;
    std::vector<std::string> tilts_deg;
    int revolution = 0;
    bool no_curve = false;
    std::string output;
};

/// A scene that is computed, and how messages call it.
struct NamedScene
{
    Scene scene;
    std::string name;
};

/// A drive of the page: a scene that is computed, or what a result file holds.
using Source = std::variant<NamedScene, ReportedDrive>;

Scene const& scene_of(Source const& source)
{
    auto const* const named = std::get_if<NamedScene>(&source);
    return named != nullptr ? named->scene : std::get<ReportedDrive>(source).solution.scene;
}

ReportOptions options_of(ReportArguments const& own)
{
    ReportOptions options;
    options.parts = values_of<ReportPart>(own.parts);
    CaseArguments const cases{own.tilts_deg, {}, {}};
    cases.enter(options.contact);
    options.contact.revolution = own.revolution;
    options.load.curve = !own.no_curve;
    options.stop = is_stopped;
    return options;
}

/// The scenes, each with --set and --threads, and the result files; faults of all in one report.
std::vector<Source> sources_of(CommonOptions common, ReportArguments const& own, std::vector<InputFile>& inputs)
{
    std::vector<Source> sources;
    Faults faults;
    bool any_scene = false;
    for (std::string const& name : own.sources.empty() ? std::vector<std::string>{""} : own.sources) {
        common.scene = name;
        bool const is_file = is_result_file(name);
        any_scene = any_scene || !is_file;
        try {
            if (is_file) {
                inputs.push_back({name, "this is a result file that the page shows"});
                sources.emplace_back(read_drive(name));
            } else {
                sources.emplace_back(NamedScene{load_drive(common), scene_name(common)});
                append(inputs, inputs_of(common, scene_of(sources.back())));
            }
            refuse(check_report(scene_of(sources.back())));
        } catch (InputError const& error) {
            for (Fault fault : error.faults()) {
                if (fault.origin.empty() && !is_file && !name.empty())
                    fault.origin = scene_name(common);
                faults.push_back(std::move(fault));
            }
        }
    }
    if (!any_scene && !common.overrides.empty())
        faults.push_back(idle_option("--set"));
    if (!any_scene)
        append(faults, check_without_scene(options_of(own)));
    refuse(std::move(faults));
    return sources;
}

/// @throws NumericalError where the run was stopped and this is not the first
ReportedDrive drive_of(Source const& source, bool is_first, ReportOptions const& options, ProgressLine const& progress)
{
    auto const* const named = std::get_if<NamedScene>(&source);
    if (named == nullptr)
        return complete_drive(std::get<ReportedDrive>(source), options, progress.stages());
    if (is_stopped() && !is_first)
        throw NumericalError(ErrorCode::stopped, "report", named->name, "the run was stopped before");
    try {
        return report_drive(named->scene, options, progress.stages(), progress.shares());
    } catch (NumericalError const& error) {
        throw SceneFailure(error, named->name);
    }
}

int run_report(CommonOptions const& common, ReportArguments const& own)
{
    Work<Report> work;
    std::vector<Source> const sources = sources_of(common, own, work.inputs);
    ReportOptions const options = options_of(own);
    refuse(check_report(options));
    CommonOptions first = common;
    first.scene = own.sources.empty() ? "" : own.sources.front();
    add_file(
        work, "html", "--output", output_name(first, own.output, scene_of(sources.front()), ".html"),
        [](Report const& report, fs::path const& file) { file::write_text_atomically(file, report_page(report)); },
        check_ending("--output", ".html", "a browser"));
    work.compute = [&](ProgressLine const& progress) {
        stop_at_interrupt();
        return report_drives(
            sources, [](Source const& source) { return scene_of(source).drive.name; },
            [&](Source const& source) { return drive_of(source, &source == &sources.front(), options, progress); });
    };
    work.text = [](Report const&, Written const& written) {
        return fmt::format("report: {}, {} kB\n", written.front().file.string(),
                           fs::file_size(written.front().file) / 1000);
    };
    work.json = [](Report const& report, Written const& written) { return summary_json(report, written); };
    work.status = [](Report const& report) { return status_of_missing(missing_of(report)); };
    return run_verb(common, work);
}

constexpr char const* report_footer =
    "The page opens from disk, without a network, in any browser. It shows every figure with its\n"
    "error, the teeth as they turn, and the parts that --with names. What is missing is named in the\n"
    "page with its cause.\n"
    "Several drives are compared. A result file is shown as it was computed: from its scene only the\n"
    "motion of the teeth is computed. --with, --set, --tilt and the like are for scenes.\n"
    "--with design derives wishes from a scene and shows it beside the design that they make.\n"
    "A part that is asked for and has no result, and one of several drives that cannot be solved, is\n"
    "named with its cause. The rest is written, and the exit status is 1.\n"
    "Ctrl-C stops after what is computed and keeps what is there; once more ends the run.\n"
    "Examples:\n"
    "  hdconj report drive.toml -o drive.html --with contact,load\n"
    "  hdconj report first.toml second.toml -o both.html\n"
    "  hdconj report drive.h5 -o drive.html";

}  // namespace

void add_report(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "report", "drives as one HTML page: figures, turning teeth, load, wire", run_report);
    verb.add_option(
            "SCENE", own.sources,
            "scene files in TOML, or result files of solve, contact, load and run; - for standard input; absent: "
            "the built-in drive")
        ->check(is_name);
    add_computing_options(verb, common);
    verb.add_flag("--json", common.json, "one JSON object on standard output");
    add_name(verb, "-o,--output", own.output, "the page [the first scene file's name and .html, in this folder]",
             "FILE.html");
    add_list(verb, "--with", own.parts, "what else is computed: solve, contact, load, run, wedm, design [solve]",
             "LIST", one_of<ReportPart>());
    add_list(verb, "--tilt", own.tilts_deg, "tilt angles in degrees for contact, such as 0,0.1,0.2 [the scene's]",
             "LIST", angle("an angle in degrees such as 0.2"));
    add_option(verb, "--revolution", own.revolution, "angles of the wave generator at which contact is computed", "N",
               whole_number(1, scene::bounds::most_revolution_angles));
    verb.add_flag("--no-curve", own.no_curve, "load at the largest torque only: no curve");
    // clang 14 cannot capture a name of a structured binding itself.
    verb.parse_complete_callback(
        [&common, &sources = own.sources] { common.subject = fmt::format("{}", fmt::join(sources, ", ")); });
    verb.footer(report_footer);
}

}  // namespace hdconj::cli
