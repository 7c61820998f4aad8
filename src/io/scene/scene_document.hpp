// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// TOML to raw tables. The one place that knows the TOML library, together with scene_override.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

#include "hdconj/error.hpp"
#include "hdconj/scene/raw.hpp"

namespace hdconj::io {

/// Origin of everything that --set put into a document.
inline constexpr std::string_view override_origin = "--set";

/// @p table as raw tables, each with its entries in order of line. @p text is what it was parsed from.
[[nodiscard]] scene::RawValue raw_of(toml::table const& table, std::string_view text);

/// The fault that stopped the parser in @p text, called @p name.
[[nodiscard]] Fault syntax_fault(toml::parse_error const& error, std::string_view text, std::string const& name);

}  // namespace hdconj::io
