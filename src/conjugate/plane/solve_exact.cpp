// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "conjugate_solver.hpp"
#include "hdconj/envelope/avoid_stationary_centres.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "reverse_solver.hpp"
#include "solve_motion.hpp"

namespace hdconj::conjugate {

void solve_exact(wavegen::AnyWaveShape const& shape, Solution& out, profile::Profile const& tooth,
                 drive::StageClock& clock)
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
    std::optional<motion::ExactMotion<wavegen::AnyWaveShape>> motion;
    clock.run(Stage::motion, [&] { motion.emplace(*curve, tooth_ratio(out.scene)); });
    if (out.scene.is_reverse())
        return solve_reverse(out, tooth, motion::ErasedMotion(*motion), clock);
    profile::Profile const clear = envelope::avoid_stationary_centres(tooth, *motion);
    ConjugateSolver<motion::ExactMotion<wavegen::AnyWaveShape>>(out, clear, *motion, clock)(tooth);
}

}  // namespace hdconj::conjugate
