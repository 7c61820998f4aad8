// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_tip.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string>

#include "hdconj/error.hpp"
#include "surface/moved_outline.hpp"

namespace hdconj::contact {

double tip_with_land(CaseSurface const& surface, conjugate::MatchedOutline const& outline, double distance, double tip)
{
    Drive const& drive = surface.context().scene.drive;
    double const pitch = 2 * std::numbers::pi / drive.circular_spline_teeth;
    double const least = surface::least_land * drive.module;
    for (std::size_t k = 0; k < surface.z().size(); ++k)
        if (double const meeting = surface::meeting_radius(outline, k, distance, pitch); meeting > 0)
            tip = std::max(tip, meeting + least - surface.tip_shift(k));
    return std::max(tip, surface.solvable_tip(distance));
}

void refuse_to_lift_for_ever(int round, double tip)
{
    constexpr int budget = 12;
    if (round + 1 == budget)
        throw NumericalError(ErrorCode::not_converged, "contact", "tip circle",
                             "side clearance and tip circle did not settle at a tip circle of " + std::to_string(tip) +
                                 " mm: the teeth become too short for this tilt");
}

void reach(CaseSurface const& surface, Cleared& cleared, double distance)
{
    cleared.reach = distance;
    cleared.flanks = part_flanks(surface, cleared.outline, cleared.tip, distance);
}

}  // namespace hdconj::contact
