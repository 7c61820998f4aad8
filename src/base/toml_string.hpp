// SPDX-License-Identifier: GPL-3.0-or-later
// Texts as TOML writes them.
#pragma once

#include <string>
#include <string_view>

namespace hdconj {

/// @p text as a string of TOML, in quotes.
[[nodiscard]] std::string toml_string(std::string_view text);

}  // namespace hdconj
