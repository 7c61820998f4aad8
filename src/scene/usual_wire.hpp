// SPDX-License-Identifier: GPL-3.0-or-later
// The wire that advice names and that a drive without a table [wedm] is judged for.
#pragma once

#include <string_view>

namespace hdconj::scene {

/// Diameter of the wire and its spark gap, as a scene writes them [mm]. Such a wire follows the roots of usual drives.
inline constexpr std::string_view usual_wire = "0.08", usual_spark_gap = "0.006";

}  // namespace hdconj::scene
