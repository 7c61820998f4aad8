// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "conjugate_solver.hpp"
#include "hdconj/envelope/avoid_stationary_centres.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "reverse_solver.hpp"
#include "solve_motion.hpp"

namespace hdconj::conjugate {

void solve_first_order(wavegen::AnyWaveShape const& shape, Solution& out, profile::Profile const& tooth,
                       drive::StageClock& clock)
{
    // the thesis leaves the mean radius at r_m: its curve is longer than the ring by 2 pi w0^2/r_m (n = 2)
    clock.run(Stage::neutral_curve, [&] {
        out.geometry.r_0 = out.geometry.r_m;
        out.neutral_curve = sampled_neutral_curve(shape, out.geometry.r_m);
    });
    std::optional<motion::FirstOrderMotion<wavegen::AnyWaveShape>> motion;
    clock.run(Stage::motion, [&] { motion.emplace(shape, out.geometry.r_m, tooth_ratio(out.scene)); });
    if (out.scene.is_reverse())
        return solve_reverse(out, tooth, motion::ErasedMotion(*motion), clock);
    profile::Profile const clear = envelope::avoid_stationary_centres(tooth, *motion);
    ConjugateSolver<motion::FirstOrderMotion<wavegen::AnyWaveShape>>(out, clear, *motion, clock)(tooth);
}

}  // namespace hdconj::conjugate
