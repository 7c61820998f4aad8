// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `solve`: the conjugate circular spline.
#include "hdconj/solve.hpp"

#include "arguments.hpp"
#include "hdconj/result_files.hpp"
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
    bool verbose = false;
};

int run_solve(CommonOptions const& common, SolveArguments const& own)
{
    Scene const scene = load_scene(common);
    Work<Solution> work;
    work.inputs = inputs_of(common, scene);
    add_file(work, "hdf5", "--output", output_name(common, own.output, scene, ".h5"),
             [](Solution const& solution, fs::path const& file) { write_hdf5(solution, file); });
    add_file(work, "dxf", "--dxf", own.dxf, write_dxf);
    add_file(work, "picture", "--picture", own.picture, write_picture, check_picture);
    work.compute = [&](ProgressLine const& progress) { return solve(scene, progress.stages()); };
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
    verb.add_flag("-v,--verbose", own.verbose, "list the conjugate zones in the summary");
}

}  // namespace hdconj::cli
