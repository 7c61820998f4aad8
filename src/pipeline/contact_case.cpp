// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "clearing_search.hpp"
#include "hdconj/contact/contact_area.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/contact/take_up.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "place_teeth.hpp"
#include "slice_turns.hpp"
#include "solve_motion.hpp"

namespace hdconj::detail {
namespace {

bool is_symmetric(ContactBench const& bench)
{
    return bench.tooth.mirror_symmetric && bench.maker.motion(0).motion.symmetric();
}

double distance_to(std::vector<Vec2> const& line, Vec2 const& p)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
        Vec2 const along = line[i + 1] - line[i];
        double const length2 = along.squaredNorm();
        double const t = length2 > 0 ? std::clamp((p - line[i]).dot(along) / length2, 0.0, 1.0) : 0.0;
        best = std::min(best, (p - line[i] - t * along).squaredNorm());
    }
    return std::sqrt(best);
}

/// Largest distance of the ruled flanks from the conjugate outlines of the slices between the end planes.
double deviation(ContactBench const& bench, FlankGrid const& grid, double tip)
{
    MatchedOutline const own = bench.maker({"per-slice", "radial", 0}, tip, bench.tolerance.length, 0);
    std::vector<double> worst(grid.slices(), 0);
    parallel_for(grid.slices(), bench.threads, 1, [&](std::size_t k) {
        for (auto const& flank : grid.point)
            for (Vec2 const& p : flank[k])
                worst[k] = std::max(worst[k], distance_to(own.points[k], p));
    });
    return *std::max_element(worst.begin(), worst.end());
}

}  // namespace

ContactState contact_state(ContactBench const& bench, FlankGrid const& grid, double phase, GapMap* map)
{
    Scene const& scene = bench.scene;
    auto const places = bench.places(bench, phase);
    GapField const field(bench.tooth, grid, *places, scene.drive.flexspline_teeth, scene.drive.circular_spline_teeth, phase);
    GapMap rest;
    bench.clock.run(Stage::gap_map, [&] { rest = field.map(0, bench.threads); });
    ContactState state;
    state.wave_generator = phase == 0 ? 0.0 : -phase * tooth_ratio(scene);
    auto const smallest = std::min_element(rest.gap.begin(), rest.gap.end());
    auto const flat = static_cast<std::size_t>(smallest - rest.gap.begin());
    state.smallest_gap = *smallest;
    state.smallest_z = grid.z[flat / grid.points() % grid.slices()];
    state.smallest_space = static_cast<int>(flat / (2 * grid.slices() * grid.points())) - (scene.drive.circular_spline_teeth - 1) / 2;
    double const pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    bench.clock.run(Stage::contact, [&] {
        state.take_up = take_up(field, rest, GapMap::right, pitch, bench.threads).turn;
        state.take_up_back = take_up(field, rest, GapMap::left, pitch, bench.threads).turn;
        GapMap touching = field.map(state.take_up, bench.threads);
        double const limit = bench.request.gap;
        ContactArea const fine = contact_area(touching, grid, GapMap::right, limit, bench.width);
        ContactArea const coarse = contact_area(touching, grid, GapMap::right, limit, bench.width, 2);
        state.contact_area = fine.contact;
        state.flank_area = fine.whole;
        state.share = fine.share();
        state.share_error = std::abs(fine.share() - coarse.share());
        state.teeth = fine.spaces;
        if (map != nullptr)
            *map = std::move(touching);
    });
    return state;
}

