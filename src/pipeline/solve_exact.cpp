// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "hdconj/motion/exact_motion.hpp"
#include "job.hpp"
#include "solve_motion.hpp"

namespace hdconj::detail {

namespace {

template<WaveShape Shape>
void run(Shape const& shape, Solution& out, Profile const& tooth, StageClock& clock)
{
    std::optional<NeutralCurve<Shape>> curve;
    clock.run(Stage::neutral_curve, [&] {
        curve.emplace(shape, out.geometry.r_m);
        out.geometry.r_0 = curve->r_0();
        out.error.arc_length = curve->relative_error();
        out.neutral_curve = sampled_neutral_curve(shape, curve->r_0());
    });
    std::optional<ExactMotion<Shape>> motion;
    clock.run(Stage::motion, [&] { motion.emplace(*curve, tooth_ratio(out.scene)); });
    SolveJob<ExactMotion<Shape>>(out, tooth, *motion, clock)();
}

}  // namespace

void solve_exact(AnyWaveShape const& shape, Solution& out, Profile const& tooth, StageClock& clock)
{
    std::visit([&](auto const& s) { run(s, out, tooth, clock); }, shape);
}

}  // namespace hdconj::detail
