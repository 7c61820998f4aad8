// SPDX-License-Identifier: GPL-3.0-or-later
#include "changed_scene.hpp"

#include <algorithm>
#include <string_view>

#include "hdconj/scene/schema.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// The family whose parameters stand in the table @p path of @p scene; null: none do.
FamilyChoice* family_at(Scene& scene, std::string_view path)
{
    if (path == scene.flexspline.profile.path)
        return &scene.flexspline.profile;
    if (scene.circular_spline.profile && path == scene.circular_spline.profile->path)
        return &*scene.circular_spline.profile;
    return path == scene.wave_generator.shape.path ? &scene.wave_generator.shape : nullptr;
}

void write(Scene& scene, std::string_view setting)
{
    if (setting == "!circular_spline.inner_radius")
        return scene.circular_spline.inner_radius.reset();
    std::size_t const equals = setting.find('=');
    std::string_view const path = setting.substr(0, equals), name = last_name(path),
                           table = path.substr(0, path.size() - name.size() - 1);
    Parameter const value{std::stod(std::string(setting.substr(equals + 1))), 0};
    if (TableSpec const* const spec = find_table(table)) {
        auto const key = std::ranges::find(spec->keys, name, [](KeySpec const& each) { return each.spec.key; });
        if (key != spec->keys.end())
            return key->member.store(scene, value);
    }
    if (FamilyChoice* const family = family_at(scene, table))
        family->given.insert_or_assign(std::string(name), value);
}

}  // namespace

Scene changed_scene(Scene scene, std::vector<std::string> const& settings)
{
    for (std::string const& setting : settings)
        write(scene, setting);
    return scene;
}

std::string key_of(std::string const& setting)
{
    return setting.starts_with('!') ? setting.substr(1) : setting.substr(0, setting.find('='));
}

std::string in_words(std::vector<std::string> const& settings)
{
    std::string written, left_out;
    for (std::string const& setting : settings) {
        bool const leaves = setting.starts_with('!');
        std::string& words = leaves ? left_out : written;
        words += words.empty() ? (leaves ? "leave " : "write ") : " and ";
        words += key_of(setting);
        if (!leaves)
            words += " = " + setting.substr(setting.find('=') + 1);
    }
    left_out += left_out.empty() ? "" : " out";
    return written + (written.empty() || left_out.empty() ? "" : ", and ") + left_out;
}

}  // namespace hdconj::scene
