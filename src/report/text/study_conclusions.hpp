// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Conclusions of single studies whose methods are compared by their cost.
#pragma once

#include "accuracy_conclusions.hpp"

namespace hdconj::report {

using SeriesList = std::vector<ConvergenceSeries>;

/// Times of single runs are compared with no others.
[[nodiscard]] inline bool has_median(ConvergenceLevel const& a, ConvergenceLevel const& b)
{
    return a.runs > 1 && b.runs > 1;
}

void conclude_roots(Page& page, SeriesList const& series_list);
void conclude_type(Page& page, SeriesList const& series_list, Scene const& scene);
void conclude_contact(Page& page, SeriesList const& series_list);
void conclude_load(Page& page, SeriesList const& series_list);
void conclude_threads(Page& page, SeriesList const& series_list);

}  // namespace hdconj::report
