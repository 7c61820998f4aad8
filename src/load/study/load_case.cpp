// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "bearing_map.hpp"
#include "catalogue_figures.hpp"
#include "contact/study/contact_case.hpp"
#include "hdconj/error.hpp"
#include "load/model/cup_shape.hpp"
#include "load/model/ring_errors.hpp"
#include "load_problem.hpp"
#include "twist_members.hpp"

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
        side_clearance_increased = surface.offset > given + context.tolerance.length;
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
    if (double const increase = assembled.surface.tip - context.maker.nominal_tip(choice).radius;
        !context.scene.circular_spline.automatic_backlash && increase > context.tolerance.length)
        result.tip_radius_increase = increase;
    result.backlash = width_of(assembled.play);
    return result;
}

/// Whether the drive under a torque is the mirror image of itself under the opposite one.
bool is_mirror_image(contact::ContactContext const& context)
{
    return contact::has_mirrored_flanks(context) && !break_the_mirror(context.scene) &&
           context.request.wave_generator == 0 && context.scene.bearing->ball_phase == 0;
}

/// A branch with its errors.
struct BranchWithErrors
{
    TorqueBranch branch;
    BranchErrors errors;  ///< empty without a coarse grid
};

/// The paths of a case on the grid asked for and on the coarse grid.
struct PathPair
{
    TorqueContinuation const& fine;
    TorqueContinuation const* coarse;  ///< null: none
    double safety;                     ///< of errors
    double series;                     ///< compliance in series with the teeth [rad/(N mm)]; 0: none
};

BranchWithErrors solved_branch(PathPair const& paths, BranchTorques const& torques,
                               std::function<void(double)> const& on_state)
{
    BranchWithErrors result{torque_branch(paths.fine, torques, on_state), {}};
    if (torques.given.size() == 1)
        result.branch.states.back().stiffness = stiffness_at(paths.fine, result.branch.last);
    else
        enter_stiffness(result.branch.states, free_twist(paths.fine, torques.given.back()));
    if (paths.coarse)
        result.errors = branch_errors(*paths.coarse, result.branch, paths.safety);
    result.errors.states.resize(result.branch.states.size());
    if (paths.series > 0)
        add_in_series(paths.series, result.branch.states, result.errors);
    return result;
}

/// The branch of the opposite torques, as far as the run is not stopped before: solved, or the mirror image of
/// @p forth.
/// @param space_angle  of LoadMap
BranchWithErrors opposite_branch(contact::ContactContext const& context, PathPair const& paths,
                                 BranchWithErrors const& forth, std::vector<double> const& space_angle,
                                 std::function<bool()> const& stop, std::function<void(double)> const& on_state)
{
    if (!is_mirror_image(context)) {
        BranchTorques opposite{.given = {}, .stop = stop};
        for (LoadedState const& state : forth.branch.states)
            if (state.torque != 0)
                opposite.given.push_back(-state.torque);
        try {
            return opposite.given.empty() ? BranchWithErrors() : solved_branch(paths, opposite, on_state);
        } catch (NumericalError const& error) {
            if (error.code() != ErrorCode::stopped)
                throw;
            return {};
        }
    }
    double const period = 2 * std::numbers::pi / paths.fine.problem.drive.response.sectors();
    BranchWithErrors back;
    for (std::size_t i = 0; i < forth.branch.states.size(); ++i)
        if (forth.branch.states[i].torque != 0) {
            back.branch.states.push_back(mirror_image(forth.branch.states[i], space_angle, period));
            back.errors.states.push_back(forth.errors.states[i]);
        }
    for (UnsettledTorque const& each : forth.branch.unsettled)
        back.branch.unsettled.push_back({-each.torque, each.cause});
    for (LoadedState const& state : forth.errors.coarse)
        back.errors.coarse.push_back(mirror_image(state, space_angle, period));
    return back;
}

/// Enters both branches, in order of growing torque.
void enter_curve(BranchWithErrors const& forth, BranchWithErrors const& back, LoadCase& result)
{
    auto const append = [](auto& all, auto const& more) { all.insert(all.end(), more.begin(), more.end()); };
    result.curve.assign(back.branch.states.rbegin(), back.branch.states.rend());
    result.curve_error.assign(back.errors.states.rbegin(), back.errors.states.rend());
    append(result.curve, forth.branch.states);
    append(result.curve_error, forth.errors.states);
    result.rated = result.curve.size() - 1;
    if (result.curve.back().torque < 0) {
        std::ranges::reverse(result.curve);
        std::ranges::reverse(result.curve_error);
        result.rated = 0;
    }
    result.unsettled = forth.branch.unsettled;
    append(result.unsettled, back.branch.unsettled);
}

