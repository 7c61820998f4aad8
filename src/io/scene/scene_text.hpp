// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The bytes of a scene before they are parsed: read with a limit, refused when they are no text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hdconj/error.hpp"

namespace hdconj::io {

/// Whether a bare key of TOML may contain @p c.
[[nodiscard]] constexpr bool is_key_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// The content of @p file.
/// @throws InputError when it cannot be read or is too large
[[nodiscard]] std::string read_scene_text(std::filesystem::path const& file);

/// The fault of a scene above largest_scene.
[[nodiscard]] Fault too_large(std::string const& name);

/// Why @p text, called @p name, must not go to the parser: binary, too large, keys nested without end. Empty when it
/// may.
[[nodiscard]] Faults unparsable(std::string_view text, std::string const& name);

}  // namespace hdconj::io
