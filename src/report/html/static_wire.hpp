// SPDX-License-Identifier: GPL-3.0-or-later
// The path of the wire as a picture that needs no script.
#pragma once

#include <string>

#include "json_group.hpp"

namespace hdconj::report {

/// Contour of the part and the wire of every pass around one tooth space, lower face of the first set-up; empty where
/// nothing is cut.
/// @param wedm  the result of `wedm` as the page has it
[[nodiscard]] std::string static_wire_path(Json const& wedm);

}  // namespace hdconj::report
