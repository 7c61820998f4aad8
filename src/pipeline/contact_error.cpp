// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clearing_search.hpp"
#include "hdconj/numeric/least_between.hpp"

namespace hdconj::detail {
namespace {

/// The least of each plane. @p along: between the points too, which are even but for the last, the middle of the bottom.
/// @p known: what the points of the set have there, or null
std::vector<double> lowest_of(SliceTurns const& turns, ClearanceSet const& set, double distance, bool along, TurnMinima const* known = nullptr)
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
    return low;
}

double least_of(SliceTurns const& turns, ClearanceSet const& set, double distance, bool along)
{
    return least_between(lowest_of(turns, set, distance, along));
}

/// What each of the scene's slices leaves open to the least of its own plane, of planes that are all of the slices' or more of them.
std::vector<double> left_by_slices(std::vector<SliceClearance> const& slices, Closest SliceClearance::* place, std::vector<double> const& low, double enough)
{
    std::size_t const stride = slices.size() > 1 ? (low.size() - 1) / (slices.size() - 1) : 1;
    std::vector<double> left;
    for (std::size_t k = 0; k < slices.size(); ++k)
        left.push_back(std::max(0.0, (slices[k].*place).clearance - low[std::min(k * stride, low.size() - 1)]) + enough);
    return left;
}

double smallest(std::vector<SliceClearance> const& slices, Closest SliceClearance::* place)
{
    double least = std::numeric_limits<double>::infinity();
    for (SliceClearance const& slice : slices)
        least = std::min(least, (slice.*place).clearance);
    return least;
}

}  // namespace

ClearanceErrors clearance_errors(ContactBench const& bench, TurnWork const& work, double distance, std::vector<SliceClearance> const& slices)
{
    double const enough = clearing_accuracy(bench.tolerance);
    bool const both = !(bench.tooth.mirror_symmetric && work.turns.motion(0).symmetric());
    ClearanceSet const bottom = root_set(work.outline, bench.tolerance);
    std::vector<double> const flank = lowest_of(work.turns, flank_set(work.grid, both), distance, false, work.flank), root = lowest_of(work.turns, bottom, 0, true, work.root);
    return {std::max(0.0, smallest(slices, &SliceClearance::flank) - least_between(flank)) + enough,
            std::max(0.0, smallest(slices, &SliceClearance::root) - least_between(root)) + enough + bottom.known,
            left_by_slices(slices, &SliceClearance::flank, flank, enough), left_by_slices(slices, &SliceClearance::root, root, enough + bottom.known)};
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
