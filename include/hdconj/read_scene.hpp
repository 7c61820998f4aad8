// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads a scene from TOML, with or without an exception at its faults, and writes the plan as JSON.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/note.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/scene/reading.hpp"

namespace hdconj {

/// Reads a scene file.
/// @param file       the TOML file
/// @param overrides  "key.path=value" from --set, applied in order before validation
/// @throws InputError with every fault of the file and the overrides
[[nodiscard]] Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides = {});

/// Parses a scene given as text.
/// @param text       the scene in TOML
/// @param name       as messages call the scene
/// @param folder     where relative file names start
/// @param overrides  as of read_scene
/// @param files      what files hold that are not read again, by their names in the scene
/// @throws InputError with every fault of the text and the overrides
[[nodiscard]] Scene parse_scene(std::string_view text, std::string const& name,
                                std::filesystem::path const& folder = {},
                                std::vector<std::string> const& overrides = {}, scene::NamedTexts files = {});

/// The text of the built-in scene: the thesis' type-50 drive (data/scenes/type-50.toml).
[[nodiscard]] std::string_view builtin_scene_text();

/// The built-in scene.
[[nodiscard]] Scene builtin_scene(std::vector<std::string> const& overrides = {});

/// A larger file is no scene; it is refused before it is parsed. [bytes]
inline constexpr std::size_t largest_scene = std::size_t{16} << 20;

/// Reads scene file @p file with the @p overrides of --set ("key.path=value", or "!key.path" to remove).
[[nodiscard]] scene::SceneReading examine_scene_file(std::filesystem::path const& file,
                                                     std::vector<std::string> const& overrides = {});

/// Reads a scene from text.
/// @param text       the scene in TOML
/// @param name       as messages call the scene
/// @param folder     where relative file names start
/// @param overrides  as of examine_scene_file
/// @param files      what files hold that are not read again, by their names in the scene
[[nodiscard]] scene::SceneReading examine_scene(std::string_view text, std::string const& name,
                                                std::filesystem::path const& folder = {},
                                                std::vector<std::string> const& overrides = {},
                                                scene::NamedTexts files = {});

/// Adds the faults that need geometry to be seen (check_scene) when all that it needs is known, in order of place. A
/// key that has a fault already gets no second one.
void examine_geometry(scene::SceneReading& reading);

/// One JSON object: "format", "format_version", "scene", "faults" [{"path", "line", "value", "reason", "remedy",
/// "origin", "set", "kind"}], and, when there is a plan, "stages" [{"stage", "reason"}], "absent" [{"effect",
/// "remedy"}] and "judgement" with @p notes. @p plan may be null.
[[nodiscard]] std::string check_json(std::string const& scene_name, Faults const& faults, Plan const* plan,
                                     Notes const& notes = {});

/// One JSON object for a run that failed: "scene", "error" {"code", "stage", "place", "cause", "remedy",
/// "set"}.
/// @param scene_name  as messages call the scene
/// @param error       a NumericalError with all that it knows; of any other only the cause, with the code "failed"
[[nodiscard]] std::string failure_json(std::string const& scene_name, std::exception const& error);

}  // namespace hdconj
