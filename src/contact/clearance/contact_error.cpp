// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clearing_search.hpp"
#include "numeric/least_between.hpp"

namespace hdconj::contact {
namespace {

/// The least of each plane. @p along: between the points too, which are even but for the last, the middle of the
/// bottom.
/// @p known: what the points of the set have there, or null
std::vector<double> lowest_of(SliceClearances const& clearances, ClearanceSet const& set, double distance, bool along,
                              TurnMinima const* known = nullptr)
{
    TurnMinima const found = known != nullptr ? TurnMinima{} : clearances(set, distance);
    TurnMinima const& minima = known != nullptr ? *known : found;
    std::vector<double> low = clearances.lowest(set, distance, minima);
    for (std::size_t k = 0; along && k < low.size(); ++k) {
        std::vector<double> points;
        for (std::size_t i = 0; i + 1 < minima[k].size(); ++i)
            points.push_back(minima[k][i].distance);
        low[k] = std::min(low[k], numeric::least_between(points));
    }
    return low;
}

double least_of(SliceClearances const& clearances, ClearanceSet const& set, double distance, bool along)
{
    return numeric::least_between(lowest_of(clearances, set, distance, along));
}

/// What each of the scene's slices leaves open to the least of its own plane, of planes that are all of the slices' or
/// more of them.
std::vector<double> left_by_slices(std::vector<SliceClearance> const& slices, Closest SliceClearance::*place,
                                   std::vector<double> const& low, double enough)
{
    std::size_t const stride = slices.size() > 1 ? (low.size() - 1) / (slices.size() - 1) : 1;
    std::vector<double> left;
    for (std::size_t k = 0; k < slices.size(); ++k)
        left.push_back(std::max(0.0, (slices[k].*place).clearance - low[std::min(k * stride, low.size() - 1)]) +
                       enough);
    return left;
}

double smallest(std::vector<SliceClearance> const& slices, Closest SliceClearance::*place)
{
    double least = std::numeric_limits<double>::infinity();
    for (SliceClearance const& slice : slices)
        least = std::min(least, (slice.*place).clearance);
    return least;
}

}  // namespace

ClearanceErrors clearance_errors(ContactContext const& context, TurnWork const& work, double distance,
                                 std::vector<SliceClearance> const& slices)
{
    double const enough = clearing_accuracy(context.tolerance);
    bool const both = !(context.tooth.mirror_symmetric && work.clearances.motion(0).symmetric());
    ClearanceSet const bottom = root_set(work.outline, context.tolerance);
    std::vector<double> const flank =
                                  lowest_of(work.clearances, flank_set(work.grid, both), distance, false, work.flank),
                              root = lowest_of(work.clearances, bottom, 0, true, work.root);
    return {
        std::max(0.0, smallest(slices, &SliceClearance::flank) - numeric::least_between(flank)) + enough,
        std::max(0.0, smallest(slices, &SliceClearance::root) - numeric::least_between(root)) + enough + bottom.known,
        left_by_slices(slices, &SliceClearance::flank, flank, enough),
        left_by_slices(slices, &SliceClearance::root, root, enough + bottom.known)};
}

double clearing_error(ContactContext const& context, SliceClearances const& clearances, ClearanceSet const& set,
                      double found, bool along)
{
    double const enough = clearing_accuracy(context.tolerance) + set.known;
    double const least = least_of(clearances, set, found, along);
    double const enters = std::max(0.0, -least);
    // nothing was moved and nothing touches: the least is none
    if (found == 0 && least > enough)
        return enough;
    // what clears to `enough` is known to as much over the slope, wherever the search has ended
    double const step = std::max({enters, enough, context.tolerance.length});
    double const slope = (least_of(clearances, set, found + step, along) - least) / step;
    return (enters + enough) / std::clamp(slope, flattest_clearing, 1.0);
}

}  // namespace hdconj::contact
