// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// solve() for those who take more from the elastic cup than one outline.
#pragma once

#include <optional>

#include "hdconj/pipeline/solve.hpp"

namespace hdconj::detail {

/// solve(). @param cup_error  width about the middle over which it is asked how well an elastic cup is known, which takes another cup [mm]; 0: in the middle; none: not asked
[[nodiscard]] Solution solve_middle(Scene const& scene, StageObserver const& on_stage, std::optional<double> cup_error);

/// The width over which a drive's slices stand: 0 where it has one plane [mm].
[[nodiscard]] inline double width_of_slices(Scene const& scene)
{
    return scene.slices && scene.slices->count > 1 ? scene.circular_spline.width.value_or(0) : 0;
}

}  // namespace hdconj::detail
