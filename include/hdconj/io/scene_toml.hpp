// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads a scene from TOML. Every fault of the file is found in one go.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// Reads a scene file.
/// @param file       the TOML file
/// @param overrides  "key.path=value" from --set, applied in order before validation
/// @throws InputError with every fault of the file and the overrides
[[nodiscard]] Scene read_scene(std::filesystem::path const& file,
                               std::vector<std::string> const& overrides = {});

/// Parses a scene given as text; relative file names start at @p folder.
[[nodiscard]] Scene parse_scene(std::string_view text,
                                std::string const& name,
                                std::filesystem::path const& folder = {},
                                std::vector<std::string> const& overrides = {});

/// The text of the built-in scene: the thesis' type-50 drive (data/scenes/type-50.toml).
[[nodiscard]] std::string_view builtin_scene_text();

/// The built-in scene.
[[nodiscard]] Scene builtin_scene(std::vector<std::string> const& overrides = {});

}  // namespace hdconj
