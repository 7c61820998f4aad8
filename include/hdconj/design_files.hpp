// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `design` writes and prints.
#pragma once

#include <string>
#include <vector>

#include "hdconj/design.hpp"
#include "hdconj/file/written_file.hpp"

namespace hdconj {

/// The scene as TOML. Each key has a comment with its rule, range, origin and source. Read back it is Design::scene.
[[nodiscard]] std::string scene_text(Design const& design);

/// The table of dimensions, the radial deformations and walls that were tried, and the differences from type-50.
[[nodiscard]] std::string summary_text(Design const& design);

/// The same as one JSON object, and the remarks; keys in docs/reference/json.md.
[[nodiscard]] std::string summary_json(Design const& design, std::vector<WrittenFile> const& written = {});

}  // namespace hdconj
