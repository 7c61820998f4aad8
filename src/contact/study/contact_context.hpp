// SPDX-License-Identifier: GPL-3.0-or-later
// What all surfaces of a study are computed with.
#pragma once

#include <numeric>

#include "drive/stage_clock.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/solution.hpp"
#include "surface/tooth_surface.hpp"

namespace hdconj::contact {

class ToothPoseCache;

/// What all cases of a study share.
struct ContactContext
{
    Scene const& scene;
    profile::Profile const& tooth;
    wavegen::AnyWaveShape const& shape;
    PairGeometry const& geometry;
    surface::ToothSurfaceBuilder& maker;
    ContactRequest request;
    int threads = 1;
    double width = 0;  ///< [mm]
    Tolerance tolerance;
    drive::StageClock& clock;
    ToothPoseCache& places;
    elastic::BentCup const* cup = nullptr;  ///< null: the linear cone, or none
};

/// Whether one flank stands for both.
[[nodiscard]] inline bool has_mirrored_flanks(ContactContext const& context)
{
    return context.tooth.mirror_symmetric && context.maker.motion(0).motion.symmetric();
}

/// Times that teeth, spaces and wave are the same around the ring.
[[nodiscard]] inline int lobes_of(ContactContext const& context)
{
    auto const& drive = context.scene.drive;
    return std::gcd(context.scene.wave_generator.waves, std::gcd(drive.flexspline_teeth, drive.circular_spline_teeth));
}

/// Side clearance that a scene gives; "auto" gives none [mm].
[[nodiscard]] inline double given_clearance(Scene const& scene)
{
    return scene.circular_spline.automatic_backlash ? 0 : scene.circular_spline.backlash_offset;
}

}  // namespace hdconj::contact
