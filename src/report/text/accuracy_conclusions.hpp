// SPDX-License-Identifier: GPL-3.0-or-later
// What the records of a study bear out, in words.
#pragma once

#include <string>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "summary_page.hpp"

namespace hdconj::report {

using SeriesList = std::vector<ConvergenceSeries>;

/// A method's series of the scene's own drive, or of the worst of the sample; null: it was not measured.
[[nodiscard]] ConvergenceSeries const* find(SeriesList const& series_list, std::string const& study,
                                            std::string const& method, bool sample = false);

/// Writes what follows from the study called @p name: nothing that the numbers do not say, and no ratio of single runs.
void conclude(Page& page, std::string const& name, SeriesList const& series_list, Scene const& scene);

/// Times of single runs are compared with no others.
[[nodiscard]] inline bool has_median(ConvergenceLevel const& a, ConvergenceLevel const& b)
{
    return a.runs > 1 && b.runs > 1;
}

// Of single studies whose methods are compared by their cost.
void conclude_roots(Page& page, SeriesList const& series_list);
void conclude_type(Page& page, SeriesList const& series_list, Scene const& scene);
void conclude_contact(Page& page, SeriesList const& series_list);
void conclude_load(Page& page, SeriesList const& series_list);
void conclude_threads(Page& page, SeriesList const& series_list);

}  // namespace hdconj::report
