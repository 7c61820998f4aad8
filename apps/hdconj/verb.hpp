// SPDX-License-Identifier: GPL-3.0-or-later
// What the verbs of the program share: registration, common options, the scene.
//
// A verb is one file with one function `add_<verb>(CLI::App&, CommonOptions&)`. It registers the verb with the
// function that runs it, and adds its options:
//
//     auto [verb, own] = add_verb(program, common, "solve", "the conjugate circular spline, into HDF5", run_solve);
//     add_scene_options(verb, common);
//     add_name(verb, "--dxf", own.dxf, "outlines for CAD", "FILE");
//
// The function that runs it reads the scene (examine), states its files and its computation, and hands them to
// run_verb (run_verb.hpp). Nothing runs while the command line is being parsed, so that an exception of a verb never
// meets the parser. main.cpp turns exceptions into exit statuses.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/scene/reading.hpp"

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
    std::string subject;                 ///< what faults are of where that is not `scene`; empty: it is
    std::vector<std::string> overrides;  ///< "key.path=value" of --set, in order
    bool json = false;                   ///< one JSON object on standard output instead of text
    bool quiet = false;                  ///< no messages on standard error, no summary
    bool strict = false;                 ///< warnings of the judgement make the exit status 1
    int threads = -1;                    ///< --threads; -1: as the scene says

    std::function<int()> action;  ///< what the chosen verb does; returns the exit status
};

/// A failure of one scene, where a verb reads several.
struct SceneFailure : NumericalError
{
    SceneFailure(NumericalError const& cause, std::string name) : NumericalError(cause), scene(std::move(name)) {}

    std::string scene;  ///< as scene_name() calls it
};

/// Registers the verb @p name, which calls @p run once the command line is parsed.
/// @return the verb and the options that are its own; both live as long as @p program
template <class Arguments>
std::pair<CLI::App&, Arguments&> add_verb(CLI::App& program, CommonOptions& common, std::string const& name,
                                          std::string const& meaning,
                                          int (*run)(CommonOptions const&, Arguments const&))
{
    CLI::App& verb = *program.add_subcommand(name, meaning);
    auto const own = std::make_shared<Arguments>();
    verb.callback([&common, own, run] { common.action = [&common, own, run] { return run(common, *own); }; });
    return {verb, *own};
}

/// Adds SCENE, --set, --threads, --json and --quiet to @p verb.
void add_scene_options(CLI::App& verb, CommonOptions& common);

/// Adds --set, --threads and --quiet to @p verb.
void add_computing_options(CLI::App& verb, CommonOptions& common);

/// Adds --strict to @p verb.
void add_strict(CLI::App& verb, CommonOptions& common);

/// The scene of @p common with its overrides and --threads, and every fault: of the text, of the values, and of the
/// geometry (check_scene).
[[nodiscard]] scene::SceneReading examine(CommonOptions const& common);

/// The same for a verb that needs a known neutral curve: where it is wanted, that is the only fault.
[[nodiscard]] scene::SceneReading examine_drive(CommonOptions const& common);

/// What examine_drive() reads, for a verb that computes.
/// @throws InputError with every fault, effects that this version does not compute among them
[[nodiscard]] Scene load_drive(CommonOptions const& common);

/// How messages call the scene of @p common: its file name, "standard input" or "the built-in scene".
[[nodiscard]] std::string scene_name(CommonOptions const& common);

/// @throws InputError with @p faults, if there are any
void refuse(Faults faults);

/// A fault where @p file is a folder, or without @p force there already: for verbs that write a file to be edited.
[[nodiscard]] Faults occupied(std::string const& file, bool force);

/// Appends @p more to @p all.
template <class Item>
void append(std::vector<Item>& all, std::vector<Item> const& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

void add_init(CLI::App& program, CommonOptions& common);
void add_design(CLI::App& program, CommonOptions& common);
void add_check(CLI::App& program, CommonOptions& common);
void add_solve(CLI::App& program, CommonOptions& common);
void add_contact(CLI::App& program, CommonOptions& common);
void add_load(CLI::App& program, CommonOptions& common);
void add_run(CLI::App& program, CommonOptions& common);
void add_wedm(CLI::App& program, CommonOptions& common);
void add_accuracy(CLI::App& program, CommonOptions& common);
void add_inspect(CLI::App& program, CommonOptions& common);
void add_export(CLI::App& program, CommonOptions& common);
void add_report(CLI::App& program, CommonOptions& common);

}  // namespace hdconj::cli
