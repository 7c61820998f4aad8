// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "hdconj/judgement.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "judgement/judgement.hpp"
#include "wedm/faces.hpp"
#include "wedm/pitch_pass.hpp"
#include "wedm/sharp_corner.hpp"
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
        error.rethrow_unless_infeasible();
        return {};
    }
}

/// Whether a workpiece of @p thickness with the toothing of @p outline can be cut.
bool can_be_cut(Scene scene, CircularSplineOutline const& outline, double thickness)
{
    scene.wedm->thickness = thickness;
    wedm::WireJob const job(scene, faces_of(scene, outline));
    auto const passes = wedm::pitch_passes(job);
    if (wedm::leaves_too_much(job, passes.back()))
        return false;
    try {
        (void)wedm::set_up_program(job, passes, {});
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::failed_check)
            throw;
        return false;
    }
    return true;
}

/// Thickest workpiece, at least @p width and less than @p most, that can be cut, in whole mm or, where
/// that is too coarse, in tenths or less; 0 where none can be.
double largest_thickness(Scene const& scene, CircularSplineOutline const& outline, double width, double most)
{
    double const step = std::min(1.0, std::pow(10, std::floor(std::log10(most - width))));
    auto const works = [&](double steps) { return can_be_cut(scene, outline, steps * step); };
    double low = std::ceil(width / step), high = std::floor(most / step);
    if (!(low < high) || !works(low))
        return 0;
    // doubled first: a thickness far beyond the largest takes long to refuse
    while (2 * low < high && works(2 * low))
        low *= 2;
    high = std::min(high, 2 * low);
    while (high - low > 1) {
        double const middle = std::floor((low + high) / 2);
        (works(middle) ? low : high) = middle;
    }
    return low * step;
}

/// Refuses a workpiece so thick that straight rulings take its face too far.
/// @param most   thickness from which on that is so [mm]
/// @param other  what helps beside a thinner one
[[noreturn]] void refuse_thickness(Scene const& scene, CircularSplineOutline const& outline, double most,
                                   std::string cause, std::string const& other)
{
    double const thickness = wedm::thickness_of(scene), width = scene.circular_spline.width.value_or(thickness);
    double const largest = thickness > width ? largest_thickness(scene, outline, width, most) : 0;
    std::string const limit = fmt::format("{:.6g}", largest);
    Faults faults{{scene.wedm->thickness ? "wedm.thickness" : "circular_spline.width", 0, "", std::move(cause),
                   "write " + (largest > 0 ? "at most " + limit : "a smaller one") + ", or " + other}};
    if (largest > 0)
        faults.front().set = {"wedm.thickness=" + limit};
    scene::locate(faults, scene);
    throw InputError(std::move(faults));
}

/// @throws InputError where straight rulings meet at the axis before they reach a face of the workpiece
void refuse_crossed_axis(Scene const& scene, CircularSplineOutline const& outline)
{
    Vec2 const first = outline.outline.front().front(), last = outline.outline.back().front();
    if (outline.outline.size() == 1)
        return;
    // the land's middle stands on one radius in all sections
    Vec2 const axis = (first.norm() > last.norm() ? first : last).normalized();
    double const thickness = wedm::thickness_of(scene), middle = 0.5 * axis.dot(first + last),
                 slope = axis.dot(last - first) / (outline.z.back() - outline.z.front());
    double const tip = middle - 0.5 * std::abs(slope) * thickness;
    if (tip <= 0)
        refuse_thickness(scene, outline, 2 * middle / std::abs(slope),
                         fmt::format("the tilt would take the tip circle of the {} face to {:.4g} mm, beyond the axis",
                                     slope > 0 ? "lower" : "upper", tip),
                         "a smaller tilt");
}

/// Widths of the land between two spaces in both faces of a workpiece of @p thickness; below zero: its corners have
/// passed each other [rad].
std::array<double, 2> lands_of(CircularSplineOutline const& outline, int teeth, double thickness)
{
    wedm::WireFaces const faces = wedm::wire_faces(outline, teeth, thickness);
    auto const land = [&](std::vector<Vec2> const& points) {
        Vec2 const &right = points[faces.marks.front()], &left = points[faces.marks.back()];
        return 2 * std::numbers::pi / teeth -
               std::abs(std::atan2(right.x(), right.y()) - std::atan2(left.x(), left.y()));
    };
    return {land(faces.pitch.lower), land(faces.pitch.upper)};
}

