// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "clearing_search.hpp"
#include "hdconj/axial/slice_places.hpp"
#include "hdconj/contact/contact_area.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/contact/resolved_area.hpp"
#include "hdconj/contact/smallest_gap.hpp"
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

/// The surface with enough points for a map over its flanks, in the slices of @p maker.
MatchedOutline surface_of(ContactBench const& bench, SurfaceMaker& maker, SurfaceChoice const& choice, double tip)
{
    MatchedOutline outline;
    bool const draft = choice.kind == "draft" && choice.tilt != 0;
    SurfaceChoice const flat{choice.surface, "radial", 0};
    bench.clock.run(Stage::surface, [&] { outline = maker(draft ? choice : flat, tip, bench.tolerance.length, bench.request.flank_points); });
    if (!draft && choice.tilt != 0)
        bench.clock.run(Stage::tilt, [&] { move_radially(outline, maker.z(), choice.tilt); });
    return outline;
}

MatchedOutline surface_of(ContactBench const& bench, SurfaceChoice const& choice, double tip)
{
    return surface_of(bench, bench.maker, choice, tip);
}

/// A cleared surface between its slices: for an area integral that slices of a scene's number are too few for.
class FinerSurface
{
  public:
    /// @param grid  with the side clearance @p offset; both outlive this
    FinerSurface(ContactBench const& bench, SurfaceChoice const& choice, FlankGrid const& grid, double tip, double offset)
        : bench_(bench), choice_(choice), grid_(grid), tip_(tip), offset_(offset)
    {
    }

    /// How many intervals to make of one between slices where @p spaces of all are looked at: as many as keep the work below that of a map.
    [[nodiscard]] int parts(std::size_t spaces) const
    {
        bool const alike = !bench_.scene.coning && choice_.tilt == 0;
        if (grid_.slices() < 2 || alike)
            return 1;
        // a plane between two needs a conjugate outline, or many sections of the elastic cup; three planes would say nothing about their own error
        if (solved_anew() || bench_.cup != nullptr)
            return grid_.slices() == 2 ? 4 : 2;
        constexpr int most = 16;
        constexpr std::size_t most_planes = 256;
        auto const all = static_cast<std::size_t>(bench_.scene.drive.circular_spline_teeth);
        int parts = 2;
        while (parts < most && static_cast<std::size_t>(parts) * spaces <= all && 2 * static_cast<std::size_t>(parts) * grid_.slices() <= most_planes)
            parts *= 2;
        return parts;
    }

    /// The flanks in planes between the slices too, @p parts to each interval.
    [[nodiscard]] FlankGrid const& operator()(int parts)
    {
        if (parts == 1)
            return grid_;
        auto const known = known_.find(parts);
        return known != known_.end() ? known->second : known_.emplace(parts, made(parts)).first->second;
    }

  private:
    [[nodiscard]] bool solved_anew() const { return choice_.surface == "per-slice" && bench_.scene.coning; }

    [[nodiscard]] FlankGrid made(int parts) const
    {
        if (solved_anew())
        {
            SurfaceMaker& maker = parts == 2 ? bench_.maker.refined() : bench_.maker.refined().refined();
            return moved_into_material(flank_grid(surface_of(bench_, maker, choice_, tip_), maker.z(), bench_.request.flank_points), offset_);
        }
        // straight between slices: one outline moved along its radii or its normals, or the lines that a ruled surface is made of
        FlankGrid finer = grid_;
        int const slices = static_cast<int>(grid_.slices());
        finer.z = slice_places((slices - 1) * parts + 1, bench_.width);
        auto const fill = [&](std::vector<std::vector<Vec2>> const& given, std::vector<std::vector<Vec2>>& filled, bool unit) {
            filled.clear();
            for (std::size_t k = 0; k < finer.z.size() && !given.empty(); ++k)
            {
                std::size_t const low = std::min(k / static_cast<std::size_t>(parts), given.size() - 2);
                double const share = static_cast<double>(k - low * static_cast<std::size_t>(parts)) / parts;
                filled.push_back(share == 0 ? given[low] : given[low + 1]);
                for (std::size_t i = 0; i < given[low].size() && share != 0 && share != 1; ++i)
                {
                    Vec2 const p = (1 - share) * given[low][i] + share * given[low + 1][i];
                    filled.back()[i] = unit ? p.normalized() : p;
                }
            }
        };
        for (std::size_t flank = 0; flank < 2; ++flank)
        {
            fill(grid_.point[flank], finer.point[flank], false);
            fill(grid_.normal[flank], finer.normal[flank], true);
            fill(grid_.line[flank], finer.line[flank], false);
            fill(grid_.line_normal[flank], finer.line_normal[flank], true);
        }
        return finer;
    }

