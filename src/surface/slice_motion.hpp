// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of one slice, of any model.
#pragma once

#include <memory>

#include "hdconj/motion/any_motion.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::surface {

/// A motion and the tooth that is solved under it.
struct SliceMotion
{
    motion::AnyMotion motion;
    std::shared_ptr<profile::Profile const> tooth;  ///< the given one after avoid_stationary_centres()
    double r_0 = 0;        ///< base radius of the deformed neutral curve, rho = r_0 + w(u) [mm]
    double amplitude = 0;  ///< w0(z) [mm]
};

/// The motion of the slice whose displacements are @p factor times those of @p shape, by the scene's kinematics.
/// @throws NumericalError as the neutral curve and the motion do
[[nodiscard]] SliceMotion slice_motion(Scene const& scene, profile::Profile const& tooth,
                                       wavegen::AnyWaveShape const& shape, double factor, double r_m);

/// The motion of the slice with these displacements.
[[nodiscard]] SliceMotion slice_motion(Scene const& scene, profile::Profile const& tooth,
                                       wavegen::MaterialDisplacement const& displacement, double r_m);

}  // namespace hdconj::surface
