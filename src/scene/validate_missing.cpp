// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// Whether a key of @p table itself, not of a sub-table, was found outside of it: then the table is not forgotten.
bool has_stray_key(Validation const& validation, TableSpec const& table)
{
    std::string const prefix = std::string(table.path) + ".";
    return std::any_of(validation.attempted.lower_bound(prefix), validation.attempted.end(),
                       [&prefix](std::string const& path) {
                           return path.starts_with(prefix) && path.find('.', prefix.size()) == std::string::npos &&
                                  find_table(path) == nullptr;
                       });
}

std::string with_example(KeySpec const& key)
{
    return std::string(key.spec.key) + " = " + std::string(key.example);
}

/// Whether the scene cannot do without @p table. Where no tooth is given, the flexspline's is the one that is missing.
bool is_wanted(Validation const& validation, TableSpec const& table)
{
    bool const wanted = validation.reading.scene.wants_neutral_curve();
    bool const has_other = !wanted && validation.attempted.contains("circular_spline.profile");
    return table.presence == Presence::required || (table.path == "flexspline.profile" && !has_other) ||
           (table.path == "circular_spline.profile" && wanted);
}

Fault missing_table(TableSpec const& table, bool wanted)
{
    std::string keys;
    for (auto const& key : table.keys)
        if (key.spec.required)
            keys += (keys.empty() ? "" : ", ") + with_example(key);
    std::string const header = "[" + std::string(table.path) + "]";
    bool const outer = wanted && table.path == "circular_spline.profile";
    std::string const meaning = outer ? "the circular spline's tooth: the neutral curve is wanted between both teeth"
                                      : std::string(table.meaning);
    return {std::string(table.path), 0, "", "this table is missing: " + meaning,
            "write the line " + header + " and below it " + keys +
                (table.presence == Presence::alternative && !wanted
                     ? ", or give the circular spline's tooth in [circular_spline.profile]"
                     : "")};
}

/// Exactly one tooth is given, and the other one's height with it.
void report_given_tooth(Validation& validation)
{
    auto& faults = validation.reading.faults;
    auto const& visits = validation.visits;
    auto const inner = visits.find("flexspline.profile");
    auto const outer = visits.find("circular_spline.profile");
    bool const wanted = validation.reading.scene.wants_neutral_curve();
    bool const sized = validation.reading.known.contains("drive.module");
    double const module = sized ? validation.reading.scene.drive.module : 0.25;
    if (inner != visits.end() && outer != visits.end() && !wanted) {
        faults.push_back({"circular_spline.profile", outer->second.line, "",
                          "both teeth are given, and each follows from the other",
                          "remove [flexspline.profile] or [circular_spline.profile], or write "
                          "wave_generator.family = \"wanted\" to look for the neutral curve between both",
                          outer->second.origin});
        return;
    }
    for (std::string const key : {"addendum", "dedendum"}) {
        std::string const path = "flexspline." + key;
        bool const attempted = validation.attempted.contains(path);
        if (outer != visits.end() && !attempted && !wanted) {
            faults.push_back(
                {path, outer->second.line, "",
                 "this key is missing: with [circular_spline.profile] nothing else says how far the flexspline's teeth "
                 "reach",
                 "write " + key + " = " + short_number((key == "addendum" ? 0.9 : 1.212) * module, 3) +
                     ", a length in mm, in [flexspline]",
                 outer->second.origin});
        } else if ((inner != visits.end() || wanted) && attempted) {
            auto const found = validation.reading.scene.given.find(path);
            GivenKey const given = found == validation.reading.scene.given.end() ? GivenKey{} : found->second;
            faults.push_back({path, given.line, given.written,
                              "the height of the flexspline tooth is told in [flexspline.profile]",
                              "write it as flexspline.profile." + key + ", or remove it"});
        }
    }
}

void report_missing(Validation& validation, TableSpec const& table, ParameterSpec const& spec, std::string remedy)
{
    std::string const path = join(table.path, spec.key);
    if (!spec.required || validation.attempted.contains(path))
        return;
    auto const visit = validation.visits.find(table.path);
    bool const is_there = visit != validation.visits.end();
    validation.reading.faults.push_back({path, is_there ? visit->second.line : 0, "",
                                         "this key is missing: " + std::string(spec.meaning), std::move(remedy),
                                         is_there ? visit->second.origin : ""});
}