namespace {

/// Offset that leaves no gap below zero where the map is looked at: beside the full turn, with the wall's axial shift. At least @p offset.
double raised_for_map(ContactBench const& bench, FlankGrid const& grid, double offset, std::vector<double> const& phases)
{
    if (!bench.scene.coning || bench.scene.coning->axial_shift != "mapped")
        return offset;
    auto const smallest_gap = [&](double distance) {
        FlankGrid const moved = moved_into_material(grid, distance);
        double smallest = std::numeric_limits<double>::infinity();
        for (double const phase : phases)
        {
            auto const places = bench.places(bench, phase);
            GapField const field(bench.tooth, moved, *places, bench.scene.drive.flexspline_teeth, bench.scene.drive.circular_spline_teeth, phase);
            GapMap const map = field.map(0, bench.threads);
            smallest = std::min(smallest, *std::min_element(map.gap.begin(), map.gap.end()));
        }
        return smallest;
    };
    double const enough = bench.tolerance.coincidence();
    if (smallest_gap(offset) >= -enough)
        return offset;
    auto const raised = clearing_search(smallest_gap, offset, enough);
    if (!raised)
        throw NumericalError("contact", "side clearance", "did not converge with the wall's axial shift; write axial_shift = \"none\" in [coning], or a larger "
                                                          "circular_spline.backlash_offset");
    return *raised;
}

/// A surface whose flanks clear: what side clearance and tip circle it takes.
struct Cleared
{
    MatchedOutline outline;   ///< with that tip circle, without the side clearance
    FlankGrid grid;
    double offset = 0;
    double tip = 0;
};

/// The surface with enough points for a map over its flanks.
MatchedOutline surface_of(ContactBench const& bench, SurfaceChoice const& choice, double tip)
{
    MatchedOutline outline;
    bool const draft = choice.kind == "draft" && choice.tilt != 0;
    SurfaceChoice const flat{choice.surface, "radial", 0};
    bench.clock.run(Stage::surface, [&] { outline = bench.maker(draft ? choice : flat, tip, bench.tolerance.length, bench.request.flank_points); });
    if (!draft && choice.tilt != 0)
        bench.clock.run(Stage::tilt, [&] { move_radially(outline, bench.maker.z(), choice.tilt); });
    return outline;
}

/// Side clearance moves the flanks of neighbouring spaces towards each other, so the tip circle may have to follow until a land is left; what then
/// is no flank any more needs no clearing. A larger tip circle never asks for more clearance: the loop ends.
Cleared clear_flanks(ContactBench const& bench, SliceTurns const& turns, SurfaceChoice const& choice, double at_least)
{
    double const pitch = 2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth;
    double const least = least_land * bench.scene.drive.module;
    Cleared result;
    result.tip = bench.maker.needed_tip(choice);
    constexpr int budget = 12;
    for (int i = 0; i < budget; ++i)
    {
        result.outline = surface_of(bench, choice, result.tip);
        result.grid = flank_grid(result.outline, bench.maker.z(), bench.request.flank_points);
        ClearanceSet const set = flank_set(result.grid, !is_symmetric(bench));
        bench.clock.run(Stage::clearance, [&] { result.offset = least_clearing(turns, set, turns(set, 0), bench.tolerance); });
        double tip = result.tip;
        for (std::size_t k = 0; k < result.grid.slices(); ++k)
        {
            double const meeting = meeting_radius(result.outline, k, std::max(result.offset, at_least), pitch);
            if (meeting > 0)
                tip = std::max(tip, meeting + least - bench.maker.z()[k] * std::tan(choice.tilt));
        }
        if (tip == result.tip)
            return result;
        result.tip = tip;
    }
    throw NumericalError("contact", "clearing offset", "side clearance and tip circle did not settle at a tip circle of " + std::to_string(result.tip)
                                                           + " mm: the teeth become too short for this tilt");
}

}  // namespace

FlankSurface flank_surface(ContactBench const& bench, SurfaceChoice const& choice, bool clearing)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    if (spline.automatic_backlash || clearing)
    {
        double const given = spline.automatic_backlash ? 0 : spline.backlash_offset;
        Cleared cleared = clear_flanks(bench, SliceTurns(bench), choice, given);
        double const offset = std::max(given, cleared.offset);
        FlankGrid moved = moved_into_material(std::move(cleared.grid), offset);
        return {std::move(cleared.outline), std::move(moved), offset, cleared.tip};
    }
    bool const follows = choice.surface != "tilted" || choice.kind == "draft";
    double const tip = follows ? bench.maker.needed_tip(choice) : bench.geometry.circular_spline_inner_radius;
    MatchedOutline outline = surface_of(bench, choice, tip);
    FlankGrid grid = moved_into_material(flank_grid(outline, bench.maker.z(), bench.request.flank_points), spline.backlash_offset);
    return {std::move(outline), std::move(grid), spline.backlash_offset, tip};
}

