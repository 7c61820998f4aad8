// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "judge_value.hpp"
#include "judgement.hpp"
#include "key_finder.hpp"

namespace hdconj::detail {
namespace {

/// Whether a key of @p table itself, not of a sub-table, was found outside of it: then the table is not forgotten.
bool has_stray_key(Judgement const& judgement, TableSpec const& table)
{
    std::string const prefix = std::string(table.path) + ".";
    return std::any_of(judgement.attempted.lower_bound(prefix), judgement.attempted.end(),
                       [&prefix](std::string const& path) {
                           return path.starts_with(prefix) && path.find('.', prefix.size()) == std::string::npos &&
                                  find_table(path) == nullptr;
                       });
}

std::string with_example(KeySpec const& key)
{
    return std::string(key.spec.key) + " = " + std::string(key.example);
}

Fault missing_table(TableSpec const& table)
{
    std::string keys;
    for (auto const& key : table.keys) {
        if (key.spec.required) {
            keys += (keys.empty() ? "" : ", ") + with_example(key);
        }
    }
    std::string const header = "[" + std::string(table.path) + "]";
    return {std::string(table.path), 0, "", "this table is missing: " + std::string(table.meaning),
            "write the line " + header + " and below it " + keys};
}

void report_missing(Judgement& judgement, TableSpec const& table, ParameterSpec const& spec, std::string remedy)
{
    std::string const path = join(table.path, spec.key);
    if (!spec.required || judgement.attempted.contains(path)) {
        return;
    }
    auto const visit = judgement.visits.find(table.path);
    bool const is_there = visit != judgement.visits.end();
    judgement.reading.faults.push_back({path, is_there ? visit->second.line : 0, "",
                                        "this key is missing: " + std::string(spec.meaning), std::move(remedy),
                                        is_there ? visit->second.origin : ""});
}

void report_missing_keys(Judgement& judgement, TableSpec const& table)
{
    for (auto const& key : table.keys) {
        report_missing(judgement, table, key.spec, "write " + with_example(key));
    }
    auto const families = judgement.families_of(table.path);
    if (families.size() != 1) {
        return;
    }
    for (auto const& spec : families.front()->parameters) {
        report_missing(judgement, table, spec, "write " + std::string(spec.key) + " = ..., " + expectation(spec));
    }
}

void store_defaults(Judgement& judgement, TableSpec const& table)
{
    auto& reading = judgement.reading;
    for (auto const& key : table.keys) {
        std::string const path = join(table.path, key.spec.key);
        if (key.standard && !judgement.attempted.contains(path)) {
            key.store(reading.scene, {*key.standard, 0});
            reading.known.insert(path);
        }
    }
}

/// Whether @p path is a key, not a table, that tooth, neutral curve and tip circle depend on.
bool is_geometry_key(std::string_view path)
{
    constexpr std::array<std::string_view, 4> tables{"drive.", "flexspline.", "wave_generator.", "circular_spline."};
    constexpr std::array<std::string_view, 5> others{"drive.name", "drive.circular_spline_teeth", "wave_generator.waves",
                                                     "circular_spline.width", "circular_spline.backlash_offset"};
    if (std::find(others.begin(), others.end(), path) != others.end())
        return false;
    return find_table(path) == nullptr && std::any_of(tables.begin(), tables.end(), [path](std::string_view table) {
               return path.starts_with(table);
           });
}

/// Whether every required key of @p table and of its family was given and is right.
bool required_keys_known(Judgement const& judgement, TableSpec const& table)
{
    auto const is_known = [&](ParameterSpec const& spec) {
        std::string const path = join(table.path, spec.key);
        return !spec.required || !is_geometry_key(path) || judgement.reading.known.contains(path);
    };
    bool const own = std::all_of(table.keys.begin(), table.keys.end(),
                                 [&is_known](KeySpec const& key) { return is_known(key.spec); });
    if (!own || table.families == FamilyKind::none) {
        return own;
    }
    auto const families = judgement.families_of(table.path);
    return families.size() == 1 &&
           std::all_of(families.front()->parameters.begin(), families.front()->parameters.end(), is_known);
}

}  // namespace

void judge_missing(Judgement& judgement)
{
    for (auto const& table : scene_schema()) {
        bool const is_there = judgement.visits.contains(table.path);
        bool const has_stray = has_stray_key(judgement, table);
        if (is_there || has_stray) {
            report_missing_keys(judgement, table);
        } else if (table.presence == Presence::required && !judgement.attempted.contains(table.path)) {
            judgement.reading.faults.push_back(missing_table(table));
        }
        if (is_there || table.presence != Presence::effect) {
            store_defaults(judgement, table);
        }
    }
}

bool is_of_tooth_or_curve(Fault const& fault)
{
    return is_geometry_key(fault.path) && !fault.path.starts_with("circular_spline.");
}

bool geometry_is_known(Judgement const& judgement)
{
    auto const& known = judgement.reading.known;
    bool const given_is_right =
        std::all_of(judgement.attempted.begin(), judgement.attempted.end(),
                    [&known](std::string const& path) { return !is_geometry_key(path) || known.contains(path); });
    auto const& schema = scene_schema();
    return given_is_right && std::all_of(schema.begin(), schema.end(), [&judgement](TableSpec const& table) {
               return table.presence != Presence::required || required_keys_known(judgement, table);
           });
}

}  // namespace hdconj::detail
