// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_as_given.hpp"

#include <algorithm>
#include <utility>

#include "clear_flanks.hpp"
#include "clearing_search.hpp"
#include "contact_case.hpp"
#include "finer_surface.hpp"
#include "hdconj/numeric/error.hpp"

namespace hdconj::detail {

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

}  // namespace hdconj::detail
