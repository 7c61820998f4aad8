// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "base/text.hpp"
#include "hdconj/base/suggest.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

using Kind = RawValue::Kind;

/// The families that the key `family` of @p table leaves possible.
std::vector<FamilyDescription const*> possible_families(std::vector<FamilyDescription> const& registered,
                                                        RawValue const& table)
{
    std::vector<FamilyDescription const*> possible;
    std::vector<std::string_view> names;
    for (auto const& family : registered) {
        possible.push_back(&family);
        names.push_back(family.name);
    }
    for (auto const& entry : table.entries) {
        bool const is_name = entry.key == "family" && entry.value.kind == Kind::text;
        auto const meant = is_name ? nearest(entry.value.text, names) : std::nullopt;
        if (meant)
            std::erase_if(possible, [&meant](FamilyDescription const* family) { return family->name != *meant; });
    }
    return possible;
}

/// The value of @p entry for key @p spec of @p table, or nothing after a fault.
std::optional<Parameter> take_value(Validation& validation, TableSpec const& table, ParameterSpec const& spec,
                                    std::string_view example, RawEntry const& entry, std::string const& spelled)
{
    std::string const path = join(table.path, spec.key);
    validation.attempted.insert(path);
    validation.reading.scene.given[path] = {entry.line, entry.value.written};
    if (entry.value.kind == Kind::text && (spec.quantity == Quantity::file || takes_file(spec)))
        validation.reading.file_names[path] = entry.value.text;
    auto verdict = validate_value(spec, example, entry, spelled, validation.reading.scene);
    if (auto* const faults = std::get_if<Faults>(&verdict)) {
        std::move(faults->begin(), faults->end(), std::back_inserter(validation.reading.faults));
        return std::nullopt;
    }
    validation.reading.known.insert(path);
    return std::get<Parameter>(std::move(verdict));
}

bool take_own_key(Validation& validation, TableSpec const& table, RawEntry const& entry, std::string const& spelled)
{
    auto const key = std::ranges::find(table.keys, entry.key, [](KeySpec const& each) { return each.spec.key; });
    if (key == table.keys.end())
        return false;
    auto const spec = with_family_names(validation.families, table, key->spec);
    if (auto const parameter = take_value(validation, table, spec, key->example, entry, spelled))
        key->member.store(validation.reading.scene, *parameter);
    return true;
}

/// Where the values of the family's keys of @p table go.
FamilyChoice& choice_of(Scene& scene, TableSpec const& table)
{
    if (table.families == FamilyKind::wave_generator)
        return scene.wave_generator.shape;
    bool const outside = scene.circular_spline.profile && table.path == scene.circular_spline.profile->path;
    return outside ? *scene.circular_spline.profile : scene.flexspline.profile;
}

bool take_family_key(Validation& validation, TableSpec const& table, RawEntry const& entry, std::string const& spelled)
{
    auto& choice = choice_of(validation.reading.scene, table);
    for (auto const* const family : validation.families_of(table.path)) {
        auto const spec = std::ranges::find(family->parameters, entry.key, &ParameterSpec::key);
        if (spec == family->parameters.end())
            continue;
        if (auto parameter = take_value(validation, table, *spec, "", entry, spelled))
            choice.given.insert_or_assign(entry.key, std::move(*parameter));
        return true;
    }
    return false;
}

Fault value_for_table(TableSpec const& spec, std::string const& spelled, RawEntry const& entry)
{
    std::string const header = "[" + std::string(spec.path) + "]";
    std::string const found = entry.value.kind == Kind::array ? "a list" : "a value";
    return fault_at(
        entry, spelled,
        {found + " where the table " + header + " belongs", "write the line " + header + " and its keys below it"});
}

/// @p value as though it stood in a file.
RawValue raw_value(ParameterSpec const& spec, ParameterValue const& value)
{
    RawValue raw;
    if (auto const* const number = std::get_if<double>(&value)) {
        raw.kind = spec.quantity == Quantity::count ? Kind::integer : Kind::number;
        raw.number = *number;
    } else if (auto const* const text = std::get_if<std::string>(&value)) {
        raw.kind = Kind::text;
        raw.text = *text;
    } else {
        raw.kind = Kind::array;
        for (auto const& row : std::get<NumberRows>(value)) {
            RawValue& item = raw.items.emplace_back();
            item.kind = Kind::array;
            for (double const each : row) {
                item.items.emplace_back().kind = Kind::number;
                item.items.back().number = each;
            }
        }
    }
    return raw;
}

