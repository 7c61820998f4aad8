// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a load study, one row for each surface.
#pragma once

#include "figures/number_text.hpp"
#include "figures/summary_figures.hpp"
#include "hdconj/load.hpp"
#include "summary_page.hpp"

namespace hdconj::report {

void write_load_table(Page& page, LoadStudy const& study);

/// "28 N m"
[[nodiscard]] std::string rated_torque(LoadStudy const& study);

}  // namespace hdconj::report
