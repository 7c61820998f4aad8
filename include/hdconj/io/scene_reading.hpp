// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads a scene without throwing at its faults, for a caller that adds faults of its own (check_scene).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/reading.hpp"

namespace hdconj {

/// A larger file is no scene; it is refused before it is parsed. [bytes]
inline constexpr std::size_t largest_scene = std::size_t{16} << 20;

/// Reads scene file @p file with the @p overrides of --set ("key.path=value", or "!key.path" to remove).
[[nodiscard]] SceneReading examine_scene_file(std::filesystem::path const& file,
                                              std::vector<std::string> const& overrides = {});

/// Reads a scene from text; relative file names start at @p folder.
[[nodiscard]] SceneReading examine_scene(std::string_view text, std::string const& name,
                                         std::filesystem::path const& folder = {},
                                         std::vector<std::string> const& overrides = {});

/// Adds the faults that need geometry to be seen (check_scene) when all that it needs is known, in order of place. A
/// key that has a fault already gets no second one.
void examine_geometry(SceneReading& reading);

}  // namespace hdconj
