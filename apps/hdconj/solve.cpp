// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `solve`: the conjugate circular spline.
#include "hdconj/solve.hpp"

#include "arguments.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

/// What only `solve` is asked. Names are empty where nothing is asked for, here and in the other verbs.
struct SolveArguments
{
    std::string output;  ///< result file; empty: named after the scene file
    std::string dxf;
    std::string picture;
    std::string spline_tooth;   ///< points of the circular spline's tooth
    std::string cam;            ///< table of a curve that is wanted
    std::string inner_surface;  ///< of its cam
    std::string completed;      ///< scene of the drive with it
    bool verbose = false;
};

/// Options that only one of both problems has.
void check_options(Scene const& scene, SolveArguments const& own, Faults& faults)
{
    bool const wanted = scene.wants_neutral_curve();
    auto const keep_to = [&](char const* option, std::string const& value, bool of_wanted) {
        if (value.empty() || wanted == of_wanted)
            return;
        faults.push_back({option, 0, value,
                          wanted ? "the neutral curve is wanted, and there is no outline to draw before it is known"
                                 : "the neutral curve is given by the wave generator, and none is looked for",
                          wanted ? "write --completed DRIVE.toml, and this option with DRIVE.toml"
                                 : "leave it out, or give both teeth and wave_generator.family = \"wanted\""});
    };
    keep_to("--dxf", own.dxf, false);
    keep_to("--spline-tooth", own.spline_tooth, false);
    keep_to("--cam", own.cam, true);
    keep_to("--inner-surface", own.inner_surface, true);
    keep_to("--completed", own.completed, true);
}

/// The neutral curve between both given teeth.
int run_wanted(CommonOptions const& common, SolveArguments const& own, scene::SceneReading const& reading)
{
    Scene const& scene = reading.scene;
    Work<WantedCurve> work;
    work.faults = reading.faults;
    work.inputs = inputs_of(common, scene);
    add_file(work, "hdf5", "--output", output_name(common, own.output, scene, ".h5"),
             [](WantedCurve const& found, fs::path const& file) { write_hdf5(found, file); });
    add_file(work, "cam", "--cam", own.cam, write_cam_table);
    add_file(work, "inner_surface", "--inner-surface", own.inner_surface, write_inner_surface);
    add_file(work, "scene", "--completed", own.completed, write_completed_drive);
    if (!own.completed.empty())
        work.outputs.back().target.members = {completed_drive_cam(own.completed)};
    add_file(
        work, "picture", "--picture", own.picture,
        [](WantedCurve const& found, fs::path const& file) { write_picture(found, file); }, check_picture);
    work.compute = [&](ProgressLine const& progress) { return find_neutral_curve(scene, progress.stages()); };
    work.text = [](WantedCurve const& found, Written const& written) { return summary_text(found, written); };
    work.json = [](WantedCurve const& found, Written const& written) { return summary_json(found, written); };
    return run_verb(common, work);
}

int run_solve(CommonOptions const& common, SolveArguments const& own)
{
    auto reading = examine(common);
    Scene const& scene = reading.scene;
    sort_by_place(reading.faults);
    check_options(scene, own, reading.faults);
    if (scene.wants_neutral_curve())
        return run_wanted(common, own, reading);
    Work<Solution> work;
    work.faults = reading.faults;
    work.inputs = inputs_of(common, scene);
    add_file(work, "hdf5", "--output", output_name(common, own.output, scene, ".h5"),
             [](Solution const& solution, fs::path const& file) { write_hdf5(solution, file); });
    add_file(work, "dxf", "--dxf", own.dxf, write_dxf);
    add_file(work, "spline_tooth", "--spline-tooth", own.spline_tooth, write_spline_tooth);
    add_file(
        work, "picture", "--picture", own.picture,
        [](Solution const& solution, fs::path const& file) { write_picture(solution, file); }, check_picture);
    work.compute = [&](ProgressLine const& progress) {
        Solution solution = solve(scene, progress.stages());
        try_advice(solution);
        return solution;
    };
    work.text = [&](Solution const& solution, Written const& written) {
        return summary_text(solution, written, own.verbose ? SummaryDetail::zones : SummaryDetail::figures);
    };
    work.json = [](Solution const& solution, Written const& written) { return summary_json(solution, written); };
    work.judgement = [](Solution const& solution) { return solution.judgement; };
    return run_verb(common, work);
}

}  // namespace

void add_solve(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] = add_verb(program, common, "solve", "the conjugate circular spline, into HDF5", run_solve);
    add_scene_options(verb, common);
    add_strict(verb, common);
    add_name(verb, "-o,--output", own.output, "result file, HDF5 [the scene file's name and .h5, in this folder]",
             "FILE");
    add_name(verb, "--dxf", own.dxf, "outlines for CAD and wire machines, DXF R12", "FILE");
    add_name(verb, "--picture", own.picture, "drawing of the tooth space, needs gnuplot", "FILE.svg|FILE.png");
    add_name(verb, "--spline-tooth", own.spline_tooth,
             "right flank of the circular spline's tooth, its longest smooth piece, for [circular_spline.profile] and "
             "its family \"points\"",
             "FILE.csv");
    add_name(verb, "--cam", own.cam, "table of the wanted neutral curve, for wave_generator.family = \"table\"",
             "FILE.csv");
    add_name(verb, "--inner-surface", own.inner_surface, "surface of its cam, parallel to it", "FILE.csv");
    add_name(verb, "--completed", own.completed, "scene of the drive with it; its table in NAME-cam.csv", "NAME.toml");
    verb.add_flag("-v,--verbose", own.verbose, "list the conjugate zones in the summary");
}

}  // namespace hdconj::cli
