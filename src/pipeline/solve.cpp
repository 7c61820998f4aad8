// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/solve.hpp"

#include <cmath>
#include <vector>

#include "drive.hpp"
#include "elastic_cup.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/elastic_cup.hpp"
#include "spread.hpp"
#include "solve_motion.hpp"

namespace hdconj {

namespace {

/// polygon_of() piece by piece, the same bits.
std::vector<Vec2> polygon_of(Profile const& profile, double chord, int threads)
{
    std::vector<std::vector<Vec2>> parts(profile.pieces.size());
    // the longest pieces have about this many chords
    double const chords = std::sqrt((profile.addendum + profile.dedendum) / chord);
    constexpr double chords_worth_a_thread = 32768;
    parallel_for(parts.size(), threads, static_cast<std::size_t>(std::ceil(chords_worth_a_thread / chords)), [&](std::size_t i) {
        if (profile.pieces[i].corner)
            return;
        Profile part;
        part.pieces = {profile.pieces[i]};
        parts[i] = hdconj::polygon_of(part, chord);
    });
    std::vector<Vec2> points;
    for (std::vector<Vec2> const& part : parts)
        points.insert(points.end(), part.begin() + (points.empty() || part.empty() ? 0 : 1), part.end());
    return points;
}

}  // namespace

Solution solve(Scene const& scene, StageObserver const& on_stage)
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
        if (!scene.is_reverse())
            out.flexspline_outline = polygon_of(tooth, scene.solver.tolerance, out.threads);
        for (Vec2& p : out.flexspline_outline)
            p.y() -= tooth.pitch_line;
        out.geometry = detail::pair_geometry(scene, tooth, shape.amplitude());
    });
    bool const elastic = clock.run(Stage::cup, [&] {
        out.cup = detail::bent_cup(scene, out.geometry.flexspline_inner_radius, shape, out.threads);
        out.notes.push_back(describe(*out.cup));
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
