// SPDX-License-Identifier: GPL-3.0-or-later
// Every table and key of a scene: one row per key, from which type check, range, default, "did you mean", the
// template of messages and docs/reference/scene.md follow. Keys of the families are not here: families declare their
// own.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "hdconj/scene.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::scene {

/// Where the value of a key stands in a Scene.
struct SceneMember
{
    void (*store)(Scene&, Parameter const&);  ///< puts a valid value there
    /// The value there as a scene file would say it; nothing: absent. Null: a family's name, or one of two words.
    std::optional<ParameterValue> (*read)(Scene const&) = nullptr;
};

/// One key of a table.
struct KeySpec
{
    ParameterSpec spec;
    std::string_view example;                  ///< a good value as it stands in a scene
    SceneMember member;                        ///< that holds the value
    std::optional<ParameterValue> standard{};  ///< value when absent; nothing: required, or absence has a meaning
};

/// Which list of families extends a table.
enum class FamilyKind
{
    none,
    profile,
    wave_generator
};

/// Whether a table must be there.
enum class Presence
{
    required,
    optional,
    alternative,  ///< one of several, of which exactly one must be there
    effect        ///< there: the effect is computed; absent: it has no object
};

/// One table.
struct TableSpec
{
    std::string_view path;  ///< "flexspline.profile"
    std::string_view meaning;
    Presence presence;
    FamilyKind families;
    void (*begin)(Scene&, int line);  ///< makes the effect's object; may be null
    std::vector<KeySpec> keys;
};

/// All tables, a table before its sub-tables, in the order of docs/reference/scene.md.
[[nodiscard]] std::vector<TableSpec> const& scene_schema();

/// Among the forms of a list's rows: a CSV file may stand in place of the list.
inline constexpr std::string_view row_file = "\"NAME.csv\"";

/// Bounds that keep typing errors out; nothing in the mathematics needs them.
namespace bounds {
inline constexpr double least_module = 1e-4;   ///< [mm]
inline constexpr double largest_module = 1e4;  ///< [mm]
inline constexpr double least_length = 1e-9;   ///< [mm], of lengths that must be positive
inline constexpr double largest_length = 1e6;  ///< [mm]
inline constexpr int fewest_teeth = 6;
inline constexpr int most_teeth = 100000;
inline constexpr int most_waves = 3;
inline constexpr int most_pitches_per_lobe = 100;  ///< (z_c - z_f)/n; the work grows with it, drives have 1 or 2
inline constexpr int most_threads = 1024;
inline constexpr int most_slices = 1000;
inline constexpr int fewest_flank_points = 5;
inline constexpr int most_flank_points = 10000;
inline constexpr int most_rows = 20000;           ///< of a list; longer ones belong into a file
inline constexpr double least_tolerance = 1e-12;  ///< [mm]
inline constexpr double largest_tilt_deg = 45;    ///< excluded
inline constexpr double largest_wobble_deg = 1;   ///< of a ring of teeth: beyond, its planes are no slices of the drive
inline constexpr double least_modulus = 1;        ///< of elasticity [MPa]
inline constexpr double largest_modulus = 1e7;    ///< [MPa]
inline constexpr double largest_poissons_ratio = 0.499;
inline constexpr double least_strength = 1;           ///< of steel against fatigue [MPa]
inline constexpr double largest_strength = 1e5;       ///< [MPa]
inline constexpr double least_flow_pressure = 10;     ///< of flanks [MPa]
inline constexpr double largest_flow_pressure = 1e5;  ///< [MPa]
inline constexpr double least_tooth_share = 1e-6;     ///< of steel in the layer of teeth
inline constexpr double least_stiffness = 1;          ///< of the line of balls [N/mm^2]
inline constexpr double largest_stiffness = 1e9;      ///< [N/mm^2]
inline constexpr double least_conformity = 0.501;     ///< of a groove: at 0.5 it fits the ball all over
inline constexpr double largest_conformity = 1;
inline constexpr double least_torsional_stiffness = 1e-6;    ///< [N m/rad]
inline constexpr double largest_torsional_stiffness = 1e12;  ///< [N m/rad]
inline constexpr int most_balls = 400;                       ///< of the wave generator's bearing
inline constexpr int fewest_angles = 8;                      ///< where bearing and cup may touch, in a lobe
inline constexpr int most_angles = 512;
inline constexpr int fewest_circles = 2;
inline constexpr int most_circles = 101;
inline constexpr double least_torque = 1e-9;   ///< [N m]
inline constexpr double largest_torque = 1e9;  ///< [N m]
inline constexpr int fewest_form_rows = 4;     ///< of a profile: a cubic goes through that many
inline constexpr int most_torques = 1000;
inline constexpr int largest_seed = 1000000;  ///< of random numbers
inline constexpr int fewest_harmonics = 8;
inline constexpr int most_harmonics = 400;
inline constexpr int fewest_positions = 4;  ///< of the wave generator over a tooth pitch
inline constexpr int most_positions = 1000;
inline constexpr int most_running_values = 50;         ///< torques, speeds or temperatures of a running drive
inline constexpr double largest_friction = 1;          ///< coefficient
inline constexpr double largest_speed = 1e6;           ///< [rpm], of sliding [mm/s]
inline constexpr double largest_bearing_factor = 100;  ///< Palmgren's f0
inline constexpr double least_viscosity = 1;           ///< [mm^2/s]
inline constexpr double largest_viscosity = 1e5;       ///< [mm^2/s]
inline constexpr int most_passes = 20;                 ///< of the wire
inline constexpr double largest_workpiece = 1000;      ///< [mm], thickness that a wire machine holds
inline constexpr int fewest_decimals = 2;              ///< of rounded wire coordinates in mm
inline constexpr int most_decimals = 9;
inline constexpr int most_revolution_angles = 10000;  ///< angles of the wave generator over a revolution
inline constexpr int most_designs = 1000;             ///< of the sample of an accuracy study
inline constexpr int most_repeats = 1000;             ///< of a setting of an accuracy study
}  // namespace bounds

}  // namespace hdconj::scene
