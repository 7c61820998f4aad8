// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the records of a study bear out, in words.
#pragma once

#include <string>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "summary_page.hpp"

namespace hdconj::report {

/// A method's series of the scene's own drive, or of the worst of the sample; null: it was not measured.
[[nodiscard]] ConvergenceSeries const* find(std::vector<ConvergenceSeries> const& series_list, std::string const& study,
                                            std::string const& method, bool sample = false);

/// Writes what follows from the study called @p name: nothing that the numbers do not say, and no ratio of single runs.
void conclude(Page& page, std::string const& name, std::vector<ConvergenceSeries> const& series_list,
              Scene const& scene);

}  // namespace hdconj::report
