// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_motion.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "drive/elastic_cup.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "hdconj/wavegen/neutral_curve.hpp"

namespace hdconj::conjugate {
namespace {

/// One turn in the fixed frame, at equal steps. @param at  the point at an angle
template <class At>
std::vector<Vec2> one_turn(At const& at)
{
    constexpr int points = 720;
    std::vector<Vec2> result;
    result.reserve(points);
    for (int i = 0; i < points; ++i)
        result.push_back(at(2 * std::numbers::pi * i / points));
    return result;
}

/// The neutral curve rho = r_0 + w; every point is on the curve.
std::vector<Vec2> sampled_neutral_curve(wavegen::AnyWaveShape const& shape, double mean_radius)
{
    return one_turn([&](double u) -> Vec2 {
        double const rho = mean_radius + shape(u).w;
        return {rho * std::sin(u), rho * std::cos(u)};
    });
}

/// The displaced points.
std::vector<Vec2> displaced_points(wavegen::MaterialDisplacement const& displacement, double r_m)
{
    return one_turn([&](double phi) -> Vec2 {
        auto const [w, v] = wavegen::displacement_at(displacement, phi);
        double const s = std::sin(phi), c = std::cos(phi);
        return {(r_m + w[0]) * s + v[0] * c, (r_m + w[0]) * c - v[0] * s};
    });
}

motion::AnyMotion exact_motion(wavegen::AnyWaveShape const& shape, Solution& out, drive::StageClock& clock)
{
    std::optional<wavegen::NeutralCurve<wavegen::AnyWaveShape>> curve;
    clock.run(Stage::neutral_curve, [&] {
        curve.emplace(shape, out.geometry.r_m);
        out.geometry.r_0 = curve->r_0();
        out.error.arc_length = curve->relative_error();
        constexpr double roundings = 8;  // of the search for it
        out.error.r_0 = (curve->relative_error() + roundings * unit_roundoff) * out.geometry.r_m;
        out.neutral_curve = sampled_neutral_curve(shape, curve->r_0());
    });
    return clock.value_of(Stage::motion, [&] {
        motion::ExactMotion<wavegen::AnyWaveShape> motion(std::move(*curve), tooth_ratio(out.scene));
        auto const closed_form = motion::cosine_form(motion);
        return motion::AnyMotion::owning(std::move(motion), closed_form);
    });
}

motion::AnyMotion first_order_motion(wavegen::AnyWaveShape const& shape, Solution& out, drive::StageClock& clock)
{
    // the thesis leaves the mean radius at r_m: its curve is longer than the ring by 2 pi w0^2/r_m (n = 2)
    clock.run(Stage::neutral_curve, [&] {
        out.geometry.r_0 = out.geometry.r_m;
        out.neutral_curve = sampled_neutral_curve(shape, out.geometry.r_m);
    });
    return clock.value_of(Stage::motion, [&] {
        return motion::AnyMotion::owning(
            motion::FirstOrderMotion<wavegen::AnyWaveShape>(shape, out.geometry.r_m, tooth_ratio(out.scene)));
    });
}

/// @param given  makes the displacement
template <class Given>
motion::AnyMotion material_motion(Given const& given, Solution& out, drive::StageClock& clock)
{
    wavegen::MaterialDisplacement displacement;
    // a linear model measures w from the undeformed circle: its mean radius is r_m, its length right to first order
    clock.run(Stage::neutral_curve, [&] {
        displacement = given();
        out.geometry.r_0 = out.geometry.r_m;
        out.neutral_curve = displaced_points(displacement, out.geometry.r_m);
    });
    return clock.value_of(Stage::motion, [&] {
        return motion::AnyMotion::owning(
            motion::MaterialMotion(displacement, out.geometry.r_m, tooth_ratio(out.scene)));
    });
}

}  // namespace

motion::AnyMotion plane_motion(wavegen::AnyWaveShape const& shape, Solution& out, drive::StageClock& clock)
{
    Kinematics const model = out.scene.solver.kinematics;
    return model == Kinematics::first_order ? first_order_motion(shape, out, clock)
           : model == Kinematics::material
               ? material_motion([&] { return wavegen::inextensional_mode(shape); }, out, clock)
               : exact_motion(shape, out, clock);
}

motion::AnyMotion elastic_plane_motion(Solution& out, drive::StageClock& clock)
{
    return material_motion([&] { return drive::displacement_at(*out.cup, 0, out.geometry.r_m); }, out, clock);
}

}  // namespace hdconj::conjugate
