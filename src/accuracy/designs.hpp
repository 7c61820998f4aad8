// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Designs around a scene; private to src/study.
#pragma once

#include <cstdint>

#include "hdconj/scene.hpp"

namespace hdconj::accuracy {

/// Design @p number of the sample about @p scene: an additive recurrence in as many dimensions as there are numbers to
/// change, so that the designs fill the box evenly. Radial deformation 0.85 to 1.1 times that of the scene, wall 0.8
/// to 1.2, lengths and angles of the profile 0.94 to 1.06; the tip circle as it follows from them.
/// @param seed  turns the whole sequence
[[nodiscard]] Scene design_near(Scene const& scene, std::uint64_t seed, int number);

}  // namespace hdconj::accuracy
