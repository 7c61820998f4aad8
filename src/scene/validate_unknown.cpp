// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "base/text.hpp"
#include "hdconj/base/suggest.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

using Kind = RawValue::Kind;

void add_fault(Validation& validation, std::string const& spelled, RawEntry const& entry, std::string reason,
               std::string remedy)
{
    validation.reading.faults.push_back(
        fault_at(entry, printable(spelled), {std::move(reason), std::move(remedy)}, FaultKind::unknown));
}

bool has_member(RawValue const& table, std::string_view key)
{
    return std::ranges::find(table.entries, key, &RawEntry::key) != table.entries.end();
}

/// `profile` written as a top table: the path of the table with that last name.
std::optional<std::string> table_elsewhere(std::string_view name)
{
    for (auto const& table : scene_schema())
        if (last_name(table.path) == name)
            return std::string(table.path);
    return std::nullopt;
}

std::string remedy_for_table(Place const& place, RawEntry const& entry)
{
    if (auto const elsewhere = table_elsewhere(entry.key))
        return "write [" + *elsewhere + "]";
    auto const names = tables_in(place.path);
    return names.empty() ? "remove it: [" + place.path + "] has no sub-tables"
                         : "remove it; known here: " + plain_list(names);
}

/// Whether keys of @p table may be checked before the table itself: nothing has to be made or chosen first.
bool stands_alone(TableSpec const& table)
{
    return table.begin == nullptr && table.families == FamilyKind::none;
}

/// A misspelt table whose right name is free counts as that table, so that its keys are checked as well. When the
/// right name is there too, what that one lacks is taken over.
void validate_as(Validation& validation, Place const& place, std::string_view meant, RawEntry const& entry)
{
    std::string const right = join(place.path, meant);
    std::string const spelled = join(place.spelled, entry.key);
    auto const& spec = *find_table(right);
    auto const there = std::ranges::find(place.table->entries, meant, &RawEntry::key);
    if (there == place.table->entries.end()) {
        validate_table(validation, spec, spelled, entry);
        return;
    }
    for (auto const& member : entry.value.entries) {
        bool const is_table = find_table(join(right, member.key)) != nullptr;
        if ((is_table || stands_alone(spec)) && !has_member(there->value, member.key))
            validate_member(validation, {right, spelled, &entry.value}, member);
    }
}

void validate_unknown_table(Validation& validation, Place const& place, RawEntry const& entry)
{
    std::string const spelled = join(place.spelled, entry.key);
    auto const meant = nearest(entry.key, tables_in(place.path));
    if (!meant) {
        add_fault(validation, spelled, entry, "unknown table", remedy_for_table(place, entry));
        return;
    }
    add_fault(validation, spelled, entry, "unknown table", "write [" + join(place.path, *meant) + "]");
    if (entry.value.kind == Kind::table)
        validate_as(validation, place, *meant, entry);
}

std::vector<std::string_view> key_names(Validation const& validation, std::string const& path)
{
    std::vector<std::string_view> names;
    auto const* const table = find_table(path);
    if (table == nullptr)
        return names;
    for (auto const& key : table->keys)
        names.push_back(key.spec.key);
    for (auto const* const family : validation.families_of(path))
        for (auto const& spec : family->parameters)
            names.push_back(spec.key);
    return names;
}

/// A key of another family of the same table.
std::optional<std::string> family_with(SceneFamilies const& families, std::string const& path, std::string_view key)
{
    auto const* const table = find_table(path);
    for (auto const& family : families.of(table == nullptr ? FamilyKind::none : table->families))
        if (std::ranges::find(family.parameters, key, &ParameterSpec::key) != family.parameters.end())
            return std::string(family.name);
    return std::nullopt;
}

std::string remedy_for_key(Validation const& validation, Place const& place, RawEntry const& entry)
{
    if (auto const family = family_with(validation.families, place.path, entry.key))
        return "remove it: it is a key of family " + in_quotes(*family);
    if (place.path.empty())
        return "remove it; tables of a scene: " + plain_list(tables_in(""));
    return "remove it; known in [" + place.path + "]: " + plain_list(key_names(validation, place.path));
}

/// A misspelt key counts as the one that it means, so that its value is checked as well. Where a scene has both, that
/// one stands; a --set means to change it.
void validate_as_key(Validation& validation, Place const& place, std::string_view meant, RawEntry const& entry)
{
    std::string const name(meant);
    bool const both = has_member(*place.table, name);
    bool const replaces = !both || !entry.origin.empty();
    add_fault(validation, join(place.spelled, entry.key), entry, "unknown key",
              replaces ? "write " + name : "write " + name + ", or remove it: " + name + " is there as well");
    validation.attempted.insert(join(place.path, name));
    RawEntry right = entry;
    right.key = name;
    if (replaces)
        validate_member(validation, place, right);
}

void validate_unknown_key(Validation& validation, Place const& place, RawEntry const& entry)
{
    std::string const spelled = join(place.spelled, entry.key);
    bool const of_other_family = family_with(validation.families, place.path, entry.key).has_value();
    auto const meant = of_other_family ? std::nullopt : nearest(entry.key, key_names(validation, place.path));
    if (meant) {
        validate_as_key(validation, place, *meant, entry);
        return;
    }
    auto const elsewhere = of_other_family ? std::nullopt : key_elsewhere(entry.key, place.path, validation.families);
    if (elsewhere) {
        validation.attempted.insert(*elsewhere);
        add_fault(validation, spelled, entry, "this key belongs to another table", "write it as " + *elsewhere);
        return;
    }
    add_fault(validation, spelled, entry, "unknown key", remedy_for_key(validation, place, entry));
}

}  // namespace

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

void validate_unknown(Validation& validation, Place const& place, RawEntry const& entry)
{
    bool const is_list_of_tables = entry.value.kind == Kind::array && place.path.empty();
    if (entry.value.kind == Kind::table || is_list_of_tables)
        validate_unknown_table(validation, place, entry);
    else
        validate_unknown_key(validation, place, entry);
}

}  // namespace hdconj::scene
