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
        FlankGrid moved = moved_into_material(std::move(cleared.grid), offset);
        return {std::move(cleared.outline), std::move(moved), offset, cleared.tip};
    }
    double const tip = bench.maker.own_tip(choice);
    MatchedOutline outline = surface_of(bench, choice, tip);
    FlankGrid grid = moved_into_material(flank_grid(outline, bench.maker.z(), bench.request.flank_points), spline.backlash_offset);
    return {std::move(outline), std::move(grid), spline.backlash_offset, tip};
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
