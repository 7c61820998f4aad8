// SPDX-License-Identifier: GPL-3.0-or-later
#include "verb.hpp"

#include <iostream>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/wavegen/registry.hpp"

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

}  // namespace

void add_scene_options(CLI::App& verb, CommonOptions& common)
{
    // An empty name, as from an unset shell variable, must not quietly mean the built-in drive.
    auto const not_empty = [](std::string const& name) { return name.empty() ? std::string("an empty name") : ""; };
    verb.add_option("SCENE", common.scene, "scene file in TOML; - for standard input; absent: the built-in drive")
        ->check(not_empty);
    add_computing_options(verb, common);
    verb.add_flag("--json", common.json, "one JSON object on standard output");
}

void add_computing_options(CLI::App& verb, CommonOptions& common)
{
    verb.add_option("--set", common.overrides,
                    "change a key of the scene, such as --set flexspline.wall=0.8; repeatable")
        ->type_name("KEY=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    verb.add_option("--threads", common.threads, "threads; 0: all cores, at most OMP_NUM_THREADS")
        ->check(whole_number(0, scene::bounds::most_threads))
        ->type_name("N");
    verb.add_flag("-q,--quiet", common.quiet, "no summary and no progress");
}

void add_strict(CLI::App& verb, CommonOptions& common)
{
    verb.add_flag("--strict", common.strict, "exit status 1 where the judgement of the design holds a warning");
}

scene::SceneReading examine(CommonOptions const& common)
{
    auto overrides = common.overrides;
    if (common.threads >= 0)
        overrides.push_back("solver.threads=" + std::to_string(common.threads));
    bool const is_file = !common.scene.empty() && common.scene != "-";
    auto reading = is_file ? examine_scene_file(common.scene, overrides)
                           : examine_scene(common.scene.empty() ? std::string(builtin_scene_text()) : standard_input(),
                                           scene_name(common), {}, overrides);
    examine_geometry(reading);
    return reading;
}

scene::SceneReading examine_drive(CommonOptions const& common)
{
    auto reading = examine(common);
    if (reading.scene.wants_neutral_curve()) {
        reading.faults.clear();
        static_cast<void>(wavegen::build_wave_shape(reading.scene.wave_generator.shape, {}, reading.faults));
    }
    return reading;
}

Scene load_drive(CommonOptions const& common)
{
    auto reading = examine_drive(common);
    sort_by_place(reading.faults);
    refuse(std::move(reading.faults));
    return std::move(reading.scene);
}

std::string scene_name(CommonOptions const& common)
{
    if (common.scene.empty())
        return common.subject.empty() ? "the built-in scene" : common.subject;
    return common.scene == "-" ? "standard input" : common.scene;
}

void refuse(Faults faults)
{
    if (!faults.empty())
        throw InputError(std::move(faults));
}

}  // namespace hdconj::cli
