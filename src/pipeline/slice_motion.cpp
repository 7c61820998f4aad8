// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_motion.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "hdconj/envelope/rest.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "solve_motion.hpp"

namespace hdconj::detail {
namespace {

template<RelativeMotion Motion>
struct Owned
{
    Owned(Motion made, Profile const& given) : motion(std::move(made)), tooth(clear_of_rest(given, motion)) {}

    Motion motion;
    Profile tooth;
};

template<RelativeMotion Motion>
SliceMotion owned(Motion motion, Profile const& tooth, double r_0, double amplitude)
{
    auto const object = std::make_shared<Owned<Motion> const>(std::move(motion), tooth);
    return {object, ErasedMotion(object->motion), &object->tooth, r_0, amplitude};
}

}  // namespace

SliceMotion slice_motion(Scene const& scene, Profile const& tooth, AnyWaveShape const& shape, double factor, double r_m)
{
    AnyWaveShape const scaled = factor == 1 ? shape : shape.scaled(factor);
    double const ratio = tooth_ratio(scene);
    if (scene.solver.kinematics == Kinematics::first_order)
        return owned(FirstOrderMotion<AnyWaveShape>(scaled, r_m, ratio), tooth, r_m, scaled.amplitude());
    if (scene.solver.kinematics == Kinematics::material)
        return owned(MaterialMotion(inextensional_mode(scaled), r_m, ratio), tooth, r_m, scaled.amplitude());
    NeutralCurve<AnyWaveShape> const curve(scaled, r_m);
    return owned(ExactMotion<AnyWaveShape>(curve, ratio), tooth, curve.r_0(), scaled.amplitude());
}

SliceMotion slice_motion(Scene const& scene, Profile const& tooth, MaterialDisplacement const& displacement, double r_m)
{
    constexpr int samples = 720;
    double amplitude = 0;
    for (int i = 0; i < samples; ++i)
        amplitude = std::max(amplitude, displacement_at(displacement, 2 * std::numbers::pi * i / samples).w[0]);
    return owned(MaterialMotion(displacement, r_m, tooth_ratio(scene)), tooth, r_m, amplitude);
}

}  // namespace hdconj::detail
