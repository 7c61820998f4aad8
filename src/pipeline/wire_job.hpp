// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the steps of `wedm` ask a scene with [wedm]; private to src/pipeline.
#pragma once

#include <string>
#include <utility>

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/scene.hpp"
#include "hdconj/wedm/faces.hpp"

namespace hdconj::detail {

/// A fault of a key; locate() finds its line and value.
[[nodiscard]] inline Fault fault_at(std::string path, std::string reason, std::string remedy)
{
    return {std::move(path), 0, "", std::move(reason), std::move(remedy)};
}

/// Whether the flexspline is the part.
[[nodiscard]] inline bool cuts_flexspline(Scene const& scene)
{
    return scene.wedm->part == WirePart::flexspline;
}

/// Teeth of the part.
[[nodiscard]] inline int wire_teeth(Scene const& scene)
{
    return cuts_flexspline(scene) ? scene.drive.flexspline_teeth : scene.drive.circular_spline_teeth;
}

/// Of the workpiece [mm]; 0: not stated.
[[nodiscard]] inline double thickness_of(Scene const& scene)
{
    return scene.wedm->thickness.value_or(scene.circular_spline.width.value_or(0));
}

/// Tilt of the part's teeth [rad].
[[nodiscard]] inline double tilt_of(Scene const& scene)
{
    return scene.tilt ? scene.tilt->angle : 0;
}

/// Whether the slices of the circular spline have outlines of their own.
[[nodiscard]] inline bool follows_cone(Scene const& scene)
{
    return scene.coning && scene.slices && scene.slices->count > 1 && scene.slices->surface != "tilted";
}

}  // namespace hdconj::detail
