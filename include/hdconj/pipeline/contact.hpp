// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `contact`: how much flank touches, and what the circular spline's surface and tilt do to it.
#pragma once

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/pipeline/contact_study.hpp"
#include "hdconj/pipeline/solve.hpp"

namespace hdconj {

/// What is asked beside the scene. Empty lists: as the scene says.
struct ContactOptions
{
    std::vector<double> tilts;          ///< [rad]
    std::vector<std::string> surfaces;  ///< "tilted", "ruled", "per-slice"
    std::vector<std::string> kinds;     ///< "radial", "draft"
    bool best = false;                  ///< look for the best tilt of each kind
    double best_from = 0;               ///< [rad]
    double best_to = 2 * std::numbers::pi / 180;
    int revolution = 0;                 ///< angles of the wave generator over a revolution; 0: the scene's only
};

/// Told how much of the long work is done, 0 ... 1.
using Progress = std::function<void(std::string const& what, double share)>;

/// Slices that effects along the axis are looked at with where the scene has no [slices].
inline constexpr int standard_slices = 17;

/// Scene and options against each other.
[[nodiscard]] Faults check_contact(Scene const& scene, ContactOptions const& options);

/// Clearances, clearing offsets, play and contact areas of every combination of surface, kind and tilt (design 3.4, 3.5).
///
/// Gaps are distances in the planes of the slices, from exact points of the circular spline to exact teeth. With [coning] and
/// axial_shift = "mapped" the teeth in a plane are those parts of the cup that have moved into it, for gaps and for full turns (SurfaceMaker::follows_sections() says where not).
/// Same bits for any number of threads. A case that cannot be made leaves the others as they are and is named in ContactStudy::missing.
/// @throws InputError for a scene or options that cannot be computed; NumericalError with stage, place and cause where no case can be made
[[nodiscard]] ContactStudy contact(Scene const& scene, ContactOptions const& options = {}, StageObserver const& on_stage = {}, Progress const& progress = {});

}  // namespace hdconj
