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

#include "contact/clearance/case_errors.hpp"
#include "contact/clearance/clear_flanks.hpp"
#include "contact/clearance/made_flanks.hpp"
#include "contact/clearance/side_clearance_search.hpp"
#include "contact/clearance/slice_clearance.hpp"
#include "contact/parallel_trim.hpp"
#include "contact_state.hpp"
#include "hdconj/base/parallel.hpp"
#include "place_teeth.hpp"
#include "refined_flanks.hpp"

namespace hdconj::contact {
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

/// The part as the scene gives it, of which clearances are told, as far as its tip circle lets the surface exist.
Cleared given_part(CaseSurface const& surface, Cleared const& cleared)
{
    double const tip = surface.nominal_tip_radius();
    return tip == cleared.tip ? cleared : nominal_part(surface, given_clearance(surface.context().scene), tip);
}

/// The planes that closest_flank() may lie in.
void write_place(ContactCase& result)
{
    auto const& slices = result.slices;
    double const least = result.closest_flank().clearance;
    std::vector<double> z, excess;
    for (SliceClearance const& slice : slices) {
        z.push_back(slice.z);
        excess.push_back(slice.flank.clearance - least);
    }
    PlaceRange const range = place_range(z, excess, result.clearance_error);
    result.closest_z_from = range.from;
    result.closest_z_to = range.to;
}

/// A case with what it is of, and nothing that is computed.
ContactCase begin_case(CaseSurface const& surface)
{
    surface::SurfaceSpec const& spec = surface.spec();
    ContactCase result;
    result.surface = spec.surface;
    if (spec.tilt != 0 || surface.context().scene.tilt)
        result.kind = spec.kind;
    result.tilt = spec.tilt;
    return result;
}

/// Full turns of the given part against all teeth: clearances by slices, what clears, and the errors of all that.
/// @return the given part
MadePart write_clearances(CaseSurface const& surface, SliceClearances const& clearances, Cleared const& cleared,
                          bool errors, ContactCase& result)
{
    ContactContext const& context = surface.context();
    double const given = given_clearance(context.scene);
    MadePart nominal{given_part(surface, cleared), {}};
    Cleared const& part = nominal.part;
    FlankGrid const& grid = part.flanks.grid;
    ClearanceSet const flanks = flank_set(grid, !has_mirrored_flanks(context));
    ClearanceSet const root = root_set(part.outline, given, context.tolerance);
    TurnsOfSet at_root;
    context.clock.run(Stage::clearance, [&] {
        // a part that was cleared by nothing is known already
        bool const known = given == 0 && part.tip == cleared.tip && !cleared.at_zero.minima.empty();
        nominal.at_given = known ? cleared.at_zero : TurnsOfSet{clearances(flanks, given), {}};
        at_root.minima = clearances(root, 0);
        result.least_root_clearance = least_offset(clearances, root, at_root, context.tolerance);
        if (nominal.at_given.deepest.empty())
            nominal.at_given.deepest = clearances.lowest(flanks, given, nominal.at_given.minima);
        if (at_root.deepest.empty())
            at_root.deepest = clearances.lowest(root, 0, at_root.minima);
    });
    for (std::size_t k = 0; k < grid.slices(); ++k)
        result.slices.push_back({grid.z[k], context.maker.motion(context.scene.coning ? k : 0).amplitude,
                                 closest(clearances, k, nominal.at_given.deepest[k]),
                                 closest(clearances, k, at_root.deepest[k])});
    result.least_side_clearance = cleared.offset;
    result.least_tip_radius = cleared.tip;
    context.clock.run(Stage::clearance, [&] {
        write_errors(surface, clearances,
                     {cleared, part.outline, part.flanks, part.tip, given, nominal.at_given, at_root}, errors, result);
    });
    if (errors)
        write_place(result);
    return nominal;
}

/// Undeformed angles of tooth 0 at which contact is looked at: the scene's, or @p revolution of them over a pitch.
std::vector<double> phases_of(ContactContext const& context, int revolution)
{
    double const first = phase_of(context.scene, context.request.wave_generator);
    double const pitch = 2 * std::numbers::pi / context.scene.drive.flexspline_teeth;
    std::vector<double> phases{first};
    for (int i = 1; i < revolution; ++i)
        phases.push_back(first + pitch * i / revolution);
    return phases;
}

/// Contact at every phase; the state is that with the least share, whose gaps @p map gets.
void write_states(PhaseWork work, std::vector<double> const& phases, FlankGrid const& used,
                  std::shared_ptr<GapMap>* map, ContactCase& result)
{
    std::size_t least = 0;
    for (double const phase : phases) {
        std::shared_ptr<GapMap> gaps;
        work.phase = phase;
        ContactState const state = contact_state(work, used, map != nullptr ? &gaps : nullptr);
        result.revolution.push_back(state);
        if (state.contact_fraction < result.revolution[least].contact_fraction)
            least = result.revolution.size() - 1;
        if (map != nullptr && least == result.revolution.size() - 1)
            *map = std::move(gaps);
    }
    result.state = result.revolution[least];
}

/// Play that the side clearance @p clearing alone would make.
/// @param floor  no gap of a full turn is smaller [mm]
/// @param lever  see PhaseWork
void write_least_backlash(CaseSurface const& surface, Cleared const& cleared, double clearing, double floor,
                          double lever, bool errors, GapsAtRest& rest, ContactCase& result)
{
    ContactContext const& context = surface.context();
    FlankGrid const flanks = made_flanks(surface, cleared.flanks.grid, cleared.tip, clearing);
    RefinedFlanks finer(surface, cleared.flanks.grid, flanks, cleared.tip, clearing);
    PlayEstimate const found = play({context, finer, rest, phase_of(context.scene, context.request.wave_generator),
                                     result.least_side_clearance_error, floor, lever, errors},
                                    flanks);
    result.backlash_of_least_side_clearance = found.turn;
    result.backlash_of_least_side_clearance_error = found.error;
}

/// Contact of @p part after take-up, at all phases, and the play that clearing alone would make.
/// @param clearing  side clearance that clears the map too [mm]
void write_contact(CaseSurface const& surface, Cleared const& part, Cleared const& cleared, double clearing,
                   std::vector<double> const& phases, bool errors, GapsAtRest& rest, std::shared_ptr<GapMap>* map,
                   ContactCase& result)
{
    ContactContext const& context = surface.context();
    Scene const& scene = context.scene;
    bool const automatic = scene.circular_spline.automatic_backlash;
    double const given = given_clearance(scene);
    FlankGrid const& grid = part.flanks.grid;
    result.side_clearance_increased = !automatic && result.backlash_offset > given;
    FlankGrid const used = made_flanks(surface, grid, part.tip, result.backlash_offset);
    RefinedFlanks finer(surface, grid, used, part.tip, result.backlash_offset);
    // a side clearance that is given is what it is
    bool const as_given = result.backlash_offset == given && !automatic;
    double const chords = finer.solved_anew() && grid.slices() > 1 ? 2 * context.tolerance.length : 0;
    // a tip circle that was found bounds flanks that may touch there
    bool const tip_found = part.tip == cleared.tip && part.tip > surface.nominal_tip_radius();
    double const by_tip = tip_found ? std::max(0.0, result.least_tip_radius_error - context.tolerance.length) : 0;
    double const off = by_tip + (as_given ? chords + (chords > 0 ? overlap_at_ends(grid, given) : 0)
                                          : result.least_side_clearance_error);
    // full turns are those of the sections only where these have a series
    bool const turns_tell = !scene.maps_axial_shift() || grid.slices() == 1 || context.maker.follows_sections();
    constexpr double unknown = -std::numeric_limits<double>::infinity();
    double const floor_of_search = turns_tell ? -result.least_side_clearance_error : unknown;
    double const floor =
        turns_tell && as_given ? result.closest_flank().clearance - result.clearance_error : floor_of_search;
    double const lever = largest_lever(used);
    write_states({context, finer, rest, phases.front(), off, floor, lever, errors}, phases, used, map, result);
    if (clearing == result.backlash_offset && part.tip == cleared.tip) {
        result.backlash_of_least_side_clearance = result.state.backlash();
        result.backlash_of_least_side_clearance_error = result.state.backlash_error();
    } else
        write_least_backlash(surface, cleared, clearing, floor_of_search, lever, errors, rest, result);
}

/// The part that contact is computed with, and as its offset the side clearance: what the scene gives where that clears
/// over a full turn and at @p phase, else what does.
Cleared used_part(CaseSurface const& surface, SliceClearances const& clearances, GapsAtRest& rest, Cleared cleared,
                  double phase)
{
    ContactContext const& context = surface.context();
    std::optional<Cleared> nominal = try_nominal_part(surface, clearances, rest, cleared, {phase}, nullptr);
    double const offset = is_enough(context, cleared) ? given_clearance(context.scene) : cleared.offset;
    Cleared part = nominal ? std::move(*nominal) : std::move(cleared);
    part.offset = clearance_for_assembly(surface, rest, part, offset, {phase});
    return part;
}

}  // namespace

