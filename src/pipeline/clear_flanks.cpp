// SPDX-License-Identifier: GPL-3.0-or-later
#include "clear_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "clearing_search.hpp"
#include "contact_case.hpp"
#include "finer_surface.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/contact/smallest_gap.hpp"
#include "hdconj/numeric/error.hpp"
#include "moved_outline.hpp"
#include "place_teeth.hpp"

namespace hdconj::detail {

namespace {

/// The tip circle of z = 0 that leaves every slice of @p outline a land when its flanks are moved by @p distance; at least @p tip.
double tip_with_land(ContactBench const& bench, SurfaceChoice const& choice, MatchedOutline const& outline, double distance, double tip)
{
    double const pitch = 2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth;
    double const least = least_land * bench.scene.drive.module;
    for (std::size_t k = 0; k < bench.maker.z().size(); ++k)
        if (double const meeting = meeting_radius(outline, k, distance, pitch); meeting > 0)
            tip = std::max(tip, meeting + least - bench.maker.z()[k] * std::tan(choice.tilt));
    return tip;
}

/// To be called before the tip circle is lifted once more.
void refuse_to_lift_for_ever(int round, double tip)
{
    constexpr int budget = 12;
    if (round + 1 == budget)
        throw NumericalError("contact", "tip circle",
                             "side clearance and tip circle did not settle at a tip circle of " + std::to_string(tip) + " mm: the teeth become too short for this tilt");
}

/// Has the flanks reach the tip circle when they are moved by @p distance.
void reach(ContactBench const& bench, SurfaceChoice const& choice, Cleared& cleared, double distance)
{
    cleared.reach = distance;
    cleared.flanks = part_flanks(bench, bench.maker, choice, cleared.outline, cleared.tip, distance);
}

/// Lifts the tip circle to where the flanks begin when they are moved by the offset with which they clear.
void lift_tip(ContactBench const& bench, SliceTurns const& turns, SurfaceChoice const& choice, Cleared& cleared)
{
    constexpr double more = 1.25;
    constexpr int budget = 8;
    cleared.tip += lift_of_corners(cleared.flanks.grid, cleared.offset);
    cleared.outline = surface_of(bench, choice, cleared.tip);
    double further = std::max(cleared.reach, cleared.offset);
    for (int i = 0; i < budget; ++i)
    {
        reach(bench, choice, cleared, further);
        bench.clock.run(Stage::clearance, [&] {
            ClearanceSet const set = flank_set(cleared.flanks.grid, !is_symmetric(bench));
            // the same flanks as before, a little less of them in slices whose corners rise less
            if (turns.worst(set, cleared.offset, turns(set, cleared.offset)) < -clearing_accuracy(bench.tolerance))
                cleared.offset = least_clearing(turns, set, turns(set, 0), bench.tolerance);
        });
        if (cleared.offset <= cleared.reach)
            return;
        further = more * cleared.offset;
    }
    throw NumericalError("contact", "clearing offset", "what is left of the flanks at the tip circle asks for ever more side clearance");
}

}  // namespace

double raised_for_map(ContactBench const& bench, SurfaceChoice const& choice, Cleared& cleared, double offset, std::vector<double> const& phases)
{
    if (!bench.scene.coning || bench.scene.coning->axial_shift != "mapped")
        return offset;
    auto const smallest_at = [&](double distance) {
        if (distance > cleared.reach)
            reach(bench, choice, cleared, distance);
        FlankGrid const moved = moved_into_material(cleared.flanks.grid, distance);
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

Cleared clear_flanks(ContactBench const& bench, SliceTurns const& turns, SurfaceChoice const& choice, double at_least)
{
    Cleared result;
    result.reach = at_least;
    result.tip = bench.maker.needed_tip(choice);
    // where moved flanks meet the tip circle has to follow until a land is left
    auto const raise_tip = [&](MatchedOutline const& outline, double distance) {
        double const tip = tip_with_land(bench, choice, outline, distance, result.tip);
        return std::exchange(result.tip, tip) != tip;
    };
    for (int i = 0;; ++i)
    {
        result.outline = surface_of(bench, choice, result.tip);
        result.flanks = part_flanks(bench, bench.maker, choice, result.outline, result.tip, 0);
        bench.clock.run(Stage::clearance, [&] {
            ClearanceSet const set = flank_set(result.flanks.grid, !is_symmetric(bench));
            result.offset = least_clearing(turns, set, turns(set, 0), bench.tolerance);
        });
        if (!raise_tip(result.outline, std::max(result.offset, at_least)))
            break;
        refuse_to_lift_for_ever(i, result.tip);
    }
    if (result.offset > 0)
        lift_tip(bench, turns, choice, result);
    else if (result.reach > 0)
        reach(bench, choice, result, result.reach);
    // a given clearance has more of the surface reach the tip circle, whose land may be narrower there
    for (int i = 0; raise_tip(result.flanks.outline, std::max(result.offset, at_least)); ++i)
    {
        refuse_to_lift_for_ever(i, result.tip);
        result.outline = surface_of(bench, choice, result.tip);
        reach(bench, choice, result, result.reach);
    }
    return result;
}

Cleared part_as_given(ContactBench const& bench, SurfaceChoice const& choice, double given, double tip)
{
    Cleared result;
    result.offset = given;
    result.tip = tip;
    for (int i = 0;; ++i)
    {
        result.outline = surface_of(bench, choice, result.tip);
        reach(bench, choice, result, given);
        double const with_land = given > 0 ? tip_with_land(bench, choice, result.flanks.outline, given, result.tip) : result.tip;
        if (with_land == result.tip)
            return result;
        refuse_to_lift_for_ever(i, result.tip);
        result.tip = with_land;
    }
}

bool is_enough(ContactBench const& bench, Cleared const& cleared)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    return (spline.automatic_backlash ? 0 : spline.backlash_offset) >= cleared.offset - clearing_accuracy(bench.tolerance);
}

std::optional<Cleared> kept_as_given(ContactBench const& bench, SliceTurns const& turns, SurfaceChoice const& choice, Cleared const& cleared, std::vector<double> const& phases,
                                     MadePart const* made)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    double const given = spline.backlash_offset;
    // with a smaller tip circle there is more to clear, not less
    if (spline.automatic_backlash || !is_enough(bench, cleared))
        return std::nullopt;
    double const own = bench.maker.own_tip(choice), needed = bench.maker.needed_tip(choice);
    if (std::max(own, needed) >= cleared.tip)
        return std::nullopt;
    try
    {
        bool const known = made != nullptr && own >= needed;
        Cleared part = known ? made->part : part_as_given(bench, choice, given, std::max(own, needed));
        if (part.tip >= cleared.tip)
            return std::nullopt;
        ClearanceSet const set = flank_set(part.flanks.grid, !is_symmetric(bench));
        TurnMinima minima;
        if (!known)
            bench.clock.run(Stage::clearance, [&] { minima = turns(set, given); });
        bool const clears = turns.worst(set, given, known ? made->at_given : minima) >= -clearing_accuracy(bench.tolerance);
        return clears && raised_for_map(bench, choice, part, given, phases) == given ? std::optional(std::move(part)) : std::nullopt;
    }
    catch (NumericalError const&)
    {
        return std::nullopt;  // a part that cannot be made is not kept
    }
}

void check_as_made(ContactBench const& bench, SurfaceChoice const& choice, Cleared const& cleared)
{
    double const own_tip = bench.maker.own_tip(choice);
    if (own_tip != cleared.tip)
        (void)surface_of(bench, choice, own_tip);
}

FlankSurface flank_surface(ContactBench const& bench, SurfaceChoice const& choice, bool clearing)
{
    CircularSpline const& spline = bench.scene.circular_spline;
    if (spline.automatic_backlash || clearing)
    {
        double const given = spline.automatic_backlash ? 0 : spline.backlash_offset;
        Cleared cleared = clear_flanks(bench, SliceTurns(bench), choice, given);
        double const offset = std::max(given, cleared.offset);
        FlankGrid moved = moved_into_material(std::move(cleared.flanks.grid), offset);
        return {std::move(cleared.outline), std::move(moved), offset, cleared.tip};
    }
    double const own = bench.maker.own_tip(choice);
    Cleared made = part_as_given(bench, choice, spline.backlash_offset, std::max(own, bench.maker.needed_tip(choice)));
    FlankGrid grid = moved_into_material(std::move(made.flanks.grid), made.offset);
    return {std::move(made.outline), std::move(grid), made.offset, made.tip};
}

double clearing_offset_of(ContactBench const& bench, SurfaceChoice const& choice, bool as_made)
{
    Cleared const cleared = clear_flanks(bench, SliceTurns(bench), choice, 0);
    if (as_made)
        check_as_made(bench, choice, cleared);
    return cleared.offset;
}

ContactCase clearing_case(ContactBench const& bench, SurfaceChoice const& choice)
{
    Cleared const cleared = clear_flanks(bench, SliceTurns(bench), choice, 0);
    ContactCase result;
    result.clearing_offset = cleared.offset;
    result.clearing_tip = cleared.tip;
    return result;
}

}  // namespace hdconj::detail
