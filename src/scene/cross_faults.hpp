// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What must hold between values of a scene, table by table; private to src/scene. Each adds what it finds to @p
/// faults.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "hdconj/scene/reading.hpp"

namespace hdconj::scene {

/// Teeth, wall, deformation and clearances of the pair in one plane.
void add_pair_faults(SceneReading const& reading, Faults& faults);

/// The cup, its cone and the bearing that pushes it outward.
void add_cup_faults(SceneReading const& reading, Faults& faults);

/// Tilt, slices and contact: what is made of the teeth along the axis.
void add_axial_faults(SceneReading const& reading, Faults& faults);

/// The wire of [wedm].
void add_wedm_faults(SceneReading const& reading, Faults& faults);

/// Whether the values of all @p paths were read and are right by themselves.
[[nodiscard]] bool knows(SceneReading const& reading, std::initializer_list<std::string_view> paths);

/// Adds a fault whose place is found later, by its path.
void add_at(Faults& faults, std::string path, std::string value, std::string reason, std::string remedy);

}  // namespace hdconj::scene
