// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `accuracy`: error against time, and what is advised.
#include "hdconj/accuracy.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>

#include "arguments.hpp"
#include "hdconj/accuracy_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/schema.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct AccuracyArguments
{
    std::vector<std::string> studies;  ///< empty: all
    bool quick = false;
    std::optional<int> sample;
    std::optional<int> repeats;
    std::string output;  ///< folder; empty: named after the scene file
    std::string from;    ///< records measured before; empty: measure
    std::string page;
    std::optional<std::string> budget;  ///< as written
    std::optional<std::string> error;
};

/// A number with one of these units, in the first unit; nothing where it is none.
std::optional<double> with_unit(std::string const& text, std::vector<std::pair<std::string, double>> const& units)
{
    char* end = nullptr;
    double const value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || !(value > 0) || !(value < 1e9))
        return {};
    for (auto const& [name, factor] : units)
        if (end == name)
            return value * factor;
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

AccuracyOptions options_of(AccuracyArguments const& own)
{
    constexpr int sample_of_quick = 3;
    AccuracyOptions options;
    options.studies = own.studies;
    options.quick = own.quick;
    options.sample = own.sample.value_or(own.quick ? sample_of_quick : options.sample);
    options.repeats = own.repeats.value_or(options.repeats);
    return options;
}

/// What is wrong with the options by themselves.
Faults option_faults(AccuracyArguments const& own)
{
    Faults faults = check_studies(options_of(own));
    if (own.budget && !seconds_of(*own.budget))
        faults.push_back(
            {"--budget", 0, *own.budget, "this is no time", "write a number with s, ms or us, such as 10ms"});
    if (own.error && !millimetres_of(*own.error))
        faults.push_back(
            {"--error", 0, *own.error, "this is no length", "write a number above 0 in mm, or with um or nm"});
    std::string const ending = fs::path(own.page).extension().string();
    if (!own.page.empty() && own.page != "-" && ending != ".md" && ending != ".markdown")
        faults.push_back(
            {"--page", 0, own.page, "a page is written in Markdown",
             "write a name that ends in .md, such as " + fs::path(own.page).replace_extension(".md").string()});
    return faults;
}

Output<StoredAccuracy> folder_output(fs::path const& folder, std::string const& drive)
{
    OutputTarget target{"folder", "--output", folder, [folder, drive] { check_accuracy_folder(folder, drive); }};
    target.is_folder = true;
    return {target, [folder](StoredAccuracy const& study) { return write_accuracy_folder(study, folder); }};
}

/// A page with the pictures that may lie beside it.
Output<StoredAccuracy> page_output(std::string const& page)
{
    OutputTarget target{"page", "--page", page, [page] { file::check_target(page); }};
    for (auto const& kind : study_kinds())
        target.members.push_back(accuracy_figure(page, std::string(kind.name)));
    return {target, [page](StoredAccuracy const& study) { return write_accuracy_page(study, page); }};
}

/// Studies of a scene that are to be measured.
Work<StoredAccuracy> measurement(CommonOptions const& common, AccuracyArguments const& own)
{
    scene::SceneReading reading = examine_drive(common);
    sort_by_place(reading.faults);
    Faults faults = std::move(reading.faults);
    Scene const scene = std::move(reading.scene);
    AccuracyOptions const options = options_of(own);
    if (faults.empty()) {
        // Only of studies that there are: the others are reported once, by option_faults.
        AccuracyOptions known = options;
        std::erase_if(known.studies,
                      [](std::string const& name) { return !check_studies({.studies = {name}}).empty(); });
        if (!known.studies.empty())
            append(faults, check_accuracy(scene, known));
    }
    append(faults, option_faults(own));
    refuse(std::move(faults));
    Work<StoredAccuracy> work;
    work.inputs = inputs_of(common, scene);
    work.outputs = {folder_output(output_name(common, own.output, scene, "-accuracy"), scene.drive.name)};
    work.compute = [scene, options](ProgressLine const& progress) {
        return StoredAccuracy{measure_accuracy(scene, options, progress.shares()), this_program()};
    };
    return work;
}

/// What asks for a measurement, and --from is not one.
Faults from_faults(CommonOptions const& common, AccuracyArguments const& own)
{
    Faults faults;
    if (!common.scene.empty() || !common.overrides.empty())
        faults.push_back({"--from", 0, own.from, "stored records have a scene of their own, and another is given",
                          "leave SCENE and --set out, or --from"});
    std::vector<std::string> asked;
    for (auto const& [given, option] : {std::pair(!own.studies.empty(), "--study"),
                                        {own.quick, "--quick"},
                                        {own.sample.has_value(), "--sample"},
                                        {own.repeats.has_value(), "--repeats"}})
        if (given)
            asked.emplace_back(option);
    bool const one = asked.size() == 1;
    if (!asked.empty())
        faults.push_back(
            {"--from", 0, own.from,
             fmt::format("nothing is measured anew, and {} {} for it", fmt::join(asked, ", "), one ? "asks" : "ask"),
             one ? "leave one of them out" : "leave them out, or --from"});
    return faults;
}

