// SPDX-License-Identifier: GPL-3.0-or-later
// What a load study prints of its surfaces.
#pragma once

#include <cmath>

#include "figures/number_text.hpp"
#include "figures/summary_figures.hpp"
#include "hdconj/load.hpp"
#include "summary_page.hpp"

namespace hdconj::report {

/// The table, one row for each surface.
void write_load_table(Page& page, LoadStudy const& study);

/// What K1, K2 and K3 of the table are, and the lost motion.
void write_catalogue(Page& page, LoadStudy const& study);

/// The slope along each curve, and the two lines of the thesis for comparison.
void write_stiffness(Page& page, LoadStudy const& study);

/// What the twist at the largest torque consists of.
void write_members(Page& page, LoadStudy const& study);

/// "0.92?": an error, marked where its figure has not converged.
template <class Record>
[[nodiscard]] std::string marked_error(figures::FigureOf<Record> const& row, Record const& record, Record const& errors)
{
    return row.error_text(errors) + (figures::is_unconverged(row, record, errors) ? "?" : "");
}

/// "2.03 +- 0.92?": a figure and, where there are estimates, its error; "-" where it is not determined.
/// @param errors  record that holds it: @p record itself, or that of figures whose errors stand apart; null: none
template <class Record>
[[nodiscard]] std::string with_marked_error(figures::FigureOf<Record> const& row, Record const& record,
                                            Record const* errors)
{
    bool const has_error = errors != nullptr && !std::isnan(row.value(record));
    return row.value_text(record) + (has_error ? " +- " + marked_error(row, record, *errors) : "");
}

/// "28 N m"
[[nodiscard]] std::string rated_torque(LoadStudy const& study);

/// Whether the figures of @p each are those of the rated torque. They are those of the largest one with a balance.
[[nodiscard]] bool is_rated(LoadStudy const& study, LoadCase const& each);

/// The torque whose figures @p each has.
[[nodiscard]] std::string torque_of(LoadCase const& each);

/// The torque whose figures are told: the rated one, or in words where a case has none at it.
[[nodiscard]] std::string largest_torque(LoadStudy const& study);

}  // namespace hdconj::report
