// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_case.hpp"

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "bearing_map.hpp"
#include "catalogue_figures.hpp"
#include "contact/study/contact_case.hpp"
#include "hdconj/error.hpp"
#include "load/model/cup_shape.hpp"
#include "load_problem.hpp"

namespace hdconj::load {
namespace {

/// Refuses a surface whose teeth interfere at every turn. What to write depends on what the scene says already.
[[noreturn]] void refuse_assembly(Scene const& scene, surface::SurfaceSpec const& choice, double side_clearance)
{
    bool const in_planes = scene.coning && !scene.maps_axial_shift();
    std::string const advice =
        in_planes ? "axial_shift = \"mapped\" in [coning], since the cup's sections do not stay in their planes"
        : choice.surface != ToothSurface::per_slice ? "surface = \"per-slice\" in [slices]"
                                                    : "a larger circular_spline.backlash_offset";
    throw NumericalError(ErrorCode::interference, "load", "assembly",
                         "cup and circular spline interfere in every position of the circular spline, even with a "
                         "side clearance of " +
                             short_number(side_clearance) + " mm",
                         "write " + advice + ", or a larger circular_spline.inner_radius");
}

/// A surface with the play that it leaves.
struct SurfaceWithPlay
{
    contact::FlankSurface surface;
    Play play;
    bool side_clearance_increased = false;  ///< the side clearance is larger than the scene gives
};

/// The surface with the scene's side clearance or, where with that the assembled teeth press on both flanks, with the
/// smallest that clears.
SurfaceWithPlay surface_with_play(contact::ContactContext const& context, AssembledDrive const& drive,
                                  surface::SurfaceSpec const& choice)
{
    bool const automatic = context.scene.circular_spline.automatic_backlash;
    auto const play_in = [&](contact::FlankSurface const& surface) {
        return play_of(load_problem(context, drive.model.drive, surface.grid), drive.unloaded.shape);
    };
    contact::FlankSurface surface = contact::flank_surface(context, choice);
    std::optional<Play> play = play_in(surface);
    bool side_clearance_increased = false;
    if (!automatic && !(play && width_of(*play) >= 0)) {
        double const given = surface.offset;
        surface = contact::flank_surface(context, choice, true);
        side_clearance_increased = surface.offset > given;
        play = play_in(surface);
    }
    if (!play)
        refuse_assembly(context.scene, choice, surface.offset);
    return {std::move(surface), *play, side_clearance_increased};
}

/// What is known of a case before any torque.
LoadCase assembled_case(contact::ContactContext const& context, surface::SurfaceSpec const& choice,
                        SurfaceWithPlay const& assembled)
{
    LoadCase result;
    result.surface = choice.surface;
    if (choice.tilt != 0 || context.scene.tilt)
        result.kind = choice.kind;
    result.tilt = choice.tilt;
    result.side_clearance_increased = assembled.side_clearance_increased;
    result.backlash_offset = assembled.surface.offset;
    result.tip = assembled.surface.tip;
    if (!context.scene.circular_spline.automatic_backlash)
        result.tip_radius_increase = assembled.surface.tip - context.maker.nominal_tip(choice).radius;
    result.backlash = width_of(assembled.play);
    return result;
}

/// The two stages of the branch from 0 to the largest torque. A slope is as uncertain as the elastic twist that the
/// branch rises over.
StiffnessStages stages_of(LoadCase const& solved)
{
    std::vector<double> twist, torque;
    for (std::size_t i = 0; i <= solved.rated && i < solved.curve.size(); ++i)
        if (solved.curve[i].torque > 0) {
            twist.push_back(solved.curve[i].twist);
            torque.push_back(solved.curve[i].torque);
        }
    if (twist.size() < 2)
        return {};
    StiffnessStages stages = stiffness_stages(twist, torque);
    if (!solved.estimated)
        return stages;
    double const elastic = std::abs(solved.curve[solved.rated].twist) - solved.backlash / 2;
    double const relative = elastic > 0 ? (solved.error.twist + solved.backlash_error / 2) / elastic : 0;
    stages.first_error += relative * stages.first;
    stages.second_error += relative * stages.second;
    return stages;
}

/// Enters the largest stress at the largest torque and, where @p coarse_forces are known, its error.
void enter_stress(contact::ContactContext const& context, DrivePair const& drives, elastic::HarmonicField const& field,
                  Eigen::MatrixXd const& coarse_forces, LoadCase& result)
{
    LoadModel const& model = drives.fine.model;
    CupStress const stress = cup_stress(model, field, context.threads);
    LoadedState& state = result.curve[result.rated];
    state.largest_stress = stress.peak.stress;
    state.stress_r = stress.peak.at.x();
    state.stress_z = stress.peak.at.y() - model.middle;
    state.stress_phi = stress.peak.phi;
    if (!result.estimated)
        return;
    LoadModel const& coarse = drives.coarse->model;
    CupStress const other = cup_stress(coarse, cup_field(coarse, coarse_forces, context.threads), context.threads);
    result.error.largest_stress =
        grid_safety(model.drive.slice_z.size()) * std::abs(stress.peak.stress - other.peak.stress) + stress.at_corners;
    result.curve_error[result.rated]->largest_stress = result.error.largest_stress;
}

}  // namespace

LoadedCurve loaded_curve(LoadProblem const& problem, LoadedDrive const& unloaded, Play const& play,
                         std::vector<double> const& torques, std::function<void()> const& on_state)
{
    TorqueContinuation const path = torque_continuation(problem, unloaded, play);
    LoadedCurve curve;
    curve.play = width_of(play);
    curve.middle = path.middle;
    double largest = -1;
    LoadedDrive at = path.start;
    std::optional<NumericalError> first;
    for (double const torque : torques) {
        try {
            at = advance(path, at, torque);
            curve.states.push_back(loaded_state(problem, at, path.middle));
            curve.bearing.push_back(bearing_map(problem.drive, at.state));
            if (std::abs(torque) > largest) {
                largest = std::abs(torque);
                curve.rated = curve.states.size() - 1;
                curve.at_rated = at;
            }
        } catch (NumericalError const& error) {
            if (!error.is_infeasible())
                throw;
            curve.unsettled.push_back({torque, error.cause()});
            if (!first)
                first.emplace(error);
        }
        if (on_state)
            on_state();
    }
    if (first && !(largest > 0))
        throw NumericalError(*first);
    return curve;
}

SolvedCase load_case(contact::ContactContext const& context, DrivePair const& drives,
                     surface::SurfaceSpec const& choice, std::vector<double> const& torques,
                     CaseObserver const& observer)
{
    auto const begin = std::chrono::steady_clock::now();
    AssembledDrive const& fine = drives.fine;
    SurfaceWithPlay const assembled = surface_with_play(context, fine, choice);
    LoadCase result = assembled_case(context, choice, assembled);
    if (observer.on_play)
        observer.on_play(result);
    LoadProblem const problem = load_problem(context, fine.model.drive, assembled.surface.grid);
    LoadedCurve const curve = loaded_curve(problem, fine.unloaded, assembled.play, torques, observer.on_state);
    result.curve = curve.states;
    result.unsettled = curve.unsettled;
    result.rated = curve.rated;
    result.map = load_map(problem, curve.at_rated);
    result.bearing = curve.bearing[curve.rated];
    LoadedState const& rated = curve.states[curve.rated];
    std::vector<double> const& z = result.map.z;
    result.pressure_at_edge =
        z.size() > 1 && rated.largest_pressure > 0 && (rated.pressure_z <= z.front() || rated.pressure_z >= z.back());
    CurveErrors errors;
    if (drives.coarse)
        errors = curve_errors(context, *drives.coarse, assembled.surface.grid, curve);
    result.curve_error = std::move(errors.states);
    result.backlash_error = errors.play;
    result.estimated = drives.coarse && result.curve_error[result.rated];
    if (result.estimated)
        result.error = *result.curve_error[result.rated];
    result.stages = stages_of(result);
    if (torques.size() > 1)
        result.catalogue = catalogue_figures(problem, drives, assembled.surface.grid, assembled.play, result);
    elastic::HarmonicField field = cup_field(fine.model, curve.at_rated.forces, context.threads);
    enter_stress(context, drives, field, errors.rated_forces, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return {std::move(result), std::move(field)};
}

}  // namespace hdconj::load