/// @throws InputError where straight rulings leave no land in a face of the workpiece, beyond the toothing
void refuse_lost_land(Scene const& scene, CircularSplineOutline const& outline)
{
    if (outline.outline.size() == 1)
        return;
    int const teeth = scene.drive.circular_spline_teeth;
    double const thickness = wedm::thickness_of(scene), toothing = outline.z.back() - outline.z.front();
    auto const least_land = [&](double thick) { return std::ranges::min(lands_of(outline, teeth, thick)); };
    if (!(thickness > toothing) || least_land(thickness) > 0 || !(least_land(toothing) > 0))
        return;
    auto const [lower, upper] = lands_of(outline, teeth, thickness);
    double most = thickness;  // halved towards the toothing, which has a land
    while (most - toothing > scene.wedm->tolerance && least_land(most) <= 0)
        most = 0.5 * (most + toothing);
    refuse_thickness(
        scene, outline, 2 * most - toothing,
        fmt::format("beyond the toothing of {:.4g} mm the teeth go on in straight lines, and in the {} face "
                    "of a workpiece of {:.4g} mm no land is left between two of them",
                    toothing, lower < upper ? "lower" : "upper", thickness),
        "a larger circular_spline.inner_radius");
}

WireProgram spline_program(Scene const& scene, Solution const& solution)
{
    CircularSplineOutline const& outline = solution.circular_spline;
    wedm::check_slices(scene, outline);
    refuse_crossed_axis(scene, outline);
    refuse_lost_land(scene, outline);
    wedm::WireJob const job(scene, faces_of(scene, outline));
    auto const passes = wedm::pitch_passes(job);
    if (wedm::leaves_too_much(job, passes.back()))
        throw InputError(wedm::residual_fault(job, passes, reached_faces(scene)));
    WireProgram program = wedm::set_up_program(job, passes, {});
    if (std::string missing = missing_side_clearance(scene); !missing.empty())
        program.warnings.push_back(std::move(missing));
    program.cup_error = solution.error.cup;
    program.contour_error += solution.error.side_clearance;
    program.judgement = solution.judgement;
    program.notes = solution.notes;
    return program;
}

WireSetUps flexspline_programs(Scene const& scene, StageObserver const& on_stage)
{
    std::optional<Solution> solved;
    if (scene.is_reverse())
        solved = solve(scene, on_stage);
    wedm::WireJob const job(scene, wedm::flexspline_faces(scene, solved ? &*solved : nullptr));
    auto const passes = wedm::pitch_passes(job);
    if (wedm::leaves_too_much(job, passes.back()))
        throw InputError(wedm::residual_fault(job, passes, {}));
    WireSetUps programs = wedm::half_programs(job, passes);
    programs.front().judgement = solved ? solved->judgement : judge(scene);
    return programs;
}

}  // namespace

WireProgram wire_program(Scene const& scene, StageObserver const& on_stage)
{
    wedm::refuse_wire_faults(scene);
    return spline_program(scene, solve(wire_scene(scene), on_stage));
}

WireProgram wire_program(Scene const& scene, Solution const& solution)
{
    wedm::refuse_wire_faults(scene);
    WireProgram program = spline_program(scene, solution);
    judgement::judge_narrow_space_again(program.judgement, scene, solution);
    wedm::judge_sharp_corner(program.judgement, wire_scene(scene), solution.circular_spline);
    return program;
}

WireSetUps wire_set_ups(Scene const& scene, StageObserver const& on_stage)
{
    wedm::refuse_wire_faults(scene);
    return wedm::cuts_flexspline(scene) ? flexspline_programs(scene, on_stage)
                                        : WireSetUps{spline_program(scene, solve(wire_scene(scene), on_stage))};
}

}  // namespace hdconj
