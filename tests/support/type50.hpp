// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The built-in drive's parts, for tests of single rooms.
#pragma once

#include <utility>

#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"

namespace hdconj::test {

using Exact = motion::ExactMotion<wavegen::CosineCam>;
using FirstOrder = motion::FirstOrderMotion<wavegen::CosineCam>;

inline profile::ToothPlace place_of(Scene const& scene)
{
    return {scene.drive.module,    scene.drive.flexspline_teeth,
            scene.flexspline.wall, scene.flexspline.neutral_offset,
            scene.folder.string(), false};
}

inline profile::Profile type50_tooth(std::vector<std::string> const& overrides = {})
{
    Scene const scene = builtin_scene(overrides);
    Faults faults;
    profile::Profile tooth = profile::build_profile(scene.flexspline.profile, place_of(scene), faults);
    if (!faults.empty())
        throw InputError(faults);
    return tooth;
}

inline constexpr double type50_r_m = 24.347;
inline constexpr double type50_w0 = 0.25;
inline constexpr int type50_z_f = 200;
inline constexpr int type50_z_c = 202;
inline constexpr double type50_ratio = static_cast<double>(type50_z_f) / type50_z_c;

inline Exact type50_motion(int waves = 2, double w0 = type50_w0)
{
    return Exact(wavegen::NeutralCurve<wavegen::CosineCam>(wavegen::CosineCam{w0, waves}, type50_r_m), type50_ratio);
}

inline FirstOrder type50_first_order(int waves = 2, double w0 = type50_w0)
{
    return FirstOrder(wavegen::CosineCam{w0, waves}, type50_r_m, type50_ratio);
}

}  // namespace hdconj::test
