// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_tip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "hdconj/numeric/error.hpp"
#include "moved_outline.hpp"

namespace hdconj::detail {

double tip_with_land(ContactBench const& bench, SurfaceChoice const& choice, MatchedOutline const& outline, double distance, double tip)
{
    double const pitch = 2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth;
    double const least = least_land * bench.scene.drive.module;
    for (std::size_t k = 0; k < bench.maker.z().size(); ++k)
        if (double const meeting = meeting_radius(outline, k, distance, pitch); meeting > 0)
            tip = std::max(tip, meeting + least - bench.maker.z()[k] * std::tan(choice.tilt));
    return std::max(tip, bench.maker.solvable_tip(choice, distance));
}

void refuse_to_lift_for_ever(int round, double tip)
{
    constexpr int budget = 12;
    if (round + 1 == budget)
        throw NumericalError("contact", "tip circle",
                             "side clearance and tip circle did not settle at a tip circle of " + std::to_string(tip) + " mm: the teeth become too short for this tilt");
}

void reach(ContactBench const& bench, SurfaceChoice const& choice, Cleared& cleared, double distance)
{
    cleared.reach = distance;
    cleared.flanks = part_flanks(bench, bench.maker, choice, cleared.outline, cleared.tip, distance);
}

}  // namespace hdconj::detail
