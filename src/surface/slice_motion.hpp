// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The motion of one slice, of any model, with what it is made of.
#pragma once

#include <memory>

#include "hdconj/motion/erased_motion.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::surface {

/// Owns a motion and the tooth that is solved under it.
struct SliceMotion
{
    std::shared_ptr<void const> owner;
    motion::ErasedMotion motion;
    profile::Profile const* tooth;  ///< the given tooth, clear of rest under this motion
    double r_0 = 0;                 ///< base radius of the deformed neutral curve, rho = r_0 + w(u) [mm]
    double amplitude = 0;           ///< w0(z) [mm]
};

/// The motion of the slice whose displacements are @p factor times those of @p shape, by the scene's kinematics.
/// @throws NumericalError as the neutral curve and the motion do
[[nodiscard]] SliceMotion slice_motion(Scene const& scene, profile::Profile const& tooth,
                                       wavegen::AnyWaveShape const& shape, double factor, double r_m);

/// The motion of the slice with these displacements.
[[nodiscard]] SliceMotion slice_motion(Scene const& scene, profile::Profile const& tooth,
                                       wavegen::MaterialDisplacement const& displacement, double r_m);

}  // namespace hdconj::surface
