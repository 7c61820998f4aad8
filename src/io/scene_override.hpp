// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// --set key.path=value: changes a document before it is judged.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "hdconj/scene/fault.hpp"

namespace hdconj::detail {

/// Applies @p overrides to @p document in order. "key.path=value" sets a value, creating tables as needed; the value
/// is a TOML value, or a bare word that stands for itself in quotes. "!key.path" removes a key or a table.
/// @return the overrides that could not be applied
[[nodiscard]] Faults apply_overrides(toml::table& document, std::vector<std::string> const& overrides);

}  // namespace hdconj::detail
