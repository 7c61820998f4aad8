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
#include "contact_error.hpp"
#include "hdconj/axial/slice_places.hpp"
#include "hdconj/contact/contact_area.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/contact/open_gaps.hpp"
#include "hdconj/contact/resolved_area.hpp"
#include "hdconj/contact/smallest_gap.hpp"
#include "hdconj/contact/take_up.hpp"
#include "hdconj/numeric/least_between.hpp"
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

/// Largest distance of the ruled flanks from the conjugate outlines of the planes of @p maker, one by one.
std::vector<double> deviations(ContactBench const& bench, SurfaceMaker& maker, FlankGrid const& grid, double tip)
{
    MatchedOutline const own = maker({"per-slice", "radial", 0}, tip, bench.tolerance.length, 0);
    std::vector<double> worst(grid.slices(), 0);
    parallel_for(grid.slices(), bench.threads, 1, [&](std::size_t k) {
        for (auto const& flank : grid.point)
            for (Vec2 const& p : flank[k])
                worst[k] = std::max(worst[k], distance_to(own.points[k], p));
    });
    return worst;
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
    /// @param bare  without side clearance
    /// @param grid  with the side clearance @p offset; both outlive this
    FinerSurface(ContactBench const& bench, SurfaceChoice const& choice, FlankGrid const& bare, FlankGrid const& grid, double tip, double offset)
        : bench_(bench), choice_(choice), bare_(bare), grid_(grid), tip_(tip), offset_(offset)
    {
    }

    /// How many intervals to make of one between slices where @p spaces of all are looked at: as many as keep the work below that of a map.
    [[nodiscard]] int parts(std::size_t spaces) const
    {
        bool const alike = !bench_.scene.coning && choice_.tilt == 0;
        if (grid_.slices() < 2 || alike)
            return 1;
        // a few planes in all would say little about what lies between them
        int parts = 2;
        while ((grid_.slices() - 1) * static_cast<std::size_t>(parts) + 1 < fewest_planes)
            parts *= 2;
        // a plane between two needs a conjugate outline, or many sections of the elastic cup
        if (solved_anew() || bench_.cup != nullptr)
            return parts;
        constexpr int most = 16;
        constexpr std::size_t most_planes = 256;
        auto const all = static_cast<std::size_t>(bench_.scene.drive.circular_spline_teeth);
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

    /// Whether planes between slices have outlines of their own.
    [[nodiscard]] bool solved_anew() const { return choice_.surface == "per-slice" && bench_.scene.coning; }

  private:
    [[nodiscard]] FlankGrid made(int parts) const
    {
        if (solved_anew())
        {
            SurfaceMaker* finer = &bench_.maker;
            for (int i = 1; i < parts; i *= 2)
                finer = &finer->refined();
            SurfaceMaker& maker = *finer;
            return moved_into_material(flank_grid(surface_of(bench_, maker, choice_, tip_), maker.z(), bench_.request.flank_points), offset_);
        }
        // straight between slices: one outline moved along its radii or its normals, or the lines that a ruled surface is made of; the normals turn, along
        // which the side clearance is laid
        FlankGrid finer = bare_;
        int const slices = static_cast<int>(bare_.slices());
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
            fill(bare_.point[flank], finer.point[flank], false);
            fill(bare_.normal[flank], finer.normal[flank], true);
            fill(bare_.line[flank], finer.line[flank], false);
            fill(bare_.line_normal[flank], finer.line_normal[flank], true);
        }
        return moved_into_material(std::move(finer), offset_);
    }

    ContactBench const& bench_;
    SurfaceChoice choice_;
    FlankGrid const& bare_;
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
    GapMap rest;            ///< before
    SmallestGap smallest;   ///< before
    double take_up = 0, take_up_back = 0;
};

Turned turned(ContactBench const& bench, GapField const& field)
{
    Turned result;
    bench.clock.run(Stage::gap_map, [&] { result.rest = field.map(0, bench.threads); });
    double const pitch = 2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth;
    bench.clock.run(Stage::contact, [&] {
        double const touches = clearing_accuracy(bench.tolerance);
        TakeUp const right = take_up(field, result.rest, GapMap::right, pitch, bench.threads, touches);
        TakeUp const left = take_up(field, result.rest, GapMap::left, pitch, bench.threads, touches);
        result.smallest = left.at_rest.gap < right.at_rest.gap ? left.at_rest : right.at_rest;
        result.take_up = right.turn;
        result.take_up_back = left.turn;
    });
    return result;
}

/// Everything at one phase.
struct PhaseWork
{
    ContactBench const& bench;
    FinerSurface& finer;
    double phase;
    double off;    ///< how far the side clearance may be from the least that clears [mm]
    double clear;  ///< no gap of a full turn is smaller with these flanks [mm]
    double lever;  ///< no gap changes faster with the turn [mm/rad]
    bool errors = true;   ///< estimated too

