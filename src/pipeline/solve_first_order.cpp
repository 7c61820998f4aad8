// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "hdconj/envelope/rest.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "job.hpp"
#include "reverse_job.hpp"
#include "solve_motion.hpp"

namespace hdconj::detail {

void solve_first_order(AnyWaveShape const& shape, Solution& out, Profile const& tooth, StageClock& clock)
{
    // the thesis leaves the mean radius at r_m: its curve is longer than the ring by 2 pi w0^2/r_m (n = 2)
    clock.run(Stage::neutral_curve, [&] {
        out.geometry.r_0 = out.geometry.r_m;
        out.neutral_curve = sampled_neutral_curve(shape, out.geometry.r_m);
    });
    std::optional<FirstOrderMotion<AnyWaveShape>> motion;
    clock.run(Stage::motion, [&] { motion.emplace(shape, out.geometry.r_m, tooth_ratio(out.scene)); });
    if (out.scene.is_reverse())
        return solve_reverse(out, tooth, ErasedMotion(*motion), clock);
    Profile const clear = clear_of_rest(tooth, *motion);
    SolveJob<FirstOrderMotion<AnyWaveShape>>(out, clear, *motion, clock)(tooth);
}

}  // namespace hdconj::detail
