// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a scene: of one value, of keys, and between values. Three passes share them: the tables that are there
// (validate_scene), names that the schema does not have (validate_unknown), and keys that are missing.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
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

/// Why something is refused, and what to write.
struct Refusal
{
    std::string reason;
    std::string remedy;
};

/// A fault of the value or the name of @p entry, whose key path the message gives as @p path.
[[nodiscard]] Fault fault_at(RawEntry const& entry, std::string path, Refusal refusal,
                             FaultKind kind = FaultKind::value);

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

[[nodiscard]] bool is_length(Quantity quantity);

/// The unit that the meaning of a key names which is neither a length nor an angle; may be empty.
[[nodiscard]] std::string_view unit_of_number(ParameterSpec const& spec);

/// The path of a key called exactly @p key in a table other than @p except.
[[nodiscard]] std::optional<std::string> key_elsewhere(std::string_view key, std::string_view except,
                                                       SceneFamilies const& families);

/// `parent.name`, or `name` in the top table.
[[nodiscard]] std::string join(std::string_view parent, std::string_view name);

/// A value as it would stand in a scene: number, quoted word or list, which is cut short after about one line.
[[nodiscard]] std::string value_text(ParameterValue const& value);

/// What @p spec takes, as a phrase: "a whole number from 1 to 3".
[[nodiscard]] std::string expectation(ParameterSpec const& spec);

/// What one row of a list takes: "[x, y], in mm".
[[nodiscard]] std::string row_form(ParameterSpec const& spec);

/// The forms that a row of a list may have.
[[nodiscard]] std::vector<std::string_view> row_forms(ParameterSpec const& spec);

/// Column names of a form: "[radius, sweep_deg]" -> radius, sweep_deg.
[[nodiscard]] std::vector<std::string_view> columns_of(std::string_view form);

/// Whether a CSV file may stand in place of a list.
[[nodiscard]] bool takes_file(ParameterSpec const& spec);

/// "write " and the expectation, with @p example when there is one.
[[nodiscard]] std::string write_instead(ParameterSpec const& spec, std::string_view example);

/// The value of @p entry when @p spec takes it, else what is wrong with it: one fault, or one for each bad row of a
/// list.
/// @param path     key path for the message
/// @param example  good value for the remedy; may be empty
/// @param scene    whose folder and files a file name stands for
[[nodiscard]] std::variant<Parameter, Faults> validate_value(ParameterSpec const& spec, std::string_view example,
                                                             RawEntry const& entry, std::string const& path,
                                                             Scene& scene);

/// The same for a list of lists of numbers.
[[nodiscard]] std::variant<Parameter, Faults> validate_rows(ParameterSpec const& spec, RawEntry const& entry,
                                                            std::string const& path);

/// The same for a CSV file in place of the list. Its header names the columns of the list with their units, in any
/// order: "tooth,place [um]". Where rows are teeth a column `tooth` may number them from 1 on; then their order does
/// not matter. Other columns are passed over.
[[nodiscard]] std::variant<Parameter, Faults> rows_of_file(ParameterSpec const& spec, RawEntry const& entry,
                                                           std::string const& path, Scene& scene);

/// What the file @p name holds: as @p scene has it, else read and entered there. Null: it cannot be read.
[[nodiscard]] std::shared_ptr<std::string const> content_of(Scene& scene, std::string const& name);

// What must hold between values, table by table. Each adds what it finds to @p faults.

/// Teeth, wall, deformation and clearances of the pair in one plane.
void add_pair_faults(SceneReading const& reading, Faults& faults);

/// The cup, its cone and the bearing that pushes it outward.
void add_cup_faults(SceneReading const& reading, Faults& faults);

/// Tilt, slices and contact: what is made of the teeth along the axis.
void add_axial_faults(SceneReading const& reading, Faults& faults);

/// Of a scene whose neutral curve is wanted.
void add_wanted_faults(SceneReading const& reading, Faults& faults);

/// Reliefs and errors: how far flanks and lands are from their nominal form.
void add_relief_faults(SceneReading const& reading, Faults& faults);

/// Friction of the running drive, and the temperatures of its lubricant.
void add_running_faults(SceneReading const& reading, Faults& faults);

/// The wire of [wedm].
void add_wedm_faults(SceneReading const& reading, Faults& faults);

/// Whether the values of all @p paths were read and are right by themselves.
[[nodiscard]] bool knows(SceneReading const& reading, std::initializer_list<std::string_view> paths);

/// Adds a fault whose place is found later, by its path.
void add_at(Faults& faults, std::string path, std::string value, std::string reason, std::string remedy);

}  // namespace hdconj::scene
