// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked for where the wishes cannot be met.
#pragma once

#include <functional>
#include <optional>

#include "wall_search.hpp"

namespace hdconj::design {

/// Searches for wishes that can be met, each of which takes seconds.
struct OtherWishes
{
    std::function<std::optional<double>()> most_torque;   ///< WallSearch::most_torque()
    std::function<std::optional<double>()> least_length;  ///< design::least_length()
};

/// Each wish that stands in the way alone, with the nearest that works; all together where none does.
/// @param failed  the search without a result
[[nodiscard]] Faults nearest_wishes(DesignWishes const& wishes, MeshedSheet const& failed, OtherWishes const& others);

}  // namespace hdconj::design
