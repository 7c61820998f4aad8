// SPDX-License-Identifier: GPL-3.0-or-later
// What a page says in words where scripts do not run.
#pragma once

#include <string>

#include "json_group.hpp"

namespace hdconj::report {

/// The figures of a result file, a line each with its error and unit, and a column for each case: the program prints
/// its summaries of what it computes only. Curves and maps are left to the pictures.
/// @param parts  by the word of ReportPart, as the page has them
[[nodiscard]] std::string stored_text(Json const& parts);

/// The judgement and the notes on a drive, a line each.
/// @param drive  as the page has it
[[nodiscard]] std::string noted_text(Json const& drive);

/// What the page of a drive does not hold, a line for each part with its cause; empty where it holds all.
/// @param drive  as the page has it
[[nodiscard]] std::string left_out_text(Json const& drive);

}  // namespace hdconj::report
