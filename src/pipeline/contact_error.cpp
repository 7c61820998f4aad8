// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_error.hpp"

#include <algorithm>
#include <cmath>

#include "clearing_search.hpp"
#include "hdconj/numeric/least_between.hpp"

namespace hdconj::detail {
namespace {

/// The least of all planes and between them. @p along: between the points too, which are even but for the last, the middle of the bottom.
/// @p known: what the points of the set have there, or null
double least_of(SliceTurns const& turns, ClearanceSet const& set, double distance, bool along, TurnMinima const* known = nullptr)
{
    TurnMinima const found = known != nullptr ? TurnMinima{} : turns(set, distance);
    TurnMinima const& minima = known != nullptr ? *known : found;
    std::vector<double> low = turns.lowest(set, distance, minima);
    for (std::size_t k = 0; along && k < low.size(); ++k)
    {
        std::vector<double> points;
        for (std::size_t i = 0; i + 1 < minima[k].size(); ++i)
            points.push_back(minima[k][i].distance);
        low[k] = std::min(low[k], least_between(points));
    }
    return least_between(low);
}

}  // namespace

ClearanceErrors clearance_errors(ContactBench const& bench, TurnWork const& work, double distance, Closest const& flank, Closest const& root)
{
    double const enough = clearing_accuracy(bench.tolerance);
    bool const both = !(bench.tooth.mirror_symmetric && work.turns.motion(0).symmetric());
    ClearanceSet const bottom = root_set(work.outline, bench.tolerance);
    return {std::max(0.0, flank.clearance - least_of(work.turns, flank_set(work.grid, both), distance, false, work.flank)) + enough,
            std::max(0.0, root.clearance - least_of(work.turns, bottom, 0, true, work.root)) + enough + bottom.known};
}

double clearing_error(ContactBench const& bench, SliceTurns const& turns, ClearanceSet const& set, double found, bool along)
{
    double const enough = clearing_accuracy(bench.tolerance) + set.known;
    double const least = least_of(turns, set, found, along);
    double const enters = std::max(0.0, -least);
    // nothing was moved and nothing touches: the least is none
    if (found == 0 && least > enough)
        return enough;
    // what clears to `enough` is known to as much over the slope, wherever the search has ended
    double const step = std::max({enters, enough, bench.tolerance.length});
    double const slope = (least_of(turns, set, found + step, along) - least) / step;
    return (enters + enough) / std::clamp(slope, flattest_clearing, 1.0);
}

}  // namespace hdconj::detail
