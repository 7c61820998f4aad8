// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "catalogue_figures.hpp"
#include "hdconj/error.hpp"
#include "load/grids/branch_on_grids.hpp"
#include "load/grids/cup_error.hpp"
#include "load/grids/force_errors.hpp"
#include "load/grids/grid_error.hpp"
#include "load/model/cup_shape.hpp"
#include "load_problem.hpp"
#include "twist_members.hpp"

namespace hdconj::load {
namespace {

/// Whether the assembled teeth have a play on @p surface; not where it cannot be made.
template <class Surface>
bool can_be_assembled(contact::ContactContext const& context, AssembledDrive const& drive, Surface const& surface)
{
    try {
        contact::FlankSurface const made = surface();
        return play_of(load_problem(context, drive.model.drive, made.grid), drive.unloaded.shape).has_value();
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
        return false;
    }
}

/// A side clearance above @p tried with which the teeth can be assembled, as one would write it [mm].
std::optional<double> enough_clearance(contact::ContactContext const& context, AssembledDrive const& drive,
                                       surface::SurfaceSpec const& choice, double tried)
{
    double const module = context.scene.drive.module;
    constexpr double first = 0.01, largest = 0.32;  // steps, of the module
    double const digit = std::pow(10, std::floor(std::log10(module)) - 2);
    for (double step = first; step <= largest; step *= 2) {
        double const clearance = std::ceil((tried + step * module) / digit) * digit;
        if (can_be_assembled(context, drive,
                             [&] { return contact::surface_with_clearance(context, choice, clearance); }))
            return clearance;
    }
    return std::nullopt;
}

/// Refuses a surface whose teeth interfere at every turn. What is advised first was tried and helps. Single balls and
/// clearance in the bearing let the cup take another shape than the one that the teeth were made for: then another
/// surface seldom helps, and more side clearance does.
[[noreturn]] void refuse_assembly(contact::ContactContext const& context, AssembledDrive const& drive,
                                  surface::SurfaceSpec const& choice, contact::FlankSurface const& tried)
{
    Scene const& scene = context.scene;
    std::string advice;
    std::vector<std::string> set;
    surface::SurfaceSpec const per_slice{ToothSurface::per_slice, TiltKind::radial, 0};
    if (scene.coning && !scene.maps_axial_shift())
        advice = "axial_shift = \"mapped\" in [coning], since the cup's sections do not stay in their planes";
    else if (std::optional<double> const enough = enough_clearance(context, drive, choice, tried.offset)) {
        advice = "circular_spline.backlash_offset = " + short_number(*enough);
        set = {"circular_spline.backlash_offset=" + short_number(*enough)};
    }
    if (choice.surface != ToothSurface::per_slice && advice.empty() &&
        can_be_assembled(context, drive, [&] { return contact::flank_surface(context, per_slice); }))
        advice = "surface = \"per-slice\" in [slices]";
    if (advice.empty())
        advice = "a larger circular_spline.inner_radius than " + short_number(tried.tip) + " mm";
    throw NumericalError(ErrorCode::interference, "load", "assembly",
                         "cup and circular spline interfere in every position of the circular spline, even with a "
                         "side clearance of " +
                             short_number(tried.offset) + " mm",
                         "write " + advice, std::move(set));
}

}  // namespace

SurfaceWithPlay surface_with_play(contact::ContactContext const& context, AssembledDrive const& drive,
                                  surface::SurfaceSpec const& choice, bool error)
{
    bool const automatic = context.scene.circular_spline.automatic_backlash;
    LoadedShape const& shape = drive.unloaded.shape;
    auto const problem_of = [&](contact::FlankSurface const& surface) {
        return load_problem(context, drive.model.drive, surface.grid);
    };
    auto const tips_of = [&](contact::FlankSurface const& surface,
                             std::optional<Play> const& play) -> std::optional<TipInterference> {
        if (!play || !play->tips_interfere)
            return std::nullopt;
        double const overlap = tip_overlap(problem_of(surface), shape, middle_of(*play));
        return TipInterference{overlap, surface.tip + overlap};
    };
    SurfaceWithPlay result{.surface = contact::flank_surface(context, choice, false, automatic && error)};
    std::optional<Play> play = play_of(problem_of(result.surface), shape);
    if (!automatic && !(play && width_of(*play) >= 0)) {
        result.cleared = true;
        result.given_tips = tips_of(result.surface, play);
        contact::FlankSurface cleared = contact::flank_surface(context, choice, true, error);
        if (cleared.grid.point != result.surface.grid.point)  // the play of the same flanks is known
            play = play_of(problem_of(cleared), shape);
        result.surface = std::move(cleared);
    }
    if (!play)
        refuse_assembly(context, drive, choice, result.surface);
    result.play = *play;
    result.tips = tips_of(result.surface, play);
    return result;
}

namespace {

/// What is known of a case before any torque.
LoadCase assembled_case(contact::ContactContext const& context, surface::SurfaceSpec const& choice,
                        SurfaceWithPlay const& assembled)
{
    LoadCase result;
    result.surface = choice.surface;
    if (choice.tilt != 0 || context.scene.tilt)
        result.kind = choice.kind;
    result.tilt = choice.tilt;
    result.side_clearance_increased = contact::is_side_clearance_increased(context, assembled.surface.offset);
    result.backlash_offset = assembled.surface.offset;
    result.backlash_offset_error = assembled.surface.offset_error;
    result.tip = assembled.surface.tip;
    result.tip_radius_increase = contact::tip_radius_increase(context, assembled.surface.tip);
    result.cleared = assembled.cleared;
    result.given_tips = assembled.given_tips;
    result.tips = assembled.tips;
    result.backlash = width_of(assembled.play);
    return result;
}

/// Enters both branches, in order of growing torque.
void enter_curve(BranchWithErrors const& forth, BranchWithErrors const& back, LoadCase& result)
{
    auto const append = [](auto& all, auto const& more) { all.insert(all.end(), more.begin(), more.end()); };
    result.curve.assign(back.branch.states.rbegin(), back.branch.states.rend());
    result.curve_error.assign(back.errors.rbegin(), back.errors.rend());
    append(result.curve, forth.branch.states);
    append(result.curve_error, forth.errors);
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
BranchWithErrors solve_curve(contact::ContactContext const& context, PathsOnGrids const& paths,
                             LoadingPath const& torques, CaseObserver const& observer, LoadCase& result)
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
    std::vector<CurveBranches> coarser;
    for (std::size_t g = 0; g < forth.coarser.size() && forth.coarser[g].states.back(); ++g)
        coarser.push_back({forth.coarser[g].solved(),
                           g < back.coarser.size() ? back.coarser[g].solved() : std::vector<LoadedState>(),
                           free_twist(*paths.coarser[g]->path, rated)});
    double const safety = grid_safety(paths.fine.problem.flanks.slices());
    result.stages = stages_of(fine, coarser, safety);
    LoadedState const& state = forth.branch.states.back();
    double const of_teeth_and_cup = state.twist - paths.series * state.torque;
    double const relative_twist = coarser.empty() ? 0 : forth.errors.back()->twist / std::abs(of_teeth_and_cup);
    if (rated == torques.forth.given.back())
        result.catalogue = catalogue_figures(catalogue_torques(context.scene, rated), fine, coarser, safety,
                                             relative_twist, paths.series);
    return forth;
}

/// Enters the largest stress at the largest torque and its error, as far as @p coarser know their forces.
void enter_stress(contact::ContactContext const& context, DriveGrids const& drives, LoadedDrive const& loaded,
                  elastic::HarmonicField const& field, std::vector<CoarseBranch> const& coarser, LoadCase& result)
{
    LoadModel const& model = drives.fine.model;
    CupStress const stress = cup_stress(model, field, context.threads);
    LoadedState& state = result.curve[result.rated];
    state.largest_stress = stress.peak.stress;
    state.stress_r = stress.at.x();
    state.stress_z = stress.at.y() - model.middle;
    state.stress_phi = stress.peak.phi;
    if (!result.estimated)
        return;
    std::vector<double> others;
    for (std::size_t g = 0; g < coarser.size() && coarser[g].last; ++g) {
        LoadModel const& coarse = drives.coarser[g].model;
        elastic::HarmonicField const other = cup_field(coarse, coarser[g].last->forces, context.threads);
        others.push_back(cup_stress(coarse, other, context.threads).peak.stress);
    }
    Eigen::MatrixXd const spread = spread_over_slices(model.drive.stations, loaded.forces);
    double const of_slices =
        stress.peak.stress - cup_stress(model, cup_field(model, spread, context.threads), context.threads).peak.stress;
    result.error.largest_stress = stress_error(stress.peak.stress, others, stress.unresolved, std::abs(of_slices),
                                               grid_safety(model.drive.slice_z.size()));
    result.curve_error[result.rated]->largest_stress = result.error.largest_stress;
}

/// Adds what the error of the side clearance adds to others: every flank of the ring may be reached by @p turn later
/// [rad], under any torque. A slope between two torques does not change.
void add_clearance_error(double turn, LoadCase& result)
{
    result.backlash_error += 2 * turn;
    for (auto& error : result.curve_error)
        if (error)
            error->twist += turn;
    result.stages.knee_twist_error += turn;
    if (result.catalogue)
        result.catalogue->lost_motion_error += 2 * turn;
}

}  // namespace

SolvedCase load_case(contact::ContactContext const& context, DriveGrids const& drives,
                     surface::SurfaceSpec const& choice, LoadingPath const& torques, CaseObserver const& observer)
{
    auto const begin = std::chrono::steady_clock::now();
    AssembledDrive const& fine = drives.fine;
    SurfaceWithPlay const assembled = surface_with_play(context, fine, choice, !drives.coarser.empty());
    contact::FlankGrid const& flanks = assembled.surface.grid;
    LoadCase result = assembled_case(context, choice, assembled);
    if (observer.on_play)
        observer.on_play(result);
    LoadProblem const problem = load_problem(context, fine.model.drive, flanks);
    TorqueContinuation const path = torque_continuation(problem, fine.unloaded, assembled.play);

    std::vector<std::unique_ptr<CoarsePath>> const coarser = coarse_paths(context, drives, path);
    if (!coarser.empty()) {
        std::vector<double> widths;
        for (auto const& each : coarser)
            widths.push_back(width_of(each->path->play));
        result.backlash_error = backlash_error(result.backlash, widths, wall_difference(context, drives),
                                               context.geometry.r_m, grid_safety(flanks.slices()));
    }

    PathsOnGrids const paths{path, coarser, compliance_of(drives.series)};
    BranchWithErrors const rated = solve_curve(context, paths, torques, observer, result);
    add_clearance_error(turn_to_close(result.backlash_offset_error, context.geometry.r_m), result);
    LoadedState const& state = result.curve[result.rated];
    result.members = twist_members(state, free_twist(path, state.torque),
                                   cup_in_torsion(fine.model.drive, fine.model.radius), drives.series);
    std::vector<double> const& z = result.map.z;
    result.pressure_at_edge =
        z.size() > 1 && state.largest_pressure > 0 && (state.pressure_z <= z.front() || state.pressure_z >= z.back());
    if (drives.coarser.empty())
        result.curve_error.clear();
    result.estimated = !drives.coarser.empty() && result.curve_error[result.rated];
    if (result.estimated)
        result.error = *result.curve_error[result.rated];
    enter_force_errors(paths, drives, rated.coarser, result);
    elastic::HarmonicField field = cup_field(fine.model, rated.branch.last.forces, context.threads);
    enter_stress(context, drives, rated.branch.last, field, rated.coarser, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    LoadedTeeth teeth;
    if (!problem.deviation)
        teeth = loaded_teeth(context, fine.model.drive, rated.branch.last.shape, rated.branch.last.state.turn);
    return {std::move(result), std::move(field), std::move(teeth)};
}

}  // namespace hdconj::load
