// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/read_scene.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "builtin_scene.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "scene_document.hpp"
#include "scene_text.hpp"

namespace hdconj {
namespace {

void append(Faults& faults, Faults more)
{
    std::move(more.begin(), more.end(), std::back_inserter(faults));
}

/// Parses @p text into @p document; the fault that stops it.
Faults parse(std::string_view text, std::string const& name, toml::table& document)
{
    if (auto faults = io::unparsable(text, name); !faults.empty())
        return faults;
    try {
        document = toml::parse(text);
    } catch (toml::parse_error const& error) {
        return {io::syntax_fault(error, text, name)};
    }
    return {};
}

scene::SceneReading validated(toml::table const& document, std::string_view text, std::string const& name,
                              std::filesystem::path const& folder, scene::NamedTexts files)
{
    if (document.empty()) {
        return {
            {}, {{name, 0, "", "the scene is empty", "write a scene; `hdconj init` writes one to edit"}}, {}, false};
    }
    return scene::validate_scene(io::raw_of(document, text),
                                 {profile::profile_families(), wavegen::wave_generator_families()}, folder,
                                 std::move(files));
}

/// An InputError on the way is a list of faults as well.
Faults geometry_faults(Scene const& scene)
{
    try {
        return scene.wants_neutral_curve() ? check_wanted_scene(scene) : check_scene(scene);
    } catch (InputError const& error) {
        return error.faults();
    }
}

Scene scene_or_throw(scene::SceneReading reading)
{
    if (!reading.faults.empty())
        throw InputError(std::move(reading.faults));
    return std::move(reading.scene);
}

}  // namespace

scene::SceneReading examine_scene(std::string_view text, std::string const& name, std::filesystem::path const& folder,
                                  std::vector<std::string> const& overrides, scene::NamedTexts files)
{
    toml::table document;
    Faults faults = parse(text, name, document);
    bool const has_document = faults.empty();
    append(faults, io::apply_overrides(document, overrides));
    scene::SceneReading reading;
    if (has_document)
        reading = validated(document, text, name, folder, std::move(files));
    append(reading.faults, std::move(faults));
    sort_by_place(reading.faults);
    reading.scene.text = overrides.empty() ? std::string(text) : io::toml_text(document);
    reading.scene.folder = folder;
    return reading;
}

scene::SceneReading examine_scene_file(std::filesystem::path const& file, std::vector<std::string> const& overrides)
{
    try {
        return examine_scene(io::read_scene_text(file), file.string(), file.parent_path(), overrides);
    } catch (InputError const& error) {
        return {{}, error.faults(), {}, false};
    }
}

void examine_geometry(scene::SceneReading& reading)
{
    if (!reading.geometry_known)
        return;
    auto found = geometry_faults(reading.scene);
    scene::locate(found, reading.scene);
    std::erase_if(found, [&reading](Fault const& fault) {
        return std::any_of(reading.faults.begin(), reading.faults.end(),
                           [&fault](Fault const& other) { return other.path == fault.path; });
    });
    append(reading.faults, std::move(found));
    sort_by_place(reading.faults);
}

Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides)
{
    return scene_or_throw(examine_scene_file(file, overrides));
}

Scene parse_scene(std::string_view text, std::string const& name, std::filesystem::path const& folder,
                  std::vector<std::string> const& overrides, scene::NamedTexts files)
{
    return scene_or_throw(examine_scene(text, name, folder, overrides, std::move(files)));
}

std::string_view builtin_scene_text()
{
    return io::builtin_scene;
}

Scene builtin_scene(std::vector<std::string> const& overrides)
{
    return parse_scene(builtin_scene_text(), "the built-in scene", {}, overrides);
}

}  // namespace hdconj
