// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The main job: from a scene to the conjugate circular spline.
#pragma once

#include "hdconj/pipeline/solution.hpp"
#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// Faults of a scene that need geometry to be seen: arcs that do not meet, a tooth wider than its
/// pitch, a tip circle outside the tooth space. Builds the profile and the neutral curve, solves nothing.
[[nodiscard]] Faults check_scene(Scene const& scene);

/// Runs the plan of @p scene.
/// @throws InputError     the scene cannot describe a drive (exit status 2)
/// @throws NumericalError a stage failed; says which, where and why (exit status 1)
[[nodiscard]] Solution solve(Scene const& scene);

}  // namespace hdconj
