// SPDX-License-Identifier: GPL-3.0-or-later
// What may make flanks touch longer.
#pragma once

#include <string>
#include <vector>

#include "hdconj/solution.hpp"

namespace hdconj::judgement {

/// Settings of the scene of @p solution that may mend its note of @p code, flank-contact or undercut, as arguments of
/// --set: none, the usual pair, and other pressure angles, addenda and radial deformations, the nearest first.
[[nodiscard]] std::vector<std::vector<std::string>> flank_ways(NoteCode code, Solution const& solution);

}  // namespace hdconj::judgement