/// What to write for a missing key; of teeth, what the other ring's number of them asks for.
std::string example_for(Validation const& validation, TableSpec const& table, KeySpec const& key)
{
    std::string const path = join(table.path, key.spec.key);
    Scene const& scene = validation.reading.scene;
    bool const inner = path == "drive.flexspline_teeth", outer = path == "drive.circular_spline_teeth";
    std::string const other = inner ? "drive.circular_spline_teeth" : "drive.flexspline_teeth";
    if (!(inner || outer) || !validation.reading.known.contains(other))
        return with_example(key);
    int const waves = scene.wave_generator.waves;
    int const teeth = inner ? scene.drive.circular_spline_teeth - waves : scene.drive.flexspline_teeth + waves;
    return std::string(key.spec.key) + " = " + std::to_string(teeth);
}

void report_missing_keys(Validation& validation, TableSpec const& table)
{
    for (auto const& key : table.keys)
        report_missing(validation, table, key.spec, "write " + example_for(validation, table, key));
    auto const families = validation.families_of(table.path);
    if (families.size() != 1)
        return;
    for (auto const& spec : families.front()->parameters)
        report_missing(validation, table, spec, "write " + std::string(spec.key) + " = ..., " + expectation(spec));
}

void store_defaults(Validation& validation, TableSpec const& table)
{
    auto& reading = validation.reading;
    for (auto const& key : table.keys) {
        std::string const path = join(table.path, key.spec.key);
        if (key.standard && !validation.attempted.contains(path)) {
            key.member.store(reading.scene, {*key.standard, 0});
            reading.known.insert(path);
        }
    }
}

/// Whether @p path is a key, not a table, that tooth, neutral curve and tip circle depend on.
bool is_geometry_key(std::string_view path)
{
    constexpr std::array<std::string_view, 4> tables{"drive.", "flexspline.", "wave_generator.", "circular_spline."};
    for (std::string_view const other : {"drive.name", "drive.circular_spline_teeth", "wave_generator.waves",
                                         "circular_spline.width", "circular_spline.backlash_offset"})
        if (path == other)
            return false;
    return find_table(path) == nullptr &&
           std::ranges::any_of(tables, [path](std::string_view table) { return path.starts_with(table); });
}

/// Whether every required key of @p table and of its family was given and is right.
bool required_keys_known(Validation const& validation, TableSpec const& table)
{
    auto const is_known = [&](ParameterSpec const& spec) {
        std::string const path = join(table.path, spec.key);
        return !spec.required || !is_geometry_key(path) || validation.reading.known.contains(path);
    };
    bool const own = std::ranges::all_of(table.keys, is_known, &KeySpec::spec);
    if (!own || table.families == FamilyKind::none)
        return own;
    auto const families = validation.families_of(table.path);
    return families.size() == 1 && std::ranges::all_of(families.front()->parameters, is_known);
}

}  // namespace

void validate_missing(Validation& validation)
{
    for (auto const& table : scene_schema()) {
        bool const is_there = validation.visits.contains(table.path);
        bool const has_stray = has_stray_key(validation, table);
        if (is_there || has_stray)
            report_missing_keys(validation, table);
        else if (is_wanted(validation, table) && !validation.attempted.contains(table.path))
            validation.reading.faults.push_back(missing_table(table, validation.reading.scene.wants_neutral_curve()));
        if (is_there || table.presence == Presence::required || table.presence == Presence::optional)
            store_defaults(validation, table);
    }
    report_given_tooth(validation);
    Drive& drive = validation.reading.scene.drive;
    if (!validation.reading.known.contains("drive.circular_spline_teeth"))  // for the checks of what depends on it
        drive.circular_spline_teeth = drive.flexspline_teeth + validation.reading.scene.wave_generator.waves;
}

bool is_of_tooth_or_curve(Fault const& fault)
{
    bool const of_tip_circle =
        fault.path.starts_with("circular_spline.") && !fault.path.starts_with("circular_spline.profile.");
    return is_geometry_key(fault.path) && !of_tip_circle;
}

bool geometry_is_known(Validation const& validation)
{
    auto const& known = validation.reading.known;
    bool const given_is_right = std::ranges::all_of(
        validation.attempted, [&](std::string const& path) { return !is_geometry_key(path) || known.contains(path); });
    bool const inner = validation.visits.contains("flexspline.profile");
    bool const outer = validation.visits.contains("circular_spline.profile");
    bool const heights = known.contains("flexspline.addendum") && known.contains("flexspline.dedendum");
    bool const wanted = validation.reading.scene.wants_neutral_curve();
    bool const given = wanted ? inner && outer && known.contains("circular_spline.inner_radius") && !heights
                              : inner != outer && outer == heights;
    return given_is_right && given && std::ranges::all_of(scene_schema(), [&](TableSpec const& table) {
               bool const needed = table.presence == Presence::required ||
                                   (table.presence == Presence::alternative && validation.visits.contains(table.path));
               return !needed || required_keys_known(validation, table);
           });
}

}  // namespace hdconj::scene
