// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "hdconj/envelope/rest.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "job.hpp"
#include "reverse_job.hpp"
#include "solve_motion.hpp"

namespace hdconj::detail {

void solve_exact(AnyWaveShape const& shape, Solution& out, Profile const& tooth, StageClock& clock)
{
    std::optional<NeutralCurve<AnyWaveShape>> curve;
    clock.run(Stage::neutral_curve, [&] {
        curve.emplace(shape, out.geometry.r_m);
        out.geometry.r_0 = curve->r_0();
        out.error.arc_length = curve->relative_error();
        constexpr double roundings = 8;   // of the search for it
        out.error.r_0 = (curve->relative_error() + roundings * unit_roundoff) * out.geometry.r_m;
        out.neutral_curve = sampled_neutral_curve(shape, curve->r_0());
    });
    std::optional<ExactMotion<AnyWaveShape>> motion;
    clock.run(Stage::motion, [&] { motion.emplace(*curve, tooth_ratio(out.scene)); });
    if (out.scene.is_reverse())
        return solve_reverse(out, tooth, ErasedMotion(*motion), clock);
    Profile const clear = clear_of_rest(tooth, *motion);
    SolveJob<ExactMotion<AnyWaveShape>>(out, clear, *motion, clock)(tooth);
}

}  // namespace hdconj::detail
