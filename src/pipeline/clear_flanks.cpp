// SPDX-License-Identifier: GPL-3.0-or-later
#include "clear_flanks.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "clearing_search.hpp"
#include "contact_case.hpp"
#include "finer_surface.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/contact/smallest_gap.hpp"
#include "hdconj/numeric/error.hpp"
#include "place_teeth.hpp"

namespace hdconj::detail {

namespace {

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

void check_as_made(ContactBench const& bench, SurfaceChoice const& choice, Cleared const& cleared)
{
    double const own_tip = bench.maker.own_tip(choice);
    if (own_tip != cleared.tip)
        (void)surface_of(bench, choice, own_tip);
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
