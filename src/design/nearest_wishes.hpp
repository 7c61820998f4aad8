// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked for where the wishes cannot be met.
#pragma once

#include "wall_search.hpp"

namespace hdconj::design {

/// Each wish that stands in the way alone, with the nearest that works; all together where none does.
/// @param failed  the search without a result
/// @param search  that found none; tries other torques
[[nodiscard]] Faults nearest_wishes(DesignWishes const& wishes, MeshedSheet const& failed, WallSearch& search);

}  // namespace hdconj::design
