// SPDX-License-Identifier: GPL-3.0-or-later
// TOML to raw tables and back to text, and --set, which changes a document before it is validated. What includes this
// knows the TOML library, and nothing else does.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene/raw.hpp"

namespace hdconj::io {

/// Origin of everything that --set put into a document.
inline constexpr std::string_view override_origin = "--set";

/// @p table as raw tables, each with its entries in order of line. @p text is what it was parsed from.
[[nodiscard]] scene::RawValue raw_of(toml::table const& table, std::string_view text);

/// The fault that stopped the parser in @p text, called @p name.
[[nodiscard]] Fault syntax_fault(toml::parse_error const& error, std::string_view text, std::string const& name);

/// Applies @p overrides to @p document in order. "key.path=value" sets a value, creating tables as needed; the value
/// is a TOML value, or a bare word that stands for itself in quotes. "!key.path" removes a key or a table.
/// @return the overrides that could not be applied
[[nodiscard]] Faults apply_overrides(toml::table& document, std::vector<std::string> const& overrides);

/// @p node as TOML. Numbers are as short as they can be and read back exactly; the tables of a document come in their
/// order in the file, what --set added after them. Comments are lost.
[[nodiscard]] std::string toml_text(toml::node const& node);

}  // namespace hdconj::io
