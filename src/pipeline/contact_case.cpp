// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "case_errors.hpp"
#include "clear_flanks.hpp"
#include "clearing_search.hpp"
#include "contact_state.hpp"
#include "finer_surface.hpp"
#include "hdconj/contact/parallel_trim.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "part_as_given.hpp"
#include "place_range.hpp"
#include "place_teeth.hpp"
#include "slice_turns.hpp"

namespace hdconj::detail {
namespace {

/// The largest distance of a flank's normal from the axis: of contacts on it none opens or closes faster with the turn.
double largest_lever(FlankGrid const& grid)
{
    double largest = 0;
    for (std::size_t flank = 0; flank < 2; ++flank)
        for (std::size_t k = 0; k < grid.slices(); ++k)
            for (std::size_t i = 0; i < grid.points(); ++i)
                largest = std::max(largest, std::abs(cross(grid.point[flank][k][i], grid.normal[flank][k][i])));
    return largest;
}

/// The part as the scene gives it. Clearances are told of it, as far as its tip circle lets the surface exist.
Cleared made_part(ContactBench const& bench, SurfaceChoice const& choice, Cleared const& cleared)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    double const own_tip = bench.maker.own_tip(choice);
    return own_tip == cleared.tip ? cleared : part_as_given(bench, choice, spline.automatic_backlash ? 0 : spline.backlash_offset, own_tip);
}

/// The planes that closest_flank() may lie in.
void write_place(ContactCase& result)
{
    auto const& slices = result.slices;
    double const least = result.closest_flank().clearance;
    std::vector<double> z, excess;
    for (SliceClearance const& slice : slices)
    {
        z.push_back(slice.z);
        excess.push_back(slice.flank.clearance - least);
    }
    PlaceRange const range = place_range(z, excess, result.clearance_error);
    result.closest_z_from = range.from;
    result.closest_z_to = range.to;
}

}  // namespace

double share_of(ContactBench const& bench, SurfaceChoice const& choice, bool as_made)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    double const given = spline.automatic_backlash ? 0 : spline.backlash_offset;
    SliceTurns const turns(bench);
    Cleared cleared = clear_flanks(bench, turns, choice, given);
    if (as_made)
        check_as_made(bench, choice, cleared);
    double const phase = phase_of(bench.scene, bench.request.wave_generator);
    std::optional<Cleared> kept = kept_as_given(bench, turns, choice, cleared, {phase}, nullptr);
    Cleared& part = kept ? *kept : cleared;
    double const offset = raised_for_map(bench, choice, part, is_enough(bench, cleared) ? given : cleared.offset, {phase});
    FlankGrid const used = moved_into_material(part.flanks.grid, offset);
    FinerSurface finer(bench, choice, part.flanks.grid, used, part.tip, offset);
    return contact_state({bench, finer, phase, 0, 0, 0, false}, used, nullptr).share;
}

