// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/solve.hpp"

#include <optional>

#include "drive.hpp"
#include "elastic_cup.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/elastic_cup.hpp"
#include "solve_middle.hpp"
#include "solve_motion.hpp"
#include "spread.hpp"

namespace hdconj {

Solution solve(Scene const& scene, StageObserver const& on_stage)
{
    return detail::solve_middle(scene, on_stage, detail::width_of_slices(scene));
}

Solution detail::solve_middle(Scene const& scene, StageObserver const& on_stage, std::optional<double> cup_error)
{
    Faults faults = check_scene(scene);
    if (!faults.empty())
        throw InputError(faults);

    if (scene.circular_spline.automatic_backlash)
        return detail::solve_with_automatic_backlash(scene, on_stage);
    Solution out;
    out.scene = scene;
    out.plan = make_plan(scene);
    out.threads = thread_count(scene.solver.threads);
    detail::StageClock clock(out.plan, on_stage);
    Profile tooth;
    AnyWaveShape shape;
    clock.run(Stage::profile, [&] {
        tooth = detail::given_tooth(scene, faults);
        shape = detail::wave_shape(scene, tooth, faults);
        out.segment_names = tooth.segment_names;
        out.geometry = detail::pair_geometry(scene, tooth, shape.amplitude());
    });
    bool const elastic = clock.run(Stage::cup, [&] {
        out.cup = detail::bent_cup(scene, out.geometry.flexspline_inner_radius, shape, out.threads);
        std::optional<BentCupError> known;
        if (cup_error)
        {
            known = detail::cup_error(scene, *out.cup, shape, out.geometry.r_m, *cup_error, out.threads);
            out.error.cup = known->displacement;
        }
        out.notes.push_back(describe(*out.cup, known));
    });
    if (elastic)
        detail::solve_elastic(out, tooth, clock);
    else
        switch (scene.solver.kinematics)
        {
            case Kinematics::exact: detail::solve_exact(shape, out, tooth, clock); break;
            case Kinematics::first_order: detail::solve_first_order(shape, out, tooth, clock); break;
            case Kinematics::material: detail::solve_material(shape, out, tooth, clock); break;
        }
    if (out.plan.has(Stage::surface))
        detail::spread_over_width(out, tooth, shape, clock);
    out.timing = clock.times();
    return out;
}

}  // namespace hdconj
