// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `load`: the elastic cup on its wave generator, teeth under torque.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/pipeline/contact.hpp"
#include "hdconj/pipeline/load_study.hpp"

namespace hdconj {

/// What is asked beside the scene. Empty lists: as the scene says.
struct LoadOptions
{
    std::vector<double> tilts;          ///< [rad]
    std::vector<std::string> surfaces;  ///< "tilted", "ruled", "per-slice"
    std::vector<std::string> kinds;     ///< "radial", "draft"
    std::optional<double> torque;       ///< rated torque [N mm]
    std::optional<int> points;          ///< torques on the way up
    bool curve = true;                  ///< false: the rated torque only
};

/// Scene and options against each other.
[[nodiscard]] Faults check_load(Scene const& scene, LoadOptions const& options);

/// The scene as `load` takes it: with slices across the width and an elastic cup where it says nothing of them.
[[nodiscard]] Scene loaded_scene(Scene asked, LoadOptions const& options = {});

/// Every combination of surface, kind and tilt under torque (design 3.6).
///
/// Elastic cup (Fourier harmonics), unilateral contact with the wave generator, unilateral flank contacts with the gaps of the loaded shape; gaps
/// and normals are taken again in the loaded shape until the linear model and the geometry agree. Small displacements of the cup about its
/// undeformed shape; no friction. Same bits for any number of threads.
/// @param talk  told the first figures in words as soon as they are known: force and coning of the assembled cup, then play of each surface
/// @throws InputError for a scene or options that cannot be computed; NumericalError with stage, place and cause where no case can be (LoadStudy::missing)
[[nodiscard]] LoadStudy load(Scene const& scene, LoadOptions const& options = {}, StageObserver const& on_stage = {}, Progress const& progress = {},
                             std::function<void(std::string const&)> const& talk = {});

/// Two straight lines through (twist, torque) by least squares, the bend where they fit best. Points in order of growing torque, all of one sign.
/// Fewer than six points, or no bend that chance would not make of a straight line with noise (1 %): `found` is false and both slopes are those of
/// one line. Fewer than two different twists: all zero. Global least squares over slopes and bend (Hudson 1966), in time points^2.
/// @throws std::logic_error where there are not as many torques as twists
[[nodiscard]] StiffnessStages stiffness_stages(std::vector<double> const& twist, std::vector<double> const& torque);

}  // namespace hdconj
