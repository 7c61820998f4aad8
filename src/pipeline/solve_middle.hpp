// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// solve() for those who take more from the elastic cup than one outline.
#pragma once

#include "hdconj/pipeline/solve.hpp"

namespace hdconj::detail {

/// solve(). @param cup_error  whether it is asked how well an elastic cup is known, which takes another one
[[nodiscard]] Solution solve_middle(Scene const& scene, StageObserver const& on_stage, bool cup_error);

}  // namespace hdconj::detail
