// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj: parses the command line, runs one verb, turns exceptions into exit statuses.
#include <poll.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "command_faults.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/version.hpp"
#include "heap.hpp"
#include "verb.hpp"

namespace hdconj::cli {
namespace {

constexpr char const* examples =
    "Examples:\n"
    "  hdconj init                      write the built-in drive to hdconj.toml\n"
    "  hdconj design --ratio 100 --diameter 50 -o drive.toml\n"
    "                                   a drive by rules and by computation\n"
    "  hdconj check hdconj.toml         is it right, and what will be computed?\n"
    "  hdconj solve hdconj.toml         the conjugate circular spline\n"
    "  hdconj contact hdconj.toml       how much flank touches, and what tilt does to it\n"
    "  hdconj load hdconj.toml          the elastic cup, and the teeth under torque\n"
    "  hdconj run hdconj.toml           transmission error, friction and efficiency while it turns\n"
    "  hdconj wedm hdconj.toml          files to cut it by wire\n"
    "  hdconj accuracy hdconj.toml      what accuracy costs in time\n"
    "  hdconj inspect hdconj.toml points.csv\n"
    "                                   measured points against the nominal outline\n"
    "  hdconj export hdconj.toml --calculix deck\n"
    "                                   the elastic cup for CalculiX\n"
    "  hdconj study run study.toml -o DIR\n"
    "                                   many drives; the program hdconj-study of the Python package\n"
    "  hdconj solve --set wave_generator.radial_deformation=0.26\n"
    "                                   the built-in drive with one key changed\n"
    "Exit status: 0 done, 1 failed, 2 bad scene or bad command line.\n"
    "Data goes to standard output, talk to standard error.";

/// The file that @p fault is in; empty where it is one of the command line.
std::string file_of(CommonOptions const& common, Fault const& fault)
{
    if (!fault.origin.empty() && fault.origin != "--set")
        return fault.origin;
    bool const is_option = fault.path.starts_with('-') || fault.path == "POINTS";
    return common.scene.empty() || is_option ? "" : scene_name(common);
}

void print_faults(CommonOptions const& common, Faults const& faults)
{
    std::vector<std::string> files;
    for (Fault const& fault : faults)
        if (auto const file = file_of(common, fault); !file.empty() && std::ranges::find(files, file) == files.end())
            files.push_back(file);
    std::cerr << fmt::format("hdconj: {} {}{}{}\n", faults.size(), faults.size() == 1 ? "fault" : "faults",
                             files.empty() ? "" : " in ", fmt::join(files, " and "))
              << describe(faults) << '\n';
}

int fail(std::string const& cause)
{
    std::cerr << "hdconj: " << cause << '\n';
    return exit_failed;
}

/// Runs the chosen verb; the one place where exceptions become exit statuses.
int run_action(CommonOptions const& common)
{
    prepare_heap();
    leave_memory_at_exit();
    at_thread_start(prepare_heap_of_thread);
    try {
        return common.action();
    } catch (InputError const& error) {
        print_faults(common, error.faults());
        if (common.json)
            std::cout << check_json(scene_name(common), error.faults(), nullptr) << '\n';
        return exit_input;
    } catch (std::bad_alloc const&) {
        return fail("out of memory");
    } catch (SceneFailure const& failure) {
        if (common.json)
            std::cout << failure_json(failure.scene, failure) << '\n';
        return fail(failure.scene + ": " + failure.what());
    } catch (std::exception const& error) {
        if (common.json)
            std::cout << failure_json(scene_name(common), error) << '\n';
        return fail(error.what());
    }
}

/// Whether nobody reads standard output any more, as after `| head -1`: no failure of ours.
bool output_is_closed()
{
    pollfd standard_output{STDOUT_FILENO, 0, 0};
    return poll(&standard_output, 1, 0) > 0 && (standard_output.revents & POLLERR) != 0;
}

int flush_output(int status)
{
    std::cout.flush();
    bool const lost = !std::cout && !output_is_closed();
    return lost && status == exit_done ? fail("standard output cannot be written; is the disk full?") : status;
}

void describe_program(CLI::App& program)
{
    program.name("hdconj");
    program.set_version_flag("--version", [] {
        return "hdconj " + std::string(program_version()) + " (" + std::string(git_revision()) + ")\n" +
               std::string(build_description());
    });
    program.require_subcommand(0, 1);  // a scene may have the name of a verb
    program.footer(examples);
    program.get_formatter()->column_width(34);
}

/// The command line without the program's name; `help VERB` and `version` become the options of that meaning.
std::vector<std::string> command_line(int argc, char** argv)
{
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty())
        return words;
    if (words.front() == "version")
        words.front() = "--version";
    if (words.front() == "help") {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

/// Replaces this process by `hdconj-study`, beside this program or on the path, as git does with its commands.
/// @param words the command line from "study" on
/// @return exit_failed, with a message, where there is no such program; else nothing returns
int start_study_program(std::vector<std::string> words)
{
    std::string const name = "hdconj-study";
    words.front() = name;
    std::vector<char*> arguments;
    for (auto& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::signal(SIGPIPE, SIG_DFL);
    std::signal(SIGXFSZ, SIG_DFL);
    std::error_code none;
    auto const own = std::filesystem::read_symlink("/proc/self/exe", none);
    if (!none)
        execv((own.parent_path() / name).c_str(), arguments.data());
    execvp(name.c_str(), arguments.data());
    std::cerr << "hdconj: the verb study needs the program " << name << ", "
              << (errno == ENOENT ? "which is neither beside hdconj nor on the path"
                                  : "which cannot be run: " + std::generic_category().message(errno))
              << "; install it with: pip install 'hdconj[study]'\n";
    return exit_failed;
}

int run(int argc, char** argv)
{
    CLI::App program{
        "Conjugate tooth profiles of harmonic drives: from a flexspline tooth and a wave generator to the\n"
        "circular spline that meshes with it without interference."};
    describe_program(program);
    CommonOptions common;
    for (auto const add : {add_init, add_design, add_check, add_solve, add_contact, add_load, add_run, add_wedm,
                           add_accuracy, add_inspect, add_export, add_report})
        add(program, common);
    std::vector<std::string> words = command_line(argc, argv);
    if (words.empty()) {
        std::cerr << program.help();
        return exit_input;
    }
    if (words.front() == "study")
        return start_study_program(std::move(words));
    if (!words.front().starts_with('-') && !is_known_verb(program, words.front()))
        return exit_input;
    std::vector<std::string> const given = words;
    try {
        std::reverse(words.begin(), words.end());  // as CLI11 takes them
        program.parse(std::move(words));
    } catch (CLI::ValidationError const& stop) {
        std::vector<std::string> wrong = wrong_values(program);
        if (wrong.empty())
            wrong.emplace_back(stop.what());
        return refuse_command(wrong, given);
    } catch (CLI::ExtrasError const&) {
        std::vector<std::string> const unexpected = program.remaining(true);
        int const status =
            refuse_command({fmt::format("The following was not expected: {}", fmt::join(unexpected, " "))}, given);
        suggest_options(program, unexpected, common.scene);
        return status;
    } catch (CLI::ParseError const& stop) {
        return stop.get_exit_code() == 0 ? program.exit(stop) : refuse_command({stop.what()}, given);
    }
    return common.action ? run_action(common) : exit_input;
}

}  // namespace
}  // namespace hdconj::cli

int main(int argc, char** argv)
{
    // A reader that goes away must not kill a run that still has files to write.
    std::signal(SIGPIPE, SIG_IGN);
    // A limit on the size of files becomes a failed write, which says so.
    std::signal(SIGXFSZ, SIG_IGN);
    hdconj::file::remove_temporaries_when_interrupted();
    try {
        return hdconj::cli::flush_output(hdconj::cli::run(argc, argv));
    } catch (std::exception const& error) {
        return hdconj::cli::fail(error.what());
    }
}
