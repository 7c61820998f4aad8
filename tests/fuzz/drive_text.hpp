// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A drive as the target `solve` reads it: lines
///
///     scene liu-2025                    a file of data/scenes; without this line the built-in scene
///     points flank.csv 0.1,0.2 0.3,0.4  a file that the scene may name, one line per pair
///     drive.module=0.3                  any other line: an override, as for --set
///
/// Text, so that a find can be read, changed and given to the program as it is.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene.hpp"

namespace hdconj::fuzz {

struct DriveText
{
    std::string scene;                         ///< empty: built in
    std::map<std::string, std::string> files;  ///< name -> pairs separated by blanks
    std::vector<std::string> overrides;
};

[[nodiscard]] DriveText parse_drive(std::string_view text);
[[nodiscard]] std::string to_text(DriveText const& drive);

/// Names of the scenes in data/scenes, sorted.
[[nodiscard]] std::vector<std::string> const& scene_names();

/// The scene's own TOML.
[[nodiscard]] std::string const& base_text(DriveText const& drive);

/// Writes the drive's files and reads its scene.
/// @throws InputError
[[nodiscard]] Scene scene_of(DriveText const& drive);

/// The drive @p text changed in one to four places: values, keys, families, counts, all lengths, points.
[[nodiscard]] std::string mutated_drive(std::string_view text, std::uint32_t seed);

/// A drive that has some overrides of each.
[[nodiscard]] std::string crossed_drives(std::string_view one, std::string_view other, std::uint32_t seed);

}  // namespace hdconj::fuzz
