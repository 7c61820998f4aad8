// SPDX-License-Identifier: GPL-3.0-or-later
// The neutral curve of a plane, and the motion of the tooth on it, by the model that the scene names.
#pragma once

#include "drive/stage_clock.hpp"
#include "hdconj/motion/any_motion.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::conjugate {

/// z_f / z_c.
[[nodiscard]] inline double tooth_ratio(Scene const& scene)
{
    return static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
}

/// Motion of the flexspline tooth for the kinematics of `out`.scene. Writes the neutral curve, its mean radius and
/// their errors into @p out.
[[nodiscard]] motion::AnyMotion plane_motion(wavegen::AnyWaveShape const& shape, Solution& out,
                                             drive::StageClock& clock);

/// The same with the displacements of the elastic cup `out`.cup at z = 0.
[[nodiscard]] motion::AnyMotion elastic_plane_motion(Solution& out, drive::StageClock& clock);

}  // namespace hdconj::conjugate
