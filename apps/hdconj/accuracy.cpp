// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `accuracy`: which studies, which files, and what is advised.
#include "hdconj/study/accuracy.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

#include "cli.hpp"
#include "hdconj/io/accuracy_files.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/scene/reading.hpp"
#include "lists.hpp"
#include "outputs.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

/// What only `accuracy` is asked.
struct AccuracyVerb
{
    AccuracyOptions study;
    bool sample_given = false, repeats_given = false;
    std::string output;   ///< folder; empty: named after the drive
    std::string from;     ///< records measured before; empty: measure
    std::string page;     ///< empty: none
    std::optional<std::string> budget;   ///< as written
    std::optional<std::string> error;
};

/// A number with one of these units, in the first unit; nothing where it is none.
std::optional<double> with_unit(std::string const& text, std::vector<std::pair<std::string, double>> const& units)
{
    char* end = nullptr;
    double const value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || !(value > 0) || !(value < 1e9)) {
        return {};
    }
    for (auto const& [name, factor] : units) {
        if (end == name) {
            return value * factor;
        }
    }
    return {};
}

std::optional<double> seconds_of(std::string const& text)
{
    return with_unit(text, {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}});
}

std::optional<double> millimetres_of(std::string const& text)
{
    return with_unit(text, {{"", 1}, {"mm", 1}, {"um", 1e-3}, {"nm", 1e-6}});
}

/// A page with the pictures that may lie beside it.
OutputJob page_job(std::string const& page)
{
    OutputJob job{"page", "--page", page, [page] { check_target(page); }};
    for (auto const& kind : study_kinds()) {
        job.members.push_back(accuracy_figure(page, std::string(kind.name)));
    }
    return job;
}

/// What is wrong with the options by themselves.
Faults option_faults(AccuracyVerb const& own)
{
    Faults faults = check_studies(own.study);
    if (own.budget && !seconds_of(*own.budget)) {
        faults.push_back({"--budget", 0, *own.budget, "this is no time", "write a number with s, ms or us, such as 10ms"});
    }
    if (own.error && !millimetres_of(*own.error)) {
        faults.push_back({"--error", 0, *own.error, "this is no length", "write a number above 0 in mm, or with um or nm"});
    }
    std::string const ending = fs::path(own.page).extension().string();
    if (!own.page.empty() && own.page != "-" && ending != ".md" && ending != ".markdown") {
        faults.push_back({"--page", 0, own.page, "a page is written in Markdown", "write a name that ends in .md, such as " + fs::path(own.page).replace_extension(".md").string()});
    }
    return faults;
}

void throw_all(Faults faults)
{
    if (!faults.empty()) {
        throw InputError(std::move(faults));
    }
}

void append(Faults& faults, Faults const& more)
{
    faults.insert(faults.end(), more.begin(), more.end());
}

OutputJob folder_job(fs::path const& folder, std::string const& drive)
{
    OutputJob job{"folder", "--output", folder, [folder, drive] { check_accuracy_folder(folder, drive); }};
    job.is_folder = true;
    return job;
}

StoredAccuracy measured(CommonOptions const& common, AccuracyVerb const& own)
{
    SceneReading reading = examine(common);
    sort_by_place(reading.faults);
    Faults faults = std::move(reading.faults);
    Scene const scene = std::move(reading.scene);
    if (faults.empty()) {
        // of studies that there are: the others are told once, below
        AccuracyOptions known = own.study;
        std::erase_if(known.studies, [](std::string const& name) { return !check_studies({.studies = {name}}).empty(); });
        if (!known.studies.empty()) {
            append(faults, check_accuracy(scene, known));
        }
    }
    append(faults, option_faults(own));
    throw_all(std::move(faults));
    fs::path const folder = own.output.empty() ? fs::path(file_name(scene.drive.name) + "-accuracy") : fs::path(own.output);
    std::vector<OutputJob> jobs = {folder_job(folder, scene.drive.name)};
    if (!own.page.empty()) {
        jobs.push_back(page_job(own.page));
    }
    check_outputs(jobs, inputs_of(common, scene));
    Progress const progress(!common.quiet);
    AccuracyOptions options = own.study;
    constexpr int sample_of_quick = 3;
    if (options.quick && !own.sample_given) {
        options.sample = sample_of_quick;
    }
    StoredAccuracy study{measure_accuracy(scene, options, [&](std::string const& what, double share) { progress.say(what, share); }), this_program()};
    progress.clear();
    return study;
}

/// What asks for a measurement, and --from is not one.
Faults from_faults(CommonOptions const& common, AccuracyVerb const& own)
{
    Faults faults;
    if (!common.scene.empty() || !common.overrides.empty()) {
        faults.push_back({"--from", 0, own.from, "stored records have a scene of their own, and another is given", "leave SCENE and --set out, or --from"});
    }
    std::string asked;
    auto const ask = [&](bool given, char const* option) { asked += given ? (asked.empty() ? "" : ", ") + std::string(option) : ""; };
    ask(!own.study.studies.empty(), "--study");
    ask(own.study.quick, "--quick");
    ask(own.sample_given, "--sample");
    ask(own.repeats_given, "--repeats");
    if (!asked.empty()) {
        bool const one = asked.find(',') == std::string::npos;
        faults.push_back({"--from", 0, own.from, "nothing is measured anew, and " + asked + (one ? " asks for it" : " ask for it"), one ? "leave one of them out" : "leave them out, or --from"});
    }
    return faults;
}

