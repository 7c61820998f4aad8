// SPDX-License-Identifier: GPL-3.0-or-later
#include "key_finder.hpp"

#include <algorithm>

namespace hdconj::scene {

std::vector<FamilyDescription> const& SceneFamilies::of(FamilyKind kind) const
{
    static std::vector<FamilyDescription> const no_families;
    switch (kind) {
        case FamilyKind::profile:
            return profiles;
        case FamilyKind::wave_generator:
            return wave_generators;
        case FamilyKind::none:
            break;
    }
    return no_families;
}

namespace {

std::string_view parent_of(std::string_view path)
{
    std::size_t const dot = path.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

}  // namespace

TableSpec const* find_table(std::string_view path)
{
    for (auto const& table : scene_schema()) {
        if (table.path == path)
            return &table;
    }
    return nullptr;
}

std::string_view last_name(std::string_view path)
{
    std::size_t const dot = path.rfind('.');
    return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::vector<std::string_view> tables_in(std::string_view parent)
{
    std::vector<std::string_view> found;
    for (auto const& table : scene_schema()) {
        if (parent_of(table.path) == parent)
            found.push_back(table.path);
    }
    return found;
}

std::vector<ParameterSpec const*> keys_of(TableSpec const& table, SceneFamilies const& families)
{
    std::vector<ParameterSpec const*> keys;
    for (auto const& key : table.keys)
        keys.push_back(&key.spec);
    for (auto const& family : families.of(table.families)) {
        for (auto const& parameter : family.parameters)
            keys.push_back(&parameter);
    }
    return keys;
}

std::optional<std::string> key_elsewhere(std::string_view key, std::string_view except, SceneFamilies const& families)
{
    for (auto const& table : scene_schema()) {
        auto const keys = table.path == except ? std::vector<ParameterSpec const*>{} : keys_of(table, families);
        if (std::any_of(keys.begin(), keys.end(), [key](ParameterSpec const* spec) { return spec->key == key; }))
            return join(table.path, key);
    }
    return std::nullopt;
}

std::string join(std::string_view parent, std::string_view name)
{
    return parent.empty() ? std::string(name) : std::string(parent) + "." + std::string(name);
}

}  // namespace hdconj::scene
