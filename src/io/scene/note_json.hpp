// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on a design as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "hdconj/note.hpp"

namespace hdconj::io {

/// An array with one object a note.
[[nodiscard]] nlohmann::ordered_json json_of(Notes const& notes);

}  // namespace hdconj::io