    ContactBench const& bench_;
    SurfaceChoice choice_;
    FlankGrid const& grid_;
    double tip_;
    double offset_;
    std::map<int, FlankGrid> known_;
};

/// Spaces in which the gap of @p flank may be within @p limit between the points and slices of @p map: where it is twice that, and one space on.
std::vector<std::size_t> spaces_near(GapMap const& map, int flank, double limit)
{
    constexpr double few = 2;
    constexpr std::size_t on = 1;
    std::size_t const spaces = map.angle.size();
    std::vector<std::uint8_t> wanted(spaces, 0);
    for (std::size_t s = 0; s < spaces; ++s)
    {
        auto const first = map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(s, flank, 0, 0));
        if (*std::min_element(first, first + static_cast<std::ptrdiff_t>(map.z.size() * map.station.size())) > few * limit)
            continue;
        for (std::size_t i = 0; i <= 2 * on; ++i)
            wanted[(s + spaces + i - on) % spaces] = 1;
    }
    std::vector<std::size_t> found;
    for (std::size_t s = 0; s < spaces; ++s)
        if (wanted[s] != 0)
            found.push_back(s);
    return found;
}

/// The flexspline turned both ways until it touches.
struct Turned
{
    SmallestGap smallest;   ///< before
    double take_up = 0, take_up_back = 0;
};

Turned turned(ContactBench const& bench, GapField const& field)
{
    GapMap rest;
    bench.clock.run(Stage::gap_map, [&] { rest = field.map(0, bench.threads); });
    double const pitch = 2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth;
    Turned result;
    bench.clock.run(Stage::contact, [&] {
        double const touches = clearing_accuracy(bench.tolerance);
        TakeUp const right = take_up(field, rest, GapMap::right, pitch, bench.threads, touches);
        TakeUp const left = take_up(field, rest, GapMap::left, pitch, bench.threads, touches);
        result = {left.at_rest.gap < right.at_rest.gap ? left.at_rest : right.at_rest, right.turn, left.turn};
    });
    return result;
}

/// Play with the flanks @p grid at one phase.
double play(ContactBench const& bench, FlankGrid const& grid, double phase)
{
    auto const places = bench.places(bench, phase);
    GapField const field(bench.tooth, grid, *places, bench.scene.drive.flexspline_teeth, bench.scene.drive.circular_spline_teeth, phase);
    Turned const result = turned(bench, field);
    return result.take_up + result.take_up_back;
}

