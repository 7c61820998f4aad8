// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which key or table a user meant with a name that the schema does not have.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/reading.hpp"

namespace hdconj::scene {

/// The table @p path of the schema; null when there is none.
[[nodiscard]] TableSpec const* find_table(std::string_view path);

/// The last part of a path: "profile" of "flexspline.profile".
[[nodiscard]] std::string_view last_name(std::string_view path);

/// Paths of the tables directly in table @p parent; the top table is "".
[[nodiscard]] std::vector<std::string_view> tables_in(std::string_view parent);

/// Every key that table @p table can have: its own, then those of all its families.
[[nodiscard]] std::vector<ParameterSpec const*> keys_of(TableSpec const& table, SceneFamilies const& families);

/// The path of a key called exactly @p key in a table other than @p except.
[[nodiscard]] std::optional<std::string> key_elsewhere(std::string_view key, std::string_view except,
                                                       SceneFamilies const& families);

/// `parent.name`, or `name` in the top table.
[[nodiscard]] std::string join(std::string_view parent, std::string_view name);

}  // namespace hdconj::scene
