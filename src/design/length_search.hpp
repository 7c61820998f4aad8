// SPDX-License-Identifier: GPL-3.0-or-later
// The cup that is long enough.
#pragma once

#include <optional>

#include "wall_search.hpp"

namespace hdconj::design {

/// The least length of the cup over the pitch diameter, in twentieths and above the one asked for, with which a wall
/// meets the wishes, without errors; nothing where the longest has none. It is found by halving: a longer cup is bent
/// less and cones less.
[[nodiscard]] std::optional<double> least_length(DesignWishes const& wishes, Talk const& talk);

}  // namespace hdconj::design
