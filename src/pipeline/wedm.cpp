// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm.hpp"

#include "hdconj/judgement.hpp"
#include "hdconj/solve.hpp"
#include "wedm/faces.hpp"
#include "wedm/pitch_pass.hpp"
#include "wedm/wire_job.hpp"

namespace hdconj {
namespace {

wedm::WireFaces faces_of(Scene const& scene, CircularSplineOutline const& outline)
{
    return wedm::wire_faces(outline, scene.drive.circular_spline_teeth, wedm::thickness_of(scene),
                            wedm::has_straight_rulings(scene));
}

/// The faces that the flexspline's teeth reach without load: those of the circular spline without root clearance.
/// Nothing where they reach the root, or cannot be solved for.
std::optional<wedm::WireFaces> reached_faces(Scene scene)
{
    if (scene.circular_spline.root_clearance <= 0)
        return {};
    scene.circular_spline.root_clearance = 0;
    try {
        return faces_of(scene, solve(wire_scene(scene)).circular_spline);
    } catch (InputError const&) {
        return {};
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        return {};
    }
}

WireProgram spline_program(Scene const& scene, CircularSplineOutline const& outline)
{
    wedm::check_slices(scene, outline);
    wedm::WireJob const job(scene, faces_of(scene, outline));
    auto const passes = wedm::pitch_passes(job);
    if (wedm::leaves_too_much(job, passes))
        throw InputError(wedm::residual_fault(job, passes, reached_faces(scene)));
    WireProgram program = wedm::set_up_program(job, passes, {});
    if (std::string missing = missing_side_clearance(scene); !missing.empty())
        program.warnings.push_back(std::move(missing));
    return program;
}

WireSetUps flexspline_programs(Scene const& scene, StageObserver const& on_stage)
{
    std::optional<Solution> solved;
    if (scene.is_reverse())
        solved = solve(scene, on_stage);
    wedm::WireJob const job(scene, wedm::flexspline_faces(scene, solved ? &*solved : nullptr));
    auto const passes = wedm::pitch_passes(job);
    if (wedm::leaves_too_much(job, passes))
        throw InputError(wedm::residual_fault(job, passes, {}));
    WireSetUps programs = wedm::half_programs(job, passes);
    programs.front().judgement = solved ? solved->judgement : judge(scene);
    return programs;
}

}  // namespace

WireProgram wire_program(Scene const& scene, StageObserver const& on_stage)
{
    wedm::refuse_wire_faults(scene);
    Solution const solution = solve(wire_scene(scene), on_stage);
    WireProgram program = spline_program(scene, solution.circular_spline);
    program.cup_error = solution.error.cup;
    program.contour_error += solution.error.side_clearance;
    program.judgement = solution.judgement;
    program.notes = solution.notes;
    return program;
}

WireProgram wire_program(Scene const& scene, CircularSplineOutline const& outline)
{
    wedm::refuse_wire_faults(scene);
    WireProgram program = spline_program(scene, outline);
    program.judgement = judge(wire_scene(scene));
    return program;
}

WireSetUps wire_set_ups(Scene const& scene, StageObserver const& on_stage)
{
    wedm::refuse_wire_faults(scene);
    return wedm::cuts_flexspline(scene) ? flexspline_programs(scene, on_stage)
                                        : WireSetUps{wire_program(scene, on_stage)};
}

}  // namespace hdconj