FlankSurface used_surface(ContactContext const& context, surface::SurfaceSpec const& spec)
{
    CaseSurface const surface(context, spec);
    SliceClearances const clearances(context);
    GapsAtRest rest;
    Cleared part =
        used_part(surface, clearances, rest, clear_flanks(surface, clearances, given_clearance(context.scene)),
                  phase_of(context.scene, context.request.wave_generator));
    FlankGrid grid = made_flanks(surface, part.flanks.grid, part.tip, part.offset);
    return {std::move(part.outline), std::move(grid), part.offset, part.tip};
}

double share_of(ContactContext const& context, surface::SurfaceSpec const& spec)
{
    CaseSurface const surface(context, spec);
    SliceClearances const clearances(context);
    Cleared cleared = clear_flanks(surface, clearances, given_clearance(context.scene));
    check_as_made(surface, cleared);
    double const phase = phase_of(context.scene, context.request.wave_generator);
    GapsAtRest rest;
    Cleared const part = used_part(surface, clearances, rest, std::move(cleared), phase);
    FlankGrid const used = made_flanks(surface, part.flanks.grid, part.tip, part.offset);
    RefinedFlanks finer(surface, part.flanks.grid, used, part.tip, part.offset);
    return contact_state({context, finer, rest, phase, 0, 0, 0, false}, used, nullptr).contact_fraction;
}

