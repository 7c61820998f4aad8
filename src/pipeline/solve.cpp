// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/solve.hpp"
#include "base/text.hpp"

#include <utility>

#include "conjugate/plane/solve_plane.hpp"
#include "contact/clearance/side_clearance_search.hpp"
#include "contact/study/contact_case.hpp"
#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/scene/reading.hpp"
#include "surface/build_slices.hpp"
#include "wedm/sharp_corner.hpp"

namespace hdconj {
namespace {

/// Solves a scene with backlash_offset = "auto": first for the least side clearance (and the tip circle that goes with
/// it), then with it.
Solution solve_with_automatic_backlash(Scene const& scene, StageObserver const& on_stage)
{
    Scene given = scene;
    given.circular_spline.automatic_backlash = false;
    given.circular_spline.backlash_offset = 0;
    std::string note = "side clearance \"auto\": none is needed";
    double error = 0;
    bool const moves = scene.slices && scene.slices->count > 1 && (scene.coning || scene.tilt);
    if (moves) {
        if (on_stage)
            on_stage(Stage::clearance);
        contact::SideClearanceNeed const need = contact::side_clearance_need(scene);
        given.circular_spline.backlash_offset = need.offset;
        bool const wider = need.tip > need.nominal_tip_radius;
        if (wider)
            given.circular_spline.inner_radius = need.tip;
        error = need.error;
        note = "side clearance \"auto\": " + short_number(need.offset) +
               (error > 0 ? " +- " + short_number(error) : "") + " mm" +
               (wider ? ", with a tip circle of " + short_number(need.tip) + " in place of " +
                            short_number(need.nominal_tip_radius) + " mm"
                      : "");
    }
    Solution out = solve(given, on_stage);
    out.scene.text = scene.text;
    out.scene.circular_spline.automatic_backlash = true;
    out.notes.insert(out.notes.begin(), note);
    contact::add_side_clearance_error(out.error, error);
    return out;
}

}  // namespace

Solution solve(Scene const& scene, StageObserver const& on_stage)
{
    throw_if_any(scene::value_faults(scene));
    throw_if_any(check_scene(scene));
    if (scene.circular_spline.automatic_backlash)
        return solve_with_automatic_backlash(scene, on_stage);
    conjugate::SolvedPlane plane;
    Solution& out = plane.solution;
    out.scene = scene;
    out.plan = make_plan(scene);
    drive::StageClock clock(out.plan, on_stage);
    conjugate::solve_plane(plane, clock, drive::width_of_slices(scene));
    if (out.plan.has(Stage::surface))
        surface::build_slices(out, plane.tooth, plane.shape, clock);
    wedm::judge_sharp_corner(out.judgement, scene, out.circular_spline);
    out.timing = clock.times();
    return std::move(out);
}

}  // namespace hdconj
