// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is known while a scene is validated. Three passes share it: the tables that are there (validate_scene),
/// names that the schema does not have (validate_unknown), and keys that are not there (validate_missing).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/reading.hpp"

namespace hdconj::scene {

/// A table that the scene has.
struct Visit
{
    int line = 0;
    std::string origin;
    /// Families whose keys the table may have: one when `family` is right or nearly so, else all.
    std::vector<FamilyDescription const*> families;
};

struct Validation
{
    SceneFamilies const& families;
    SceneReading reading;
    std::set<std::string, std::less<>> attempted{};  ///< paths given or meant, right or wrong
    std::map<std::string, Visit, std::less<>> visits{};

    /// Families of table @p path; none when it is not there.
    [[nodiscard]] std::vector<FamilyDescription const*> families_of(std::string_view path) const
    {
        auto const visit = visits.find(path);
        return visit == visits.end() ? std::vector<FamilyDescription const*>{} : visit->second.families;
    }
};

/// Where an entry stands: the table's path, and the same as the user spelled it.
struct Place
{
    std::string path;
    std::string spelled;
    RawValue const* table;  ///< the table itself
};

/// An entry of the table at @p place: sub-table, key, or neither.
void validate_member(Validation& validation, Place const& place, RawEntry const& entry);

/// The table @p spec, found at @p entry under the name @p spelled.
void validate_table(Validation& validation, TableSpec const& spec, std::string const& spelled, RawEntry const& entry);

/// An entry whose name the table does not have.
void validate_unknown(Validation& validation, Place const& place, RawEntry const& entry);

/// Missing tables and keys; defaults of those that may be missing.
void validate_missing(Validation& validation);

/// The key `family` with the names of the registered families as its words; other keys as they are.
[[nodiscard]] ParameterSpec with_family_names(SceneFamilies const& families, TableSpec const& table,
                                              ParameterSpec spec);

/// Whether @p fault is about what tooth and neutral curve are built from.
[[nodiscard]] bool is_of_tooth_or_curve(Fault const& fault);

/// Whether all that builds tooth and neutral curve was given and is right.
[[nodiscard]] bool geometry_is_known(Validation const& validation);

/// The table @p path of the schema; null when there is none.
[[nodiscard]] TableSpec const* find_table(std::string_view path);

/// The last part of a path: "profile" of "flexspline.profile".
[[nodiscard]] std::string_view last_name(std::string_view path);

/// Names of the tables directly in table @p parent; the top table is "".
[[nodiscard]] std::vector<std::string_view> tables_in(std::string_view parent);

/// Every key that table @p table can have: its own, then those of all its families.
[[nodiscard]] std::vector<ParameterSpec const*> keys_of(TableSpec const& table, SceneFamilies const& families);

/// The path of a key called exactly @p key in a table other than @p except.
[[nodiscard]] std::optional<std::string> key_elsewhere(std::string_view key, std::string_view except,
                                                       SceneFamilies const& families);

/// `parent.name`, or `name` in the top table.
[[nodiscard]] std::string join(std::string_view parent, std::string_view name);

}  // namespace hdconj::scene
