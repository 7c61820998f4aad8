// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/solve.hpp"

#include <optional>

#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/scene/effects.hpp"
#include "job.hpp"

namespace hdconj {

namespace {

/// One closed turn of the deformed neutral curve in the fixed frame; every point is on the curve.
template<WaveShape Shape>
std::vector<Vec2> sampled_curve(NeutralCurve<Shape> const& curve)
{
    constexpr int points = 720;
    std::vector<Vec2> result;
    for (int i = 0; i < points; ++i)
    {
        double const u = 2 * std::numbers::pi * i / points;
        double const rho = curve.r_0() + curve.shape()(u).w;
        result.emplace_back(rho * std::sin(u), rho * std::cos(u));
    }
    return result;
}

template<WaveShape Shape>
void solve_for(Shape const& shape, Solution& out, Profile const& tooth, detail::StageClock& clock)
{
    Scene const& scene = out.scene;
    double const ratio = static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
    std::optional<NeutralCurve<Shape>> curve;
    clock.run(Stage::neutral_curve, [&] {
        curve.emplace(shape, out.geometry.r_m);
        bool const exact = scene.solver.kinematics == Kinematics::exact;
        out.geometry.r_0 = exact ? curve->r_0() : out.geometry.r_m;
        out.error.arc_length = curve->relative_error();
        out.neutral_curve = sampled_curve(*curve);
    });
    if (scene.solver.kinematics == Kinematics::exact)
    {
        std::optional<ExactMotion<Shape>> motion;
        clock.run(Stage::motion, [&] { motion.emplace(*curve, ratio); });
        detail::SolveJob<ExactMotion<Shape>>(out, tooth, *motion, clock)();
    }
    else
    {
        std::optional<FirstOrderMotion<Shape>> motion;
        clock.run(Stage::motion, [&] { motion.emplace(shape, out.geometry.r_m, ratio); });
        detail::SolveJob<FirstOrderMotion<Shape>>(out, tooth, *motion, clock)();
    }
}

}  // namespace

Solution solve(Scene const& scene, StageObserver const& on_stage)
{
    Faults faults = uncomputed_effects(scene);
    Faults const geometry = check_scene(scene);
    faults.insert(faults.end(), geometry.begin(), geometry.end());
    if (!faults.empty())
        throw InputError(faults);

    Solution out;
    out.scene = scene;
    out.plan = make_plan(scene);
    out.threads = thread_count(scene.solver.threads);
    detail::StageClock clock(out.plan, on_stage);
    Profile tooth;
    AnyWaveShape shape;
    clock.run(Stage::profile, [&] {
        tooth = detail::flexspline_tooth(scene, faults);
        shape = build_wave_shape(scene.wave_generator.shape, scene.wave_generator.waves, faults);
        out.segment_names = tooth.segment_names;
        out.flexspline_outline = polygon_of(tooth, scene.solver.tolerance);
        for (Vec2& p : out.flexspline_outline)
            p.y() -= tooth.pitch_line;
        double const amplitude = std::visit([](auto const& s) { return s.amplitude(); }, shape);
        out.geometry = detail::pair_geometry(scene, tooth, amplitude);
    });
    std::visit([&](auto const& s) { solve_for(s, out, tooth, clock); }, shape);
    out.timing = clock.times();
    return out;
}

}  // namespace hdconj