ContactCase contact_case(ContactBench const& bench, SurfaceChoice const& choice, int revolution, GapMap* map)
{
    auto const start = std::chrono::steady_clock::now();
    Scene const& scene = bench.scene;
    CircularSpline const& spline = scene.circular_spline;
    ContactCase result;
    result.surface = choice.surface;
    result.kind = choice.tilt != 0 || scene.tilt ? choice.kind : "";
    result.tilt = choice.tilt;
    double const given = spline.automatic_backlash ? 0 : spline.backlash_offset;

    SliceTurns const turns(bench);
    Cleared cleared = clear_flanks(bench, turns, choice, given);
    MadePart known{made_part(bench, choice, cleared), {}};
    Cleared const& made = known.part;
    TurnMinima& at_given = known.at_given;
    FlankGrid const& own_grid = made.flanks.grid;
    ClearanceSet const flanks = flank_set(own_grid, !is_symmetric(bench));
    ClearanceSet const root = root_set(made.outline, bench.tolerance);
    TurnMinima at_root;
    bench.clock.run(Stage::clearance, [&] {
        at_given = turns(flanks, given);
        at_root = turns(root, 0);
        result.clearing_root = least_clearing(turns, root, at_root, bench.tolerance);
    });
    for (std::size_t k = 0; k < own_grid.slices(); ++k)
        result.slices.push_back({own_grid.z[k], bench.maker.motion(scene.coning ? k : 0).amplitude, {}, {}});
    parallel_for(own_grid.slices(), bench.threads, 1, [&](std::size_t k) {
        result.slices[k].flank = closest(turns, flanks, k, given, at_given[k]);
        result.slices[k].root = closest(turns, root, k, 0, at_root[k]);
    });
    result.clearing_offset = cleared.offset;
    result.clearing_tip = cleared.tip;
    bench.clock.run(Stage::clearance, [&] { write_errors(bench, choice, turns, {cleared, made.outline, made.flanks, made.tip, given, at_given, at_root}, result); });

    write_place(result);
    std::vector<double> phases;
    double const pitch = 2 * std::numbers::pi / scene.drive.flexspline_teeth;
    double const own = phase_of(scene, bench.request.wave_generator);
    for (int i = 0; i < revolution; ++i)
        phases.push_back(own + pitch * i / revolution);
    if (phases.empty())
        phases.push_back(own);
    // teeth that enter the flanks cannot be turned to first contact: what is missing of the clearing offset is added, and the case says so
    std::optional<Cleared> kept = kept_as_given(bench, turns, choice, cleared, phases, &known);
    Cleared& part = kept ? *kept : cleared;
    result.tip = part.tip;
    result.backlash_offset = raised_for_map(bench, choice, part, is_enough(bench, cleared) ? given : result.clearing_offset, phases);
    // what clears the slices but not the sections there has no play: as much is added as there
    double const clearing = raised_for_map(bench, choice, cleared, result.clearing_offset, {own});
    FlankGrid const& grid = part.flanks.grid;
    result.raised = !spline.automatic_backlash && result.backlash_offset > given;
    FlankGrid const used = moved_into_material(grid, result.backlash_offset);
    FinerSurface finer(bench, choice, grid, used, part.tip, result.backlash_offset);
    // a side clearance that is given is what it is
    bool const as_given = result.backlash_offset == given && !spline.automatic_backlash;
    double const chords = finer.solved_anew() && grid.slices() > 1 ? 2 * bench.tolerance.length : 0;
    double const off = as_given ? chords + (chords > 0 ? overlap_at_ends(grid, given) : 0) : result.clearing_offset_error;
    // full turns are those of the sections only where these have a series
    bool const turns_tell = !scene.coning || scene.coning->axial_shift != "mapped" || grid.slices() == 1 || bench.maker.follows_sections();
    constexpr double unknown = -std::numeric_limits<double>::infinity();
    double const clear = !turns_tell ? unknown : as_given ? result.closest_flank().clearance - result.clearance_error : -result.clearing_offset_error;
    double const lever = largest_lever(used);
    std::size_t least = 0;
    for (double const phase : phases)
    {
        GapMap gaps;
        ContactState const state = contact_state({bench, finer, phase, off, clear, lever}, used, map != nullptr ? &gaps : nullptr);
        result.revolution.push_back(state);
        if (state.share < result.revolution[least].share)
            least = result.revolution.size() - 1;
        if (map != nullptr && least == result.revolution.size() - 1)
            *map = std::move(gaps);
    }
    result.state = result.revolution[least];
    if (revolution == 0)
        result.revolution.clear();
    if (clearing == result.backlash_offset && part.tip == cleared.tip)
    {
        result.backlash_of_clearing = result.state.backlash();
        result.backlash_of_clearing_error = result.state.backlash_error();
    }
    else
    {
        FlankGrid const cleared_flanks = moved_into_material(cleared.flanks.grid, clearing);
        FinerSurface cleared_finer(bench, choice, cleared.flanks.grid, cleared_flanks, cleared.tip, clearing);
        Play const play_of_clearing = play({bench, cleared_finer, own, result.clearing_offset_error, turns_tell ? -result.clearing_offset_error : unknown, lever}, cleared_flanks);
        result.backlash_of_clearing = play_of_clearing.turn;
        result.backlash_of_clearing_error = play_of_clearing.error;
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hdconj::detail
