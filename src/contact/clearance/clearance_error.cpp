// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance_error.hpp"

#include <algorithm>
#include <cmath>

#include "contact/parallel_trim.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "numeric/least_between.hpp"
#include "side_clearance_search.hpp"

namespace hdconj::contact {

TurnsOfSet turns_of(SliceClearances const& clearances, ClearanceSet const& set, double distance,
                    TurnsOfSet const* known)
{
    if (known != nullptr)
        return *known;
    TurnsOfSet found;
    found.minima = clearances(set, distance);
    found.deepest = clearances.lowest(set, distance, found.minima);
    return found;
}

std::vector<double> lowest_of(TurnsOfSet const& turns, bool along)
{
    std::vector<double> low;
    for (Deepest const& deepest : turns.deepest)
        low.push_back(deepest.turn.distance);
    for (std::size_t k = 0; along && k < low.size(); ++k) {
        std::vector<double> points;
        for (std::size_t i = 0; i + 1 < turns.minima[k].size(); ++i)
            points.push_back(turns.minima[k][i].distance);
        low[k] = std::min(low[k], numeric::least_between(points));
    }
    return low;
}

double least_clearance_error(ContactContext const& context, SliceClearances const& clearances, ClearanceSet const& set,
                             double found, bool along, TurnsOfSet const& turns)
{
    double const enough = clearance_accuracy(context.tolerance) + set.known;
    double const least = numeric::least_between(lowest_of(turns, along));
    double const off = found > 0 ? std::abs(least) : std::max(0.0, -least);
    // nothing was moved and nothing touches: the least is none
    if (found == 0 && least > enough)
        return enough;
    // what clears to `enough` is known to as much over the slope, wherever the search has ended
    double const step = std::max({off, enough, context.tolerance.length});
    double const beyond = numeric::least_between(lowest_of(turns_of(clearances, set, found + step), along));
    double const slope = (beyond - least) / step;
    return (off + enough) / std::clamp(slope, flattest_slope, 1.0);
}

bool has_planes_solved_anew(CaseSurface const& surface, Cleared const& cleared)
{
    return surface.is_solved_per_plane() && cleared.flanks.grid.slices() > 1;
}

double chords_of(CaseSurface const& surface, Cleared const& cleared)
{
    return has_planes_solved_anew(surface, cleared) ? 2 * surface.context().tolerance.length : 0;
}

double found_clearance_error(CaseSurface const& surface, SliceClearances const& clearances, FlankGrid const& grid,
                             Cleared const& cleared, TurnsOfSet const* known)
{
    ContactContext const& context = surface.context();
    double const found = cleared.offset;
    ClearanceSet const flank = flank_set(grid, !has_mirrored_flanks(context));
    TurnsOfSet const turns = turns_of(clearances, flank, found, known);
    // a clearance falls no faster than the flank goes on
    return least_clearance_error(context, clearances, flank, found, false, turns) +
           unseen_length(cleared.flanks.grid, found) + chords_of(surface, cleared) +
           (has_planes_solved_anew(surface, cleared) ? overlap_at_ends(grid, found, lowest_of(turns, false)) : 0);
}

bool has_enough_planes(CaseSurface const& surface)
{
    return surface.is_alike() || surface.z().size() >= (surface.is_ruled() ? fewest_planes : fewest_turn_planes);
}

CaseSurface in_enough_planes(CaseSurface surface)
{
    while (!has_enough_planes(surface))
        surface = surface.refined();
    return surface;
}

double error_of_clearance(CaseSurface const& surface, SliceClearances const& clearances, Cleared const& cleared)
{
    if (!has_enough_planes(surface)) {
        try {
            CaseSurface const finer = in_enough_planes(surface);
            PartFlanks const flanks = part_flanks(finer, finer.outline(cleared.tip), cleared.tip, cleared.offset);
            return found_clearance_error(finer, SliceClearances(surface.context(), finer.builder()), flanks.grid,
                                         cleared, nullptr);
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();  // a plane between the slices cannot be made
        }
    }
    return found_clearance_error(surface, clearances, cleared.flanks.grid, cleared, nullptr);
}

}  // namespace hdconj::contact