    /// No gap at @p turn is smaller [mm].
    [[nodiscard]] double floor(double turn) const { return clear - lever * std::abs(turn); }
};

/// The gaps of some spaces at one turn, and what their planes leave open of them.
///
/// Surfaces that are straight between slices have gaps that are smooth in z, whose curvature the planes tell: OpenGap::least. Planes that are solved anew have gaps that begin and end at
/// zero, with bends there: for those, what the second half of the planes has found within the limit of contact is taken twice again where that is less. And no gap is smaller than a full turn
/// has shown.
class OpenGaps
{
  public:
    /// @param level  gaps up to this count [mm]
    /// @param floor  known to be no more than any gap [mm]
    OpenGaps(std::vector<OpenGap> open, bool anew, double level, double floor) : open_(std::move(open))
    {
        double more = 0, parabolas = std::numeric_limits<double>::infinity();
        for (OpenGap const& each : open_)
        {
            lowest_ = std::min(lowest_, each.lowest);
            parabolas = std::min(parabolas, each.least);
            more = std::max(more, std::min(each.second, level) - std::min(each.lowest, level));
            missed_ = anew ? std::max(missed_, each.missed) : missed_ + each.missed;
        }
        least_ = std::min(lowest_, std::max({parabolas, anew ? lowest_ - 2 * more : parabolas, floor}));
        for (OpenGap const& each : open_)
            if (each.lowest <= level)
                lever_ = std::min(lever_, each.lever);
    }

    /// Estimated: no gap is smaller [mm].
    [[nodiscard]] double least() const { return least_; }
    /// How much enters, estimated [mm].
    [[nodiscard]] double enters() const { return std::max(0.0, -least_); }
    /// How far a turn to first contact here may be from the true one, with gaps known to @p off [rad].
    [[nodiscard]] double turn_error(double off) const { return open_.empty() ? 0 : (enters() + off) / lever_; }
    /// Area of contact that no plane may have met: the patches of all spaces together, or where bends are taken for them the largest [mm^2].
    [[nodiscard]] double missed() const { return missed_; }
    [[nodiscard]] std::vector<OpenGap> const& spaces() const { return open_; }

  private:
    std::vector<OpenGap> open_;
    double lowest_ = std::numeric_limits<double>::infinity(), least_ = lowest_, lever_ = lowest_;
    double missed_ = 0;
};

/// Play with some flanks at one phase, and its error.
struct Play
{
    double turn = 0, error = 0;
};

/// Play with the flanks @p grid; of @p work the finer surface is that of these flanks.
Play play(PhaseWork const& work, FlankGrid const& grid)
{
    ContactBench const& bench = work.bench;
    int const z_f = bench.scene.drive.flexspline_teeth, z_c = bench.scene.drive.circular_spline_teeth;
    auto const places = bench.places(bench, work.phase);
    GapField const field(bench.tooth, grid, *places, z_f, z_c, work.phase);
    Turned const free = turned(bench, field);
    Play result{free.take_up + free.take_up_back, 0};
    bench.clock.run(Stage::contact, [&] {
        double const limit = bench.request.gap, off = clearing_accuracy(bench.tolerance) + work.off;
        for (int const flank : {static_cast<int>(GapMap::right), static_cast<int>(GapMap::left)})
        {
            double const turn = flank == GapMap::right ? free.take_up : -free.take_up_back;
            std::vector<std::size_t> const near_by = spaces_near(field.map(turn, bench.threads), flank, limit + 0.5 * field.spacing());
            int const parts = work.finer.parts(near_by.size());
            FlankGrid const& fine = work.finer(parts);
            auto const fine_places = parts == 1 ? places : bench.places(bench, work.phase, fine.z);
            GapField const fine_field(bench.tooth, fine, *fine_places, z_f, z_c, work.phase);
            result.error += OpenGaps(open_gaps(fine_field, near_by, flank, turn, limit, bench.threads), work.finer.solved_anew(), limit, work.floor(turn)).turn_error(off);
        }
    });
    return result;
}

