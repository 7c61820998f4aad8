// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults of a drive that are found before anything is solved.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"

namespace hdconj {

/// Finds the faults of a scene that need geometry to be seen: arcs that do not meet, a tooth wider than its pitch, a
/// tip circle outside the tooth space. Builds the profile and the wave shape and solves nothing.
/// @param scene  as read_scene() returns it: each key is right by itself
/// @returns all faults, in the order of their place; empty: solve() accepts the scene
[[nodiscard]] Faults check_scene(Scene const& scene);

}  // namespace hdconj
