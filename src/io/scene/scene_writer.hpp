// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// TOML back to text: for the scene as it is after --set, and for values in messages.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace hdconj::io {

/// @p node as TOML. Numbers are as short as they can be and read back exactly; the tables of a document come in their
/// order in the file, what --set added after them. Comments are lost.
[[nodiscard]] std::string toml_text(toml::node const& node);

}  // namespace hdconj::io
