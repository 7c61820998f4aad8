// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `solve`: which files, in which order, and what is said about them.
#include "hdconj/pipeline/solve.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <functional>
#include <iostream>
#include <memory>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/result_files.hpp"
#include "outputs.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

/// What only `solve` is asked.
struct SolveOptions
{
    std::string output;   ///< result file; empty: named after the drive
    std::string dxf;      ///< empty: none
    std::string picture;  ///< empty: none
};

/// One file to write, and how.
struct Job
{
    OutputJob output;
    std::function<void(Solution const&, fs::path const&)> write;
};

std::vector<Job> jobs_of(SolveOptions const& own, Scene const& scene)
{
    fs::path const result = own.output.empty() ? fs::path(file_name(scene.drive.name) + ".h5") : fs::path(own.output);
    fs::path const dxf = own.dxf;
    fs::path const picture = own.picture;
    std::vector<Job> jobs = {{{"hdf5", "--output", result, [result] { check_target(result); }},
                              [](Solution const& s, fs::path const& f) { write_hdf5(s, f); }}};
    if (!own.dxf.empty()) {
        jobs.push_back({{"dxf", "--dxf", dxf, [dxf] { check_target(dxf); }}, write_dxf});
    }
    if (!own.picture.empty()) {
        jobs.push_back({{"picture", "--picture", picture, [picture] { check_picture(picture); }}, write_picture});
    }
    return jobs;
}

int run_solve(CommonOptions const& common, SolveOptions const& own)
{
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes a failed write, with its reason
    Scene const scene = load_scene(common);
    auto const jobs = jobs_of(own, scene);
    std::vector<OutputJob> outputs;
    for (auto const& job : jobs) {
        outputs.push_back(job.output);
    }
    check_outputs(outputs, inputs_of(common, scene));
    Progress const progress(!common.quiet);
    Solution const solution = solve(scene, [&](Stage stage) { progress.say(to_string(stage)); });
    std::vector<WrittenFile> written;
    for (auto const& job : jobs) {
        auto const& output = job.output;
        progress.say(output.kind);
        written.push_back(timed(output.kind, output.file, [&] { job.write(solution, output.file); }));
    }
    progress.clear();
    if (common.json) {
        std::cout << summary_json(solution, written);
    } else if (!common.quiet) {
        std::cout << summary_text(solution, written);
    }
    if (common.json && !common.quiet) {
        for (auto const& each : written) {
            std::cerr << "wrote " << each.file.string() << '\n';
        }
    }
    return exit_done;
}

}  // namespace

void add_solve(CLI::App& program, CommonOptions& common)
{
    auto* verb = program.add_subcommand("solve", "the conjugate circular spline, into HDF5");
    add_scene_options(*verb, common);
    auto own = std::make_shared<SolveOptions>();
    verb->add_option("-o,--output", own->output, "result file, HDF5 [the drive's name and .h5, in this folder]")
        ->check(name_fault)
        ->type_name("FILE");
    verb->add_option("--dxf", own->dxf, "outlines for CAD and wire machines, DXF R12")->check(name_fault)->type_name("FILE");
    verb->add_option("--picture", own->picture, "drawing of the tooth space, needs gnuplot")
        ->check(name_fault)
        ->type_name("FILE.svg|FILE.png");
    verb->callback([&common, own] { common.action = [&common, own] { return run_solve(common, *own); }; });
}

}  // namespace hdconj::cli