StoredAccuracy stored(CommonOptions const& common, AccuracyVerb const& own)
{
    Faults faults = from_faults(common, own);
    append(faults, option_faults(own));
    StoredAccuracy study;
    try {
        study = read_accuracy(own.from);
    } catch (InputError const& error) {
        append(faults, error.faults());
    }
    throw_all(std::move(faults));
    std::vector<OutputJob> jobs;
    if (!own.output.empty()) {
        jobs.push_back(folder_job(own.output, study.report.scene.drive.name));
        jobs.back().is_folder = false;   // the folder of the records may be named: they are written again, the same
    }
    if (!own.page.empty()) {
        jobs.push_back(page_job(own.page));
    }
    check_outputs(jobs, input_of("--from", own.from));
    return study;
}

int run_accuracy(CommonOptions const& common, AccuracyVerb const& own)
{
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes a failed write, with its reason
    StoredAccuracy const study = own.from.empty() ? measured(common, own) : stored(common, own);
    std::vector<WrittenFile> written;
    if (own.from.empty() || !own.output.empty()) {
        fs::path const folder = own.output.empty() ? fs::path(file_name(study.report.scene.drive.name) + "-accuracy") : fs::path(own.output);
        written = write_accuracy_folder(study, folder);
    }
    if (!own.page.empty()) {
        auto const files = write_accuracy_page(study, own.page);
        written.insert(written.end(), files.begin(), files.end());
    }
    AccuracyAdvice const advice{own.error ? millimetres_of(*own.error) : std::nullopt, own.budget ? seconds_of(*own.budget) : std::nullopt};
    if (common.json) {
        std::cout << summary_json(study, advice, written);
    } else if (!common.quiet) {
        std::cout << summary_text(study, advice);
    }
    if (!common.quiet) {
        for (auto const& each : written) {
            std::cerr << "wrote " << each.file.string() << '\n';
        }
    }
    return exit_done;
}

std::string studies_text()
{
    std::string text = "Studies:\n";
    for (auto const& kind : study_kinds()) {
        text += fmt::format("  {:<16}{}\n", kind.name, kind.question);
    }
    return text;
}

}  // namespace

void add_accuracy(CLI::App& program, CommonOptions& common)
{
    auto* verb = program.add_subcommand("accuracy", "what accuracy costs in time: error against time of every method and knob");
    add_scene_options(*verb, common);
    auto own = std::make_shared<AccuracyVerb>();
    add_list(*verb, "--study", [own](std::string const& given) { own->study.studies.push_back(given); }, {}, "studies to run, see below [all]")->type_name("NAME,...");
    verb->add_option("-o,--output", own->output, "folder to make [the drive's name and -accuracy, in this folder; with --from none]")->check(name_fault)->type_name("DIR");
    auto* sample = verb->add_option("--sample", own->study.sample, "designs about the scene whose worst is shown beside it [64]")->check(CLI::Range(0, 1000))->type_name("N");
    auto* repeats = verb->add_option("--repeats", own->study.repeats, "runs of each setting; the median counts [5]")->check(CLI::Range(1, 1000))->type_name("N");
    verb->add_flag("--quick", own->study.quick, "short ladders, one run of each setting, 3 designs: some seconds in place of ten minutes (one without the sample)");
    verb->add_option("--from", own->from, "take records that were measured before in place of measuring")->check(name_fault)->type_name("DIR/records.h5");
    verb->add_option("--budget", own->budget, "advise the most accurate setting within a time, such as 10ms, 0.5s, 800us")->type_name("TIME");
    verb->add_option("--error", own->error, "advise the fastest setting with this error or less, in mm, or such as 1um, 5nm")->type_name("LENGTH");
    verb->add_option("--page", own->page, "write the report as a page, its pictures into figures/ beside it")->check(name_fault)->type_name("FILE.md");
    verb->footer(studies_text() +
                 "Errors are distances in mm from a reference in 50 digits that is computed by another path: of the scene's own wave generator, motion model and tooth,\n"
                 "and of the flexspline where the circular spline is given, which has no union, contact-area and load. Outlines are measured in one plane, without coning, tilt and slices.\n"
                 "Motion models are compared with the exact one. "
                 "contact-area is measured against lengths in a thousand exact planes, load against its own finest rungs. What of the scene is left out is said in notes. The folder holds records.h5,\n"
                 "records.csv and, where gnuplot is installed, a picture of each study; it appears whole or not at all. Times are of this machine, as busy as it is.\n"
                 "Examples:\n"
                 "  hdconj accuracy drive.toml -o study\n"
                 "  hdconj accuracy --study tolerance,motion-model --sample 0\n"
                 "  hdconj accuracy --from study/records.h5 --budget 10ms --error 1e-6\n"
                 "  hdconj accuracy --from study/records.h5 --page accuracy.md");
    verb->callback([&common, own, sample, repeats] {
        own->sample_given = sample->count() > 0;
        own->repeats_given = repeats->count() > 0;
        common.action = [&common, own] { return run_accuracy(common, *own); };
    });
}

}  // namespace hdconj::cli
