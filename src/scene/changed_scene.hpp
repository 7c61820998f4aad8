// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as advice would have it.
#pragma once

#include <string>
#include <vector>

#include "hdconj/scene.hpp"

namespace hdconj::scene {

/// @p scene with what advice writes: numbers, "table.key=value", in order; "!circular_spline.inner_radius" leaves the
/// tip circle out. A key that no table has is a parameter of the table's family. Scene::text and Scene::given stay.
/// Domain: the settings of advice; a number stands behind each '='.
[[nodiscard]] Scene changed_scene(Scene scene, std::vector<std::string> const& settings);

/// The key that @p setting, "table.key=value" or "!table.key", writes or leaves out.
[[nodiscard]] std::string key_of(std::string const& setting);

/// "write a = 1, b = 2 and leave c out"
[[nodiscard]] std::string in_words(std::vector<std::string> const& settings);

}  // namespace hdconj::scene
