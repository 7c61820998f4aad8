// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_motion.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "conjugate/plane/plane_motion.hpp"
#include "hdconj/envelope/avoid_stationary_centres.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"

namespace hdconj::surface {
namespace {

SliceMotion slice_of(motion::AnyMotion motion, profile::Profile const& tooth, double r_0, double amplitude)
{
    auto clear = std::make_shared<profile::Profile const>(envelope::avoid_stationary_centres(tooth, motion));
    return {std::move(motion), std::move(clear), r_0, amplitude};
}

}  // namespace

SliceMotion slice_motion(Scene const& scene, profile::Profile const& tooth, wavegen::AnyWaveShape const& shape,
                         double factor, double r_m)
{
    wavegen::AnyWaveShape const scaled = factor == 1 ? shape : shape.scaled(factor);
    double const ratio = conjugate::tooth_ratio(scene);
    if (scene.solver.kinematics == Kinematics::first_order)
        return slice_of(motion::AnyMotion::owning(motion::FirstOrderMotion<wavegen::AnyWaveShape>(scaled, r_m, ratio)),
                        tooth, r_m, scaled.amplitude());
    if (scene.solver.kinematics == Kinematics::material)
        return slice_of(
            motion::AnyMotion::owning(motion::MaterialMotion(wavegen::inextensional_mode(scaled), r_m, ratio)), tooth,
            r_m, scaled.amplitude());
    wavegen::NeutralCurve<wavegen::AnyWaveShape> const curve(scaled, r_m);
    return slice_of(motion::AnyMotion::owning(motion::ExactMotion<wavegen::AnyWaveShape>(curve, ratio)), tooth,
                    curve.r_0(), scaled.amplitude());
}

SliceMotion slice_motion(Scene const& scene, profile::Profile const& tooth,
                         wavegen::MaterialDisplacement const& displacement, double r_m)
{
    constexpr int samples = 720;
    double amplitude = 0;
    for (int i = 0; i < samples; ++i)
        amplitude =
            std::max(amplitude, wavegen::displacement_at(displacement, 2 * std::numbers::pi * i / samples).w[0]);
    return slice_of(motion::AnyMotion::owning(motion::MaterialMotion(displacement, r_m, conjugate::tooth_ratio(scene))),
                    tooth, r_m, amplitude);
}

}  // namespace hdconj::surface
