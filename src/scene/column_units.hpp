// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Units that the first line of a file of number pairs names; private to src/scene.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "hdconj/scene/number_pairs.hpp"

namespace hdconj::scene {

/// What a header says of its two columns.
struct ColumnUnits
{
    std::array<double, 2> factor{1, 1};  ///< to mm and degrees
    std::string reason;                  ///< why the header is refused; empty: it is not
    std::string remedy;
};

/// Reads the units of @p header: "x [inch]", "angle (rad)", "x_mm", "angle um", or the unit alone. A column without one
/// is in mm or degrees.
[[nodiscard]] ColumnUnits column_units(std::string_view header, std::array<ColumnQuantity, 2> const& columns);

}  // namespace hdconj::scene
