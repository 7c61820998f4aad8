// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the verbs of the program share: common options, registration, reading of the scene.
///
/// A verb is one file with one function `add_<verb>(CLI::App&, CommonOptions&)`. It adds a subcommand, keeps the
/// verb's own options alive in a shared_ptr, and sets `common.action` in the subcommand's callback:
///
///     auto* verb = program.add_subcommand("solve", "the conjugate circular spline, into HDF5");
///     add_scene_options(*verb, common);
///     auto own = std::make_shared<SolveOptions>();
///     verb->add_option("-o,--output", own->output, "result file");
///     verb->callback([&common, own] { common.action = [&common, own] { return run_solve(common, *own); }; });
///
/// Nothing runs while the command line is still being parsed, so that an exception of the action never meets the
/// parser. main.cpp turns exceptions into exit statuses; verbs do not catch.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/reading.hpp"
#include "hdconj/scene/scene.hpp"

namespace CLI {
class App;
}

namespace hdconj::cli {

/// Exit statuses of the program.
enum ExitStatus : int
{
    exit_done = 0,    ///< done
    exit_failed = 1,  ///< numerical failure, disk full: the message says what
    exit_input = 2    ///< bad scene or bad command line
};

/// Options that every verb working on a scene has, and the verb chosen.
struct CommonOptions
{
    std::string scene;                   ///< scene file, "-" for standard input; empty: the built-in scene
    std::vector<std::string> overrides;  ///< "key.path=value" of --set, in order
    bool json = false;                   ///< one JSON object on standard output instead of text
    bool quiet = false;                  ///< no talk on standard error, no summary
    int threads = -1;                    ///< --threads; -1: as the scene says

    std::function<int()> action;  ///< what the chosen verb does; returns the exit status
};

/// Adds SCENE, --set, --threads, --json and --quiet to @p verb.
void add_scene_options(CLI::App& verb, CommonOptions& common);

/// The scene of @p common with its overrides and --threads, and every fault: of the text, of the values, and of the
/// geometry (check_scene).
[[nodiscard]] SceneReading examine(CommonOptions const& common);

/// The same for a verb that computes.
/// @throws InputError with every fault, effects that this version does not compute among them
[[nodiscard]] Scene load_scene(CommonOptions const& common);

/// How messages call the scene of @p common: its file name, "standard input" or "the built-in scene".
[[nodiscard]] std::string scene_name(CommonOptions const& common);

void add_init(CLI::App& program, CommonOptions& common);
void add_check(CLI::App& program, CommonOptions& common);
void add_solve(CLI::App& program, CommonOptions& common);
void add_contact(CLI::App& program, CommonOptions& common);
void add_load(CLI::App& program, CommonOptions& common);
void add_wedm(CLI::App& program, CommonOptions& common);
void add_accuracy(CLI::App& program, CommonOptions& common);
void add_export(CLI::App& program, CommonOptions& common);

}  // namespace hdconj::cli
