// SPDX-License-Identifier: GPL-3.0-or-later
// Maps as rectangles of one colour.
#pragma once

#include <functional>
#include <vector>

#include "colour_bands.hpp"
#include "hdconj/contact.hpp"
#include "io/mesh/gap_on_surface.hpp"

namespace hdconj::report {

/// Borders of cells about @p at: half way between neighbours, @p first and @p last at the ends.
[[nodiscard]] std::vector<double> cell_borders(std::vector<double> const& at, double first, double last);

/// Rows left, right, low, high, colour of the cells between borders; neighbours in x of one colour are one rectangle.
/// @param colour_of  of cell number (i, k)
[[nodiscard]] PlotColumns merged_cells(std::vector<double> const& x, std::vector<double> const& y,
                                       std::function<int(std::size_t, std::size_t)> const& colour_of);

/// Heading, colours, and the flank that is drawn for itself.
[[nodiscard]] PlotData shown_flank_data(ContactStudy const& study, io::FlankOfMap const& flank);

}  // namespace hdconj::report
