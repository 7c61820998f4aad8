// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which effects a scene calls for that this version of the program does not compute.
#pragma once

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// One fault for each effect of @p scene that is read and validated but not computed yet. A result without an effect
/// that the scene asks for would be silently wrong, so `solve` refuses.
[[nodiscard]] Faults uncomputed_effects(Scene const& scene);

}  // namespace hdconj