/// Studies that were measured before.
Work<StoredAccuracy> stored(CommonOptions const& common, AccuracyArguments const& own)
{
    Faults faults = from_faults(common, own);
    append(faults, option_faults(own));
    StoredAccuracy study;
    try {
        study = read_accuracy(own.from);
    } catch (InputError const& error) {
        append(faults, error.faults());
    }
    refuse(std::move(faults));
    Work<StoredAccuracy> work;
    work.inputs = input_of("--from", own.from);
    if (!own.output.empty()) {
        work.outputs = {folder_output(own.output, study.report.scene.drive.name)};
        // The folder of the records may be named: they are written again, the same.
        work.outputs.back().target.is_folder = false;
    }
    work.compute = [study = std::move(study)](ProgressLine const&) { return study; };
    return work;
}

int run_accuracy(CommonOptions const& common, AccuracyArguments const& own)
{
    Work<StoredAccuracy> work = own.from.empty() ? measurement(common, own) : stored(common, own);
    if (!own.page.empty())
        work.outputs.push_back(page_output(own.page));
    AccuracyAdvice const advice{own.error ? millimetres_of(*own.error) : std::nullopt,
                                own.budget ? seconds_of(*own.budget) : std::nullopt};
    work.text = [&](StoredAccuracy const& study, Written const&) { return summary_text(study, advice); };
    work.json = [&](StoredAccuracy const& study, Written const& written) {
        return summary_json(study, advice, written);
    };
    work.wrote = [](StoredAccuracy const&, Written const& written) { return names_of(written); };
    return run_verb(common, work);
}

std::string studies_text()
{
    std::string text = "Studies:\n";
    for (auto const& kind : study_kinds())
        text += fmt::format("  {:<16}{}\n", kind.name, kind.question);
    return text;
}

constexpr char const* footer =
    "Errors are distances in mm from a reference in 50 digits, which another method computes for the scene's own wave "
    "generator, motion model and tooth. Those of contact-area are areas in mm^2, those of load relative.\n"
    "Outlines are compared in one plane, without coning, tilt and slices. Motion models are compared with the exact "
    "one, and load with its own finest levels.\n"
    "contact-area and load have the tooth surface of [slices], or an outline per slice where there is no such table. "
    "Areas of outlines per slice are compared with lengths in a thousand exact planes, others with many slices.\n"
    "Where the circular spline is given, union, contact-area and load are left out. "
    "Notes say what else was.\n"
    "The folder holds records.h5, records.csv and, where gnuplot is installed, a picture of each study. It appears "
    "whole or not at all. Times depend on how busy this machine is.\n"
    "Examples:\n"
    "  hdconj accuracy drive.toml -o study\n"
    "  hdconj accuracy --study tolerance,motion-model --sample 0\n"
    "  hdconj accuracy --from study/records.h5 --budget 10ms --error 1e-6\n"
    "  hdconj accuracy --from study/records.h5 --page accuracy.md";

}  // namespace

void add_accuracy(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "accuracy",
                 "what accuracy costs in time: error against time of every method and setting", run_accuracy);
    add_scene_options(verb, common);
    add_list(verb, "--study", own.studies, "studies to run, see below [all]", "NAME,...");
    add_name(verb, "-o,--output", own.output,
             "folder to make [the scene file's name and -accuracy, in this folder; with --from none]", "DIR");
    add_option(verb, "--sample", own.sample, "random designs around the scene; the worst of them is reported too [64]",
               "N", whole_number(0, scene::bounds::most_designs));
    add_option(verb, "--repeats", own.repeats, "runs of each setting; the median counts [5]", "N",
               whole_number(1, scene::bounds::most_repeats));
    verb.add_flag("--quick", own.quick,
                  "short convergence series, one run of each setting, 3 designs: seconds instead of ten minutes");
    add_name(verb, "--from", own.from, "read records that were measured before instead of measuring", "DIR/records.h5");
    verb.add_option("--budget", own.budget, "advise the most accurate setting within a time, such as 10ms, 0.5s, 800us")
        ->type_name("TIME");
    verb.add_option("--error", own.error,
                    "advise the fastest setting with this error or less, in mm, or such as 1um, 5nm")
        ->type_name("LENGTH");
    add_name(verb, "--page", own.page, "write the report as a page, its pictures into figures/ beside it", "FILE.md");
    verb.footer(studies_text() + footer);
}

}  // namespace hdconj::cli
