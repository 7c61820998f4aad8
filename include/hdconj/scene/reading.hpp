// SPDX-License-Identifier: GPL-3.0-or-later
// From raw tables to a scene: every key and value is validated against the schema and the families, then against each
// other.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/scene/raw.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::scene {

/// The families that a scene may name.
struct SceneFamilies
{
    std::vector<FamilyDescription> const& profiles;
    std::vector<FamilyDescription> const& wave_generators;

    /// The list behind @p kind; empty for none.
    [[nodiscard]] std::vector<FamilyDescription> const& of(FamilyKind kind) const;
};

/// A scene as far as it could be read, and every fault found.
struct SceneReading
{
    Scene scene;
    Faults faults;                             ///< in order of place
    std::set<std::string, std::less<>> known;  ///< paths whose value is in the scene: given and right, or the default
    bool geometry_known = false;               ///< all that check_scene needs is there: its faults can be found too
    std::map<std::string, std::string, std::less<>> file_names{};  ///< of CSV files, by the paths of the keys
};

/// What a key takes.
struct KeyDescription
{
    Quantity quantity;
    std::string_view unit;    ///< of numbers, as scenes are written: "mm", "deg" or another such as "N m"; empty: none
    std::string expectation;  ///< what may be written, such as "a length in mm above 0"
};

/// @param path      of the key, such as "circular_spline.backlash_offset"
/// @param families  whose keys count too, whichever the scene names
/// @returns nothing where no table has such a key
[[nodiscard]] std::optional<KeyDescription> describe_key(std::string_view path, SceneFamilies const& families);

/// Validates @p root, the top table of a scene.
/// @param folder  where relative file names start
/// @param files   what files hold that are not read again
[[nodiscard]] SceneReading validate_scene(RawValue const& root, SceneFamilies const& families,
                                          std::filesystem::path const& folder = {}, NamedTexts files = {});

/// Faults between values that are each right: tooth difference and waves, tolerance and module, effects that
/// exclude each other. Only values in @p reading.known are checked.
[[nodiscard]] Faults cross_faults(SceneReading const& reading);

/// What is wrong with the values of a scene that was made or changed in code: each against the schema of scene files,
/// as though it stood in one, then against each other. solve() and the other studies throw an InputError of it. That a
/// key is missing, and the parameters of families, are checked where they are used.
[[nodiscard]] Faults value_faults(Scene const& scene);

/// Fills in line and origin of faults that name a key of @p scene but no line, and the value as it was written.
void locate(Faults& faults, Scene const& scene);

/// What is wrong with @p decimals of a coordinate in mm where a wire is to keep @p tolerance [mm]: rounding moves a
/// point by up to 10^-decimals/sqrt 2, which must be no more. Empty: nothing.
[[nodiscard]] std::string rounding_fault(int decimals, double tolerance);

}  // namespace hdconj::scene