double clearing_offset_of(ContactBench const& bench, SurfaceChoice const& choice)
{
    return clear_flanks(bench, SliceTurns(bench), choice, 0).offset;
}

ContactCase clearing_case(ContactBench const& bench, SurfaceChoice const& choice)
{
    Cleared const cleared = clear_flanks(bench, SliceTurns(bench), choice, 0);
    ContactCase result;
    result.clearing_offset = cleared.offset;
    result.clearing_tip = cleared.tip;
    return result;
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
    Cleared const cleared = clear_flanks(bench, turns, choice, given);
    // clearances are those of the drive as the scene gives it, as far as its tip circle lets the surface exist
    bool const follows = choice.surface != "tilted" || choice.kind == "draft";
    double const own_tip = follows ? bench.maker.needed_tip(choice) : bench.geometry.circular_spline_inner_radius;
    MatchedOutline const outline = own_tip == cleared.tip ? cleared.outline : surface_of(bench, choice, own_tip);
    FlankGrid const own_grid = own_tip == cleared.tip ? cleared.grid : flank_grid(outline, bench.maker.z(), bench.request.flank_points);
    ClearanceSet const flanks = flank_set(own_grid, !is_symmetric(bench));
    ClearanceSet const root = root_set(outline);
    TurnMinima at_given, at_root;
    bench.clock.run(Stage::clearance, [&] {
        at_given = turns(flanks, given);
        at_root = turns(root, 0);
        result.clearing_root = least_clearing(turns, root, at_root, bench.tolerance);
    });
    for (std::size_t k = 0; k < own_grid.slices(); ++k)
    {
        std::vector<Vec2> moved = flanks.point[k];
        for (std::size_t i = 0; i < moved.size(); ++i)
            moved[i] += given * flanks.way[k][i];
        double const amplitude = bench.maker.motion(scene.coning ? k : 0).amplitude;
        result.slices.push_back({own_grid.z[k], amplitude, closest(at_given[k], moved, turns.motion(k)), closest(at_root[k], root.point[k], turns.motion(k))});
    }
    FlankGrid const& grid = cleared.grid;
    result.clearing_offset = cleared.offset;
    result.clearing_tip = cleared.tip;
    if (choice.surface == "ruled" && scene.coning && grid.slices() > 2)
        result.ruled_deviation = deviation(bench, grid, cleared.tip);

    std::vector<double> phases;
    double const pitch = 2 * std::numbers::pi / scene.drive.flexspline_teeth;
    double const own = phase_of(scene, bench.request.wave_generator);
    for (int i = 0; i < revolution; ++i)
        phases.push_back(own + pitch * i / revolution);
    if (phases.empty())
        phases.push_back(own);
    // teeth that enter the flanks cannot be turned to first contact: what is missing of the clearing offset is added, and the case says so
    bool const clears = given >= result.clearing_offset - bench.tolerance.coincidence();
    result.backlash_offset = clears ? given : result.clearing_offset;
    result.backlash_offset = raised_for_map(bench, grid, result.backlash_offset, phases);
    result.raised = !spline.automatic_backlash && result.backlash_offset > given;
    FlankGrid const used = moved_into_material(grid, result.backlash_offset);
    std::size_t least = 0;
    for (double const phase : phases)
    {
        GapMap gaps;
        ContactState const state = contact_state(bench, used, phase, map != nullptr ? &gaps : nullptr);
        result.revolution.push_back(state);
        if (state.share < result.revolution[least].share)
            least = result.revolution.size() - 1;
        if (map != nullptr && least == result.revolution.size() - 1)
            *map = std::move(gaps);
    }
    result.state = result.revolution[least];
    if (revolution == 0)
        result.revolution.clear();
    if (result.clearing_offset == result.backlash_offset)
        result.backlash_of_clearing = result.state.backlash();
    else
        result.backlash_of_clearing = contact_state(bench, moved_into_material(grid, result.clearing_offset), own, nullptr).backlash();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hdconj::detail