/// Contact of @p grid; of @p work the finer surface is the same. @p map, where given, gets the gaps after take-up.
ContactState contact_state(PhaseWork const& work, FlankGrid const& grid, GapMap* map)
{
    ContactBench const& bench = work.bench;
    double const phase = work.phase;
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
        GapMap touching = state.take_up == 0 ? free.rest : field.map(state.take_up, bench.threads);
        double const limit = bench.request.gap;
        double const few = limit + 0.5 * field.spacing();
        std::vector<std::size_t> const near_by = spaces_near(touching, GapMap::right, few);
        int const parts = work.finer.parts(near_by.size());
        FlankGrid const& fine = work.finer(parts);
        auto const fine_places = parts == 1 ? places : bench.places(bench, phase, fine.z);
        GapField const fine_field(bench.tooth, fine, *fine_places, z_f, z_c, phase);
        ResolvedArea const found = resolved_area(fine_field, near_by, state.take_up, GapMap::right, limit, bench.width, bench.threads);
        state.contact_area = found.area.contact;
        state.flank_area = found.area.whole;
        state.share = found.area.share();
        state.teeth = found.area.spaces;
        if (!work.errors)
            return;

        // what the planes leave open of all that was found in them
        double const off = clearing_accuracy(bench.tolerance) + work.off;
        auto const look = [&](int flank, double turn, std::vector<std::size_t> const& spaces, double level) {
            return OpenGaps(open_gaps(fine_field, spaces, flank, turn, limit, bench.threads), work.finer.solved_anew(), level + limit, work.floor(turn));
        };
        GapMap const other = state.take_up_back == 0 ? GapMap{} : field.map(-state.take_up_back, bench.threads);
        OpenGaps const right = look(GapMap::right, state.take_up, near_by, 0);
        OpenGaps const left = look(GapMap::left, -state.take_up_back, spaces_near(state.take_up_back == 0 ? free.rest : other, GapMap::left, few), 0);
        state.take_up_error = right.turn_error(off);
        state.take_up_back_error = left.turn_error(off);
        double least = std::numeric_limits<double>::infinity();
        for (int const flank : {static_cast<int>(GapMap::right), static_cast<int>(GapMap::left)})
        {
            bool const known = (flank == GapMap::right ? state.take_up : state.take_up_back) == 0;
            double const level = std::max(0.0, state.smallest_gap);
            least = std::min(least, known ? (flank == GapMap::right ? right : left).least() : look(flank, 0, spaces_near(free.rest, flank, few + level), level).least());
        }
        state.smallest_gap_error = std::max(0.0, state.smallest_gap - least) + off;

        // a flexspline that is turned too far, or a clearance that is wrong, lifts or lowers all gaps by no more than this
        double const lift = off + right.enters();
        double const more = contact_area(touching, grid, GapMap::right, limit + lift, bench.width).share();
        double const less = contact_area(touching, grid, GapMap::right, limit - lift, bench.width).share();
        for (OpenGap const& each : right.spaces())
        {
            state.teeth_least += each.lowest <= limit - lift ? 1 : 0;
            state.teeth_most += std::min(each.least, each.lowest) <= limit + lift ? 1 : 0;
        }
        // where gaps bend, a patch may also be between two points and two planes
        double const cell = work.finer.solved_anew() && fine.slices() > 1 ? field.spacing() * (fine.z[1] - fine.z[0]) : 0;
        state.share_error = found.along + found.across + (more - less) + (state.flank_area > 0 ? (right.missed() + cell) / state.flank_area : 0);
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

/// The surface as made and cleared, of which errors are asked.
struct Surfaces
{
    Cleared const& cleared;
    MatchedOutline const& outline;   ///< as made
    FlankGrid const& grid;
    double tip;     ///< as made
    double given;   ///< side clearance of the scene
    TurnMinima const& flank;   ///< of the flanks as made and that side clearance
    TurnMinima const& root;    ///< around the bottom
};

/// Errors of all that is told of full turns, and how far a ruled surface deviates, into @p result, which holds the rest.
void write_errors(ContactBench const& bench, SurfaceChoice const& choice, SliceTurns const& turns, Surfaces const& made, ContactCase& result)
{
    auto const closest_root = std::min_element(result.slices.begin(), result.slices.end(), [](SliceClearance const& a, SliceClearance const& b) { return a.root.clearance < b.root.clearance; });
    bool const both = !is_symmetric(bench);
    auto const write = [&](TurnWork const& as_made, SurfaceMaker& maker, FlankGrid const& cleared) {
        ClearanceErrors const errors = clearance_errors(bench, as_made, made.given, result.closest_flank(), closest_root->root);
        // planes between slices that are solved anew have their own chords, and were made to clear a tooth by points
        double const chords = choice.surface == "per-slice" && bench.scene.coning && made.grid.slices() > 1 ? 2 * bench.tolerance.length : 0;
        result.clearance_error = errors.flank + chords;
        result.root_clearance_error = errors.root;
        result.clearing_offset_error = clearing_error(bench, as_made.turns, flank_set(cleared, both), result.clearing_offset, false) + chords;
        result.clearing_root_error = clearing_error(bench, as_made.turns, root_set(as_made.outline, bench.tolerance), result.clearing_root, true);
        if (choice.surface != "ruled" || !bench.scene.coning || made.grid.slices() < 2)
            return;
        // told in the slices of the scene, of which these are all or every so many
        std::vector<double> low = deviations(bench, maker, cleared, made.cleared.tip);
        for (std::size_t k = 0; k < low.size(); k += (low.size() - 1) / (made.grid.slices() - 1))
            result.ruled_deviation = std::max(result.ruled_deviation, low[k]);
        for (double& each : low)
            each = -each;
        // the distance is pointed where it is largest; an outline is known to its chords
        result.ruled_deviation_error = -least_between(low, pointed_function) - result.ruled_deviation + bench.tolerance.length;
    };
    std::size_t const slices = made.grid.slices();
    bool const alike = slices == 1 || (!bench.scene.coning && choice.tilt == 0);
    std::size_t const fewest = choice.surface == "ruled" ? fewest_planes : fewest_turn_planes;
    if (alike || slices >= fewest)
    {
        write({turns, made.outline, made.grid, &made.flank, &made.root}, bench.maker, made.cleared.grid);
    }
    else
    {
        SurfaceMaker* maker = &bench.maker;
        while (maker->z().size() < fewest)
            maker = &maker->refined();
        SliceTurns const finer_turns(bench, *maker);
        auto const surface = [&](double tip) { return surface_of(bench, *maker, choice, tip); };
        MatchedOutline const outline = surface(made.tip);
        FlankGrid const grid = flank_grid(outline, maker->z(), bench.request.flank_points);
        FlankGrid const cleared = made.cleared.tip == made.tip ? grid : flank_grid(surface(made.cleared.tip), maker->z(), bench.request.flank_points);
        write({finer_turns, outline, grid}, *maker, cleared);
    }
    // where flanks that are moved meet decides the tip circle, it follows
    double const pitch = 2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth;
    double const offset = std::max(result.clearing_offset, made.given) + result.clearing_offset_error;
    result.clearing_tip_error = bench.tolerance.length;
    for (std::size_t k = 0; k < slices; ++k)
        if (double const meeting = meeting_radius(made.cleared.outline, k, offset, pitch); meeting > 0)
            result.clearing_tip_error = std::max(result.clearing_tip_error,
                                                 meeting + least_land * bench.scene.drive.module - bench.maker.z()[k] * std::tan(choice.tilt) - made.cleared.tip);
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

double share_of(ContactBench const& bench, SurfaceChoice const& choice)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    double const given = spline.automatic_backlash ? 0 : spline.backlash_offset;
    Cleared const cleared = clear_flanks(bench, SliceTurns(bench), choice, given);
    double const phase = phase_of(bench.scene, bench.request.wave_generator);
    bool const clears = given >= cleared.offset - clearing_accuracy(bench.tolerance);
    double const offset = raised_for_map(bench, cleared.grid, clears ? given : cleared.offset, {phase});
    FlankGrid const used = moved_into_material(cleared.grid, offset);
    FinerSurface finer(bench, choice, cleared.grid, used, cleared.tip, offset);
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
    Cleared const cleared = clear_flanks(bench, turns, choice, given);
    // clearances are those of the drive as the scene gives it, as far as its tip circle lets the surface exist
    double const own_tip = bench.maker.own_tip(choice);
    MatchedOutline const outline = own_tip == cleared.tip ? cleared.outline : surface_of(bench, choice, own_tip);
    FlankGrid const own_grid = own_tip == cleared.tip ? cleared.grid : flank_grid(outline, bench.maker.z(), bench.request.flank_points);
    ClearanceSet const flanks = flank_set(own_grid, !is_symmetric(bench));
    ClearanceSet const root = root_set(outline, bench.tolerance);
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
    bench.clock.run(Stage::clearance, [&] { write_errors(bench, choice, turns, {cleared, outline, own_grid, own_tip, given, at_given, at_root}, result); });

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
    FinerSurface finer(bench, choice, grid, used, cleared.tip, result.backlash_offset);
    // a side clearance that is given is what it is
    bool const as_given = result.backlash_offset == given && !spline.automatic_backlash;
    double const chords = finer.solved_anew() && grid.slices() > 1 ? 2 * bench.tolerance.length : 0;
    double const off = as_given ? chords : result.clearing_offset_error;
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
    // what clears the slices but not the sections there has no play: as much is added as there
    double const clearing = raised_for_map(bench, grid, result.clearing_offset, {own});
    if (clearing == result.backlash_offset)
    {
        result.backlash_of_clearing = result.state.backlash();
        result.backlash_of_clearing_error = result.state.backlash_error();
    }
    else
    {
        FlankGrid const cleared_flanks = moved_into_material(grid, clearing);
        FinerSurface cleared_finer(bench, choice, grid, cleared_flanks, cleared.tip, clearing);
        Play const play_of_clearing = play({bench, cleared_finer, own, result.clearing_offset_error, turns_tell ? -result.clearing_offset_error : unknown, lever}, cleared_flanks);
        result.backlash_of_clearing = play_of_clearing.turn;
        result.backlash_of_clearing_error = play_of_clearing.error;
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hdconj::detail
