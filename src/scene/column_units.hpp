// SPDX-License-Identifier: GPL-3.0-or-later
// Units of lengths and angles, and in the headings of their columns.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hdconj/scene/number_pairs.hpp"

namespace hdconj::scene {

/// What a number in @p unit is multiplied by to be in mm or degrees; nothing where the unit is not known.
[[nodiscard]] std::optional<double> factor_of_unit(std::string_view unit, ColumnQuantity quantity);

/// @p value times @p factor as it would be typed, without the digits of rounding.
[[nodiscard]] double in_other_unit(double value, double factor);

/// Whether @p text is a unit of lengths or angles.
[[nodiscard]] bool is_unit(std::string_view text);

/// "[mm], [um] ... or [mil]"
[[nodiscard]] char const* known_units(ColumnQuantity quantity);
/// "write a length in [mm], ..."
[[nodiscard]] std::string write_known_unit(ColumnQuantity quantity);

/// @p text without blanks and quotes at its ends.
[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// The unit that stands in brackets; nothing where there are none.
[[nodiscard]] std::optional<std::string_view> unit_in_brackets(std::string_view text);

/// The unit that a heading names, "x [inch]" or "x_mm", whether it is known or not; nothing where it names none.
[[nodiscard]] std::optional<std::string_view> unit_in(std::string_view heading);

}  // namespace hdconj::scene
