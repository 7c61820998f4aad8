// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a design and of a scene beside each other.
#pragma once

#include <optional>
#include <string>

namespace hdconj::design {

/// Whether two values of a scene mean the same: 7 and 7.0 do. Long lists are compared as far as messages hold them.
[[nodiscard]] bool same_value(std::string const& a, std::string const& b);

/// What the scene's schema takes where the key @p path is absent, as a scene writes it; none: absence has a meaning.
[[nodiscard]] std::optional<std::string> standard_value(std::string const& path);

/// Rows that no key holds, by their names.
inline constexpr char const* length_ratio_row = "length ratio";
inline constexpr char const* spline_land_row = "tip land of the circular spline";
inline constexpr char const* flank_contact_row = "teeth of a lobe in flank contact";
inline constexpr char const* lost_row = "angle lost by undercut over angle used";

}  // namespace hdconj::design