/// Enters all torques and what follows from them. @returns the branch of the rated torque
BranchWithErrors solve_curve(contact::ContactContext const& context, PathPair const& paths, LoadingPath const& torques,
                             CaseObserver const& observer, LoadCase& result)
{
    bool const twice = torques.curve && !is_mirror_image(context);
    auto const told = [&](double from) {
        return [&observer, twice, from](double done) {
            if (observer.on_state)
                observer.on_state(twice ? from + done / 2 : done);
        };
    };
    BranchWithErrors forth = solved_branch(paths, torques.forth, told(0));
    result.map = load_map(paths.fine.problem, forth.branch.last);
    result.contacts = contact_forces(paths.fine.problem, forth.branch.last);
    result.bearing = forth.branch.bearing.back();
    if (!torques.curve) {
        enter_curve(forth, {}, result);
        return forth;
    }
    BranchWithErrors const back =
        opposite_branch(context, paths, forth, result.map.angle, torques.forth.stop, told(0.5));
    enter_curve(forth, back, result);
    double const rated = forth.branch.states.back().torque;
    CurveBranches const fine{forth.branch.states, back.branch.states, free_twist(paths.fine, rated)};
    std::optional<CurveBranches> coarse;
    if (paths.coarse && forth.errors.states.back())
        coarse.emplace(CurveBranches{forth.errors.coarse, back.errors.coarse, free_twist(*paths.coarse, rated)});
    result.stages = stages_of(fine, coarse ? &*coarse : nullptr, paths.safety);
    LoadedState const& state = forth.branch.states.back();
    double const relative_twist = coarse ? forth.errors.states.back()->twist / std::abs(state.twist) : 0;
    if (rated == torques.forth.given.back())
        result.catalogue = catalogue_figures(catalogue_torques(context.scene, rated), fine, coarse ? &*coarse : nullptr,
                                             paths.safety, relative_twist);
    return forth;
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
        stress_error(stress.peak.stress, other.peak.stress, stress.at_corners, grid_safety(model.drive.slice_z.size()));
    result.curve_error[result.rated]->largest_stress = result.error.largest_stress;
}

}  // namespace

SolvedCase load_case(contact::ContactContext const& context, DrivePair const& drives,
                     surface::SurfaceSpec const& choice, LoadingPath const& torques, CaseObserver const& observer)
{
    auto const begin = std::chrono::steady_clock::now();
    AssembledDrive const& fine = drives.fine;
    SurfaceWithPlay const assembled = surface_with_play(context, fine, choice);
    contact::FlankGrid const& flanks = assembled.surface.grid;
    LoadCase result = assembled_case(context, choice, assembled);
    if (observer.on_play)
        observer.on_play(result);
    LoadProblem const problem = load_problem(context, fine.model.drive, flanks);
    TorqueContinuation const path = torque_continuation(problem, fine.unloaded, assembled.play);

    std::optional<contact::FlankGrid> coarse_flanks;
    std::optional<LoadProblem> coarse_problem;
    std::optional<TorqueContinuation> coarse;
    double const safety = grid_safety(flanks.slices());
    if (drives.coarse) {
        coarse_flanks = coarsened(flanks, drives.coarse->grid.slices);
        coarse_problem.emplace(load_problem(context, drives.coarse->model.drive, *coarse_flanks));
        if (std::optional<TorqueContinuation> found = coarse_path(*coarse_problem, drives.coarse->unloaded, path))
            coarse.emplace(std::move(*found));
    }
    if (coarse) {
        // Teeth that press on both flanks are a balance, whose error varies more than that of a gap.
        double const pressed = result.backlash < 0 ? 3 : 1;
        result.backlash_error = pressed * safety * std::abs(width_of(path.play) - width_of(coarse->play));
    }

    BranchWithErrors const rated = solve_curve(
        context, {path, coarse ? &*coarse : nullptr, safety, compliance_of(drives.series)}, torques, observer, result);
    LoadedState const& state = result.curve[result.rated];
    result.members = twist_members(state, free_twist(path, state.torque),
                                   cup_in_torsion(fine.model.drive, fine.model.radius), drives.series);
    std::vector<double> const& z = result.map.z;
    result.pressure_at_edge =
        z.size() > 1 && state.largest_pressure > 0 && (state.pressure_z <= z.front() || state.pressure_z >= z.back());
    if (!drives.coarse)
        result.curve_error.clear();
    result.estimated = drives.coarse && result.curve_error[result.rated];
    if (result.estimated)
        result.error = *result.curve_error[result.rated];
    elastic::HarmonicField field = cup_field(fine.model, rated.branch.last.forces, context.threads);
    enter_stress(context, drives, field, rated.errors.last_forces, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    LoadedTeeth teeth;
    if (!problem.deviation)
        teeth = loaded_teeth(context, fine.model.drive, rated.branch.last.shape, rated.branch.last.state.turn);
    return {std::move(result), std::move(field), std::move(teeth)};
}

}  // namespace hdconj::load
