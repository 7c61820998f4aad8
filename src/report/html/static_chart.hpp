// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as pictures that need no script.
#pragma once

#include <string>

#include "json_group.hpp"

namespace hdconj::report {

/// The curves that a page shows under torque and while the drive runs, as SVG in figures; empty where there are none.
/// @param results  by the word of ReportPart, as the page has them
[[nodiscard]] std::string static_charts(Json const& results);

}  // namespace hdconj::report
