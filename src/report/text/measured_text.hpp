// SPDX-License-Identifier: GPL-3.0-or-later
// What a measured curve says.
#pragma once

#include "hdconj/load_files.hpp"
#include "summary_page.hpp"

namespace hdconj::report {

/// @param simulated  beside it; null: none
void write_measured(Page& page, LoadCase const* simulated, Measurement const& measured);

}  // namespace hdconj::report
