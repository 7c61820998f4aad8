// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// --set key.path=value: changes a document before it is validated.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "hdconj/error.hpp"

namespace hdconj::io {

/// Applies @p overrides to @p document in order. "key.path=value" sets a value, creating tables as needed; the value
/// is a TOML value, or a bare word that stands for itself in quotes. "!key.path" removes a key or a table.
/// @return the overrides that could not be applied
[[nodiscard]] Faults apply_overrides(toml::table& document, std::vector<std::string> const& overrides);

}  // namespace hdconj::io
