// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults of a drive that are found before anything is solved.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"

namespace hdconj {

/// Finds the faults of a scene that need geometry to be seen: arcs that do not meet, a tooth wider than its pitch, a
/// tip circle outside the tooth space. Builds the profile and the wave shape and solves nothing.
/// @param scene  as read_scene() returns it, or made in code without scene::value_faults(): each key is right by itself
/// @returns all faults, in the order of their place; empty: solve() accepts the scene
[[nodiscard]] Faults check_scene(Scene const& scene);

/// The same for a scene whose neutral curve is wanted: both teeth against their pitches, the circular spline's tips and
/// spaces against the flexspline at its given displacement, symmetry of both teeth about their middle lines.
/// @param scene  the same, with Scene::wants_neutral_curve()
/// @returns all faults; empty: find_neutral_curve() accepts the scene
[[nodiscard]] Faults check_wanted_scene(Scene const& scene);

}  // namespace hdconj
