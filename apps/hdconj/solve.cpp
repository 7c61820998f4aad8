// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `solve`: which files, in which order, and what is said about them.
#include "hdconj/pipeline/solve.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <chrono>
#include <csignal>
#include <functional>
#include <iostream>
#include <memory>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/result_files.hpp"

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

/// One file to write.
struct Job
{
    std::string kind;    ///< "hdf5", "dxf", "picture"
    std::string option;  ///< for messages
    fs::path file;
    std::function<void(Solution const&, fs::path const&)> write;
};

[[noreturn]] void refuse(Job const& job, std::string const& reason, std::string const& remedy)
{
    throw InputError(Fault{job.option, 0, job.file.string(), reason, "write " + remedy});
}

/// Both names stand for one file, whether it exists or not.
bool same_file(fs::path const& a, fs::path const& b)
{
    std::error_code error;
    return fs::equivalent(a, b, error) ||
           fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

/// A file name made of a drive's name: letters of any script, digits, and "._-" stay.
std::string file_name(std::string const& drive)
{
    constexpr std::size_t longest = 100;  // bytes, well below what file systems take
    constexpr unsigned char beyond_ascii = 0x80, continues = 0x80, mask = 0xC0;
    std::string name;
    for (char const c : drive.substr(0, longest)) {
        auto const byte = static_cast<unsigned char>(c);
        bool const kept = byte >= beyond_ascii || std::isalnum(byte) != 0 || c == '.' || c == '_' || c == '-';
        name += kept ? c : '-';
    }
    if (drive.size() > longest) {
        std::size_t cut = longest;
        while (cut > 0 && (static_cast<unsigned char>(drive[cut]) & mask) == continues) {
            --cut;
        }
        name.resize(cut);
    }
    name.erase(0, name.find_first_not_of(".-"));  // no hidden file, nothing that looks like an option
    return name.empty() ? "drive" : name;
}

std::vector<Job> jobs_of(SolveOptions const& own, Scene const& scene)
{
    fs::path const result = own.output.empty() ? fs::path(file_name(scene.drive.name) + ".h5") : fs::path(own.output);
    std::vector<Job> jobs = {{"hdf5", "--output", result, write_hdf5}};
    if (!own.dxf.empty()) {
        jobs.push_back({"dxf", "--dxf", own.dxf, write_dxf});
    }
    if (!own.picture.empty()) {
        jobs.push_back({"picture", "--picture", own.picture, write_picture});
    }
    return jobs;
}

/// Everything about the targets that can be known before the long work.
void check_jobs(std::vector<Job> const& jobs, std::string const& scene)
{
    for (auto const& job : jobs) {
        if (job.file == "-") {
            refuse(job, "results are files and do not go to standard output",
                   "a file name; --json prints the figures to standard output");
        }
        if (!scene.empty() && scene != "-" && same_file(job.file, scene)) {
            refuse(job, "this is the scene file, the result would replace it", "another name");
        }
        for (auto const& other : jobs) {
            if (&other != &job && same_file(other.file, job.file)) {
                refuse(job, "is given to " + other.option + " too", "another name");
            }
        }
    }
    for (auto const& job : jobs) {
        if (job.kind == "picture") {
            check_picture(job.file);
        } else {
            check_target(job.file);
        }
    }
}

WrittenFile run(Job const& job, Solution const& solution)
{
    auto const begin = std::chrono::steady_clock::now();
    job.write(solution, job.file);
    std::chrono::duration<double> const taken = std::chrono::steady_clock::now() - begin;
    return {job.kind, job.file, taken.count()};
}

/// On a terminal, names the stage that runs, over and over in one line; where nobody looks it says nothing.
class Progress
{
  public:
    explicit Progress(bool wanted) : shown_(wanted && ::isatty(STDERR_FILENO) == 1) {}
    ~Progress() { clear(); }
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    void say(std::string const& what) const
    {
        if (shown_) {
            std::cerr << erase_line << what << " ..." << std::flush;
        }
    }
    void clear() const
    {
        if (shown_) {
            std::cerr << erase_line << std::flush;
        }
    }

  private:
    static constexpr char const* erase_line = "\r\033[K";
    bool shown_;
};

int run_solve(CommonOptions const& common, SolveOptions const& own)
{
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes a failed write, with its reason
    Scene const scene = load_scene(common);
    auto const jobs = jobs_of(own, scene);
    check_jobs(jobs, common.scene);
    Progress const progress(!common.quiet);
    Solution const solution = solve(scene, [&](Stage stage) { progress.say(to_string(stage)); });
    std::vector<WrittenFile> written;
    for (auto const& job : jobs) {
        progress.say(job.kind);
        written.push_back(run(job, solution));
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
        ->type_name("FILE");
    verb->add_option("--dxf", own->dxf, "outlines for CAD and wire machines, DXF R12")->type_name("FILE");
    verb->add_option("--picture", own->picture, "drawing of the tooth space, needs gnuplot")
        ->type_name("FILE.svg|FILE.png");
    verb->callback([&common, own] { common.action = [&common, own] { return run_solve(common, *own); }; });
}

}  // namespace hdconj::cli
