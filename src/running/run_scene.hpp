// SPDX-License-Identifier: GPL-3.0-or-later
// What scene and options ask a running drive for.
#pragma once

#include <vector>

#include "hdconj/running.hpp"
#include "running_motion.hpp"

namespace hdconj::running {

/// A running drive as it is asked for, all that scene and options leave open filled in.
struct RunTask
{
    RunningMotion motion;
    /// Largest, on the output [N mm]; 0: first contact only, in the shape that the scene prescribes.
    double torque = 0;
    int positions = 0;                      ///< over a tooth pitch
    std::vector<double> torques = {};       ///< on the output, of the efficiency, increasing [N mm]
    std::vector<double> speeds = {};        ///< of the wave generator [rad/s]
    std::vector<double> temperatures = {};  ///< of the lubricant [degrees Celsius]
};

/// Domain: a scene without faults.
[[nodiscard]] RunTask run_task(Scene const& scene, RunOptions const& options);

/// The scene as its positions take it: under torque as `load` completes it, else as it stands.
/// @throws InputError with all faults of scene and options
[[nodiscard]] Scene checked_run_scene(Scene const& scene, RunOptions const& options);

}  // namespace hdconj::running