ContactCase contact_case(ContactContext const& context, surface::SurfaceSpec const& spec, int revolution, bool errors,
                         GapMap* map)
{
    auto const start = std::chrono::steady_clock::now();
    CaseSurface const surface(context, spec);
    ContactCase result = begin_case(surface);
    double const given = given_clearance(context.scene);
    SliceClearances const clearances(context);
    Cleared cleared = clear_flanks(surface, clearances, given);
    MadePart const made = write_clearances(surface, clearances, cleared, errors, result);
    std::vector<double> const phases = phases_of(context, revolution);
    // teeth that enter the flanks cannot be turned to first contact: what is missing of the clearing offset is added,
    // and the case says so
    GapsAtRest rest;
    std::optional<Cleared> nominal = try_nominal_part(surface, clearances, rest, cleared, phases, &made);
    Cleared& part = nominal ? *nominal : cleared;
    result.tip = part.tip;
    double const wanted = is_enough(context, cleared) ? given : result.least_side_clearance;
    result.backlash_offset = clearance_for_assembly(surface, rest, part, wanted, phases);
    // what clears the slices but not the sections there has no play: as much is added as there
    bool const known = !nominal && wanted == result.least_side_clearance && phases.size() == 1;
    double const clearing =
        known ? result.backlash_offset
              : clearance_for_assembly(surface, rest, cleared, result.least_side_clearance, {phases.front()});
    std::shared_ptr<GapMap> gaps;
    write_contact(surface, part, cleared, clearing, phases, errors, rest, map != nullptr ? &gaps : nullptr, result);
    rest.forget();
    if (map != nullptr)
        *map = std::move(*gaps);
    if (revolution == 0)
        result.revolution.clear();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hdconj::contact