/// Enters what is wrong with the value that @p key of @p table has in the scene, and whether it is known.
void check_value(TableSpec const& table, KeySpec const& key, SceneReading& reading)
{
    auto const value = key.member.read != nullptr ? key.member.read(reading.scene) : std::nullopt;
    if (!value)
        return;
    std::string const path = join(table.path, key.spec.key);
    RawEntry const entry{std::string(key.spec.key), raw_value(key.spec, *value), 0, ""};
    auto verdict = validate_value(key.spec, key.example, entry, path, reading.scene);
    if (auto* const faults = std::get_if<Faults>(&verdict)) {
        for (Fault& fault : *faults) {
            if (fault.value.empty())
                fault.value = value_text(*value);
            reading.faults.push_back(std::move(fault));
        }
        return;
    }
    reading.known.insert(path);
    if (key.standard != value)
        reading.scene.given.try_emplace(path);  // as though it were written there
}

}  // namespace

void validate_member(Validation& validation, Place const& place, RawEntry const& entry)
{
    std::string const spelled = join(place.spelled, entry.key);
    if (auto const* const table = find_table(join(place.path, entry.key))) {
        validate_table(validation, *table, spelled, entry);
        return;
    }
    auto const* const table = find_table(place.path);
    bool const taken = table != nullptr && (take_own_key(validation, *table, entry, spelled) ||
                                            take_family_key(validation, *table, entry, spelled));
    if (!taken)
        validate_unknown(validation, place, entry);
}

void validate_table(Validation& validation, TableSpec const& spec, std::string const& spelled, RawEntry const& entry)
{
    std::string const path(spec.path);
    validation.attempted.insert(path);
    if (entry.value.kind != Kind::table) {
        validation.reading.faults.push_back(value_for_table(spec, spelled, entry));
        return;
    }
    validation.visits[path] = {entry.line, entry.origin,
                               possible_families(validation.families.of(spec.families), entry.value)};
    validation.reading.scene.given[path] = {entry.line, entry.value.written};
    if (spec.begin != nullptr)
        spec.begin(validation.reading.scene, entry.line);
    for (auto const& member : entry.value.entries)
        validate_member(validation, {path, spelled, &entry.value}, member);
}

ParameterSpec with_family_names(SceneFamilies const& families, TableSpec const& table, ParameterSpec spec)
{
    if (spec.key == "family")
        for (auto const& family : families.of(table.families))
            spec.words.push_back(family.name);
    return spec;
}

// What must hold between values. The geometry of tooth and neutral curve is checked where it is built.

bool knows(SceneReading const& reading, std::initializer_list<std::string_view> paths)
{
    return std::ranges::all_of(paths, [&](std::string_view path) { return reading.known.contains(path); });
}

void add_at(Faults& faults, std::string path, std::string value, std::string reason, std::string remedy)
{
    faults.push_back({std::move(path), 0, std::move(value), std::move(reason), std::move(remedy)});
}

Faults cross_faults(SceneReading const& reading)
{
    Faults faults;
    add_pair_faults(reading, faults);
    add_cup_faults(reading, faults);
    add_axial_faults(reading, faults);
    add_wanted_faults(reading, faults);
    add_relief_faults(reading, faults);
    if (reading.scene.friction)
        add_running_faults(reading, faults);
    if (reading.scene.wedm)
        add_wedm_faults(reading, faults);
    locate(faults, reading.scene);
    return faults;
}

SceneReading validate_scene(RawValue const& root, SceneFamilies const& families, std::filesystem::path const& folder,
                            NamedTexts files)
{
    Validation validation{families, {}};
    validation.reading.scene.folder = folder;
    validation.reading.scene.files = std::move(files);
    for (auto const& entry : root.entries)
        validate_member(validation, {"", "", &root}, entry);
    validate_missing(validation);
    auto& reading = validation.reading;
    auto crossed = cross_faults(reading);
    reading.geometry_known = geometry_is_known(validation) && std::ranges::none_of(crossed, is_of_tooth_or_curve);
    std::move(crossed.begin(), crossed.end(), std::back_inserter(reading.faults));
    sort_by_place(reading.faults);
    return std::move(reading);
}

void locate(Faults& faults, Scene const& scene)
{
    for (auto& fault : faults) {
        auto const found = scene.given.find(fault.path);
        if (found == scene.given.end())
            continue;
        if (fault.line == 0 && fault.origin.empty()) {
            fault.line = found->second.line;
            fault.origin = found->second.line == 0 ? "--set" : "";
        }
        if (!found->second.written.empty())
            fault.value = found->second.written;
    }
}

Faults value_faults(Scene const& scene)
{
    SceneReading reading{scene, {}, {}};
    reading.scene.given.clear();  // what a file said may have changed since
    for (auto const& table : scene_schema())
        for (auto const& key : table.keys)
            check_value(table, key, reading);
    if (reading.faults.empty())
        reading.faults = cross_faults(reading);
    for (Fault& fault : reading.faults)
        fault.origin.clear();  // where there is no line: not --set, but code
    return std::move(reading.faults);
}

}  // namespace hdconj::scene