/// Contact of @p grid at one phase; @p finer is the same surface. @p map, where given, gets the gaps after take-up.
ContactState contact_state(ContactBench const& bench, FlankGrid const& grid, FinerSurface& finer, double phase, GapMap* map)
{
    Scene const& scene = bench.scene;
    int const z_f = scene.drive.flexspline_teeth, z_c = scene.drive.circular_spline_teeth;
    auto const places = bench.places(bench, phase);
    GapField const field(bench.tooth, grid, *places, z_f, z_c, phase);
    Turned const free = turned(bench, field);
    ContactState state;
    state.wave_generator = phase == 0 ? 0.0 : -phase * tooth_ratio(scene);
    state.take_up = free.take_up;
    state.take_up_back = free.take_up_back;
    state.smallest_gap = free.smallest.gap;
    state.smallest_z = grid.z[free.smallest.where.slice];
    state.smallest_space = static_cast<int>(free.smallest.where.space) - (z_c - 1) / 2;
    bench.clock.run(Stage::contact, [&] {
        GapMap touching = field.map(state.take_up, bench.threads);
        double const limit = bench.request.gap;
        std::vector<std::size_t> const near_by = spaces_near(touching, GapMap::right, limit + 0.5 * field.spacing());
        int const parts = finer.parts(near_by.size());
        FlankGrid const& fine = finer(parts);
        auto const fine_places = parts == 1 ? places : bench.places(bench, phase, fine.z);
        GapField const fine_field(bench.tooth, fine, *fine_places, z_f, z_c, phase);
        ResolvedArea const found = resolved_area(fine_field, near_by, state.take_up, GapMap::right, limit, bench.width, bench.threads);
        state.contact_area = found.area.contact;
        state.flank_area = found.area.whole;
        state.share = found.area.share();
        state.teeth = found.area.spaces;
        // a clearance that is wrong by this much lifts or lowers all gaps by it; between the slices teeth may enter by as much as was met there
        double const off = clearing_accuracy(bench.tolerance) + std::max(0.0, -found.lowest);
        double const more = contact_area(touching, grid, GapMap::right, limit + off, bench.width).share();
        double const less = contact_area(touching, grid, GapMap::right, limit - off, bench.width).share();
        state.share_error = found.along + found.across + (more - less);
        if (map != nullptr)
            *map = std::move(touching);
    });
    return state;
}

/// Offset that leaves no gap below zero where the map is looked at: beside the full turn, with the wall's axial shift. At least @p offset.
double raised_for_map(ContactBench const& bench, FlankGrid const& grid, double offset, std::vector<double> const& phases)
{
    if (!bench.scene.coning || bench.scene.coning->axial_shift != "mapped")
        return offset;
    auto const smallest_at = [&](double distance) {
        FlankGrid const moved = moved_into_material(grid, distance);
        double smallest = std::numeric_limits<double>::infinity();
        for (double const phase : phases)
        {
            auto const places = bench.places(bench, phase);
            GapField const field(bench.tooth, moved, *places, bench.scene.drive.flexspline_teeth, bench.scene.drive.circular_spline_teeth, phase);
            smallest = std::min(smallest, smallest_gap(field, field.map(0, bench.threads), 0, -1, bench.threads).gap);
        }
        return smallest;
    };
    double const enough = clearing_accuracy(bench.tolerance);
    if (smallest_at(offset) >= -enough)
        return offset;
    auto const raised = clearing_search(smallest_at, offset, enough);
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
    double const tip = bench.maker.own_tip(choice);
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
    double const own_tip = bench.maker.own_tip(choice);
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
        double const amplitude = bench.maker.motion(scene.coning ? k : 0).amplitude;
        result.slices.push_back({own_grid.z[k], amplitude, closest(turns, flanks, k, given, at_given[k]), closest(turns, root, k, 0, at_root[k])});
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
    bool const clears = given >= result.clearing_offset - clearing_accuracy(bench.tolerance);
    result.backlash_offset = clears ? given : result.clearing_offset;
    result.backlash_offset = raised_for_map(bench, grid, result.backlash_offset, phases);
    result.raised = !spline.automatic_backlash && result.backlash_offset > given;
    FlankGrid const used = moved_into_material(grid, result.backlash_offset);
    FinerSurface finer(bench, choice, used, cleared.tip, result.backlash_offset);
    std::size_t least = 0;
    for (double const phase : phases)
    {
        GapMap gaps;
        ContactState const state = contact_state(bench, used, finer, phase, map != nullptr ? &gaps : nullptr);
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
        result.backlash_of_clearing = play(bench, moved_into_material(grid, result.clearing_offset), own);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hdconj::detail
