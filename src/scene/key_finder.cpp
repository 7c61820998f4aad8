// SPDX-License-Identifier: GPL-3.0-or-later
// Which key or table a user meant with a name that the schema does not have.
#include "validation.hpp"

#include <algorithm>

namespace hdconj::scene {

std::vector<FamilyDescription> const& SceneFamilies::of(FamilyKind kind) const
{
    static std::vector<FamilyDescription> const no_families;
    return kind == FamilyKind::profile ? profiles : kind == FamilyKind::wave_generator ? wave_generators : no_families;
}

TableSpec const* find_table(std::string_view path)
{
    auto const found = std::ranges::find(scene_schema(), path, &TableSpec::path);
    return found == scene_schema().end() ? nullptr : &*found;
}

std::string_view last_name(std::string_view path)
{
    std::size_t const dot = path.rfind('.');
    return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::vector<std::string_view> tables_in(std::string_view parent)
{
    std::vector<std::string_view> found;
    for (auto const& table : scene_schema())
        if (join(parent, last_name(table.path)) == table.path)
            found.push_back(last_name(table.path));
    return found;
}

std::vector<ParameterSpec const*> keys_of(TableSpec const& table, SceneFamilies const& families)
{
    std::vector<ParameterSpec const*> keys;
    for (auto const& key : table.keys)
        keys.push_back(&key.spec);
    for (auto const& family : families.of(table.families))
        for (auto const& parameter : family.parameters)
            keys.push_back(&parameter);
    return keys;
}

std::optional<std::string> key_elsewhere(std::string_view key, std::string_view except, SceneFamilies const& families)
{
    for (auto const& table : scene_schema()) {
        auto const keys = table.path == except ? std::vector<ParameterSpec const*>{} : keys_of(table, families);
        if (std::ranges::find(keys, key, &ParameterSpec::key) != keys.end())
            return join(table.path, key);
    }
    return std::nullopt;
}

std::string join(std::string_view parent, std::string_view name)
{
    return parent.empty() ? std::string(name) : std::string(parent) + "." + std::string(name);
}

}  // namespace hdconj::scene
