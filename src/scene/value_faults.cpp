// SPDX-License-Identifier: GPL-3.0-or-later
// A scene made in code, against the schema of scene files.
#include <utility>
#include <variant>

#include "base/text.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

using Kind = RawValue::Kind;

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
