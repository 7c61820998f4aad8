// SPDX-License-Identifier: GPL-3.0-or-later
// The wire that a design is judged for.
#pragma once

#include <string>

#include "hdconj/scene.hpp"

namespace hdconj::judgement {

/// Table [wedm] of @p scene; without one the usual wire.
[[nodiscard]] WireRequest wire_of(Scene const& scene);

/// "the wire of [wedm]"
[[nodiscard]] std::string wire_name(Scene const& scene);

}  // namespace hdconj::judgement
