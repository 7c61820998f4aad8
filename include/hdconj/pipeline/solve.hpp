// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The main job: from a scene to the conjugate circular spline.
#pragma once

#include <functional>

#include "hdconj/pipeline/solution.hpp"
#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/plan.hpp"
#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// Faults of a scene that need geometry to be seen: arcs that do not meet, a tooth wider than its
/// pitch, a tip circle outside the tooth space. Builds the profile and the wave shape, solves nothing.
[[nodiscard]] Faults check_scene(Scene const& scene);

/// Called at the start of each stage that runs, by any of the threads but never by two at once; for progress and for tests that count stages.
using StageObserver = std::function<void(Stage)>;

/// Runs the plan of @p scene, stage by stage; a stage that is not in the plan is never entered.
///
/// The result does not depend on the number of threads, to the last bit.
/// @throws InputError     the scene cannot describe a drive (exit status 2)
/// @throws NumericalError a stage failed; says which, where and why (exit status 1)
[[nodiscard]] Solution solve(Scene const& scene, StageObserver const& on_stage = {});

}  // namespace hdconj
