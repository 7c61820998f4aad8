// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "hdconj/io/scene_reading.hpp"
#include "hdconj/io/scene_toml.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::cli {
namespace {

/// Standard input up to one byte more than a scene may have.
std::string standard_input()
{
    std::string text(largest_scene + 1, '\0');
    std::cin.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::cin.gcount()));
    return text;
}

std::vector<std::string> all_overrides(CommonOptions const& common)
{
    auto overrides = common.overrides;
    if (common.threads >= 0) {
        overrides.push_back("solver.threads=" + std::to_string(common.threads));
    }
    return overrides;
}

SceneReading read(CommonOptions const& common)
{
    auto const overrides = all_overrides(common);
    if (common.scene.empty()) {
        return examine_scene(builtin_scene_text(), scene_name(common), {}, overrides);
    }
    return common.scene == "-" ? examine_scene(standard_input(), scene_name(common), {}, overrides)
                               : examine_scene_file(common.scene, overrides);
}

}  // namespace

void add_scene_options(CLI::App& verb, CommonOptions& common)
{
    // An empty name, as from an unset shell variable, must not quietly mean the built-in drive.
    auto const not_empty = [](std::string const& name) { return name.empty() ? std::string("an empty name") : ""; };
    verb.add_option("SCENE", common.scene, "scene file in TOML; - for standard input; absent: the built-in drive")
        ->check(not_empty);
    verb.add_option("--set", common.overrides,
                    "change a key of the scene, such as --set flexspline.wall=0.8; repeatable")
        ->type_name("KEY=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    verb.add_option("--threads", common.threads, "threads; 0: all cores")
        ->check(CLI::Range(0, bounds::most_threads))
        ->type_name("N");
    verb.add_flag("--json", common.json, "one JSON object on standard output");
    verb.add_flag("--quiet", common.quiet, "no summary and no progress");
}

SceneReading examine(CommonOptions const& common)
{
    auto reading = read(common);
    examine_geometry(reading);
    return reading;
}

Scene load_scene(CommonOptions const& common)
{
    auto reading = examine(common);
    sort_by_place(reading.faults);
    if (!reading.faults.empty()) {
        throw InputError(std::move(reading.faults));
    }
    return std::move(reading.scene);
}

std::string scene_name(CommonOptions const& common)
{
    if (common.scene.empty()) {
        return "the built-in scene";
    }
    return common.scene == "-" ? "standard input" : common.scene;
}

}  // namespace hdconj::cli
