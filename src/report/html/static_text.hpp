// SPDX-License-Identifier: GPL-3.0-or-later
// What a page says in words where scripts do not run.
#pragma once

#include <string>
#include <vector>

#include "json_group.hpp"

namespace hdconj::report {

/// The figures of a result file, a line each with its error and unit, and a column for each case: the program prints
/// its summaries of what it computes only. Curves and maps are left to the pictures.
/// @param parts  by the word of ReportPart, as the page has them
[[nodiscard]] std::string stored_text(Json const& parts);

/// The judgement and the notes on a drive.
/// @param drive  as the page has it
[[nodiscard]] std::vector<std::string> noted(Json const& drive);

/// The parts that the page of a drive does not hold, each with its cause.
/// @param drive  as the page has it
[[nodiscard]] std::vector<std::string> parts_left_out(Json const& drive);

}  // namespace hdconj::report
