// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "straight": straight flanks, as in Musser's first drives.
#include <algorithm>
#include <cmath>

#include "families.hpp"
#include "hdconj/units.hpp"

namespace hdconj::profile {
namespace {

/// Right flank x = s/2 - y tan(alpha) from y = h_a down to y = -h_f, flat tip.
Profile straight_sided_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0), h_f = c.number_or("dedendum", 0);
    double const half = c.number_or("thickness", 0) / 2;
    double const slope = std::tan(from_deg(c.number_or("pressure_angle_deg", 0)));
    double const tip = half - h_a * slope;
    if (!(tip > -pointed_tip * h_a)) {
        refuse_crossing({c, faults}, half / slope, "a larger thickness or a smaller pressure_angle_deg");
        return {};
    }
    FlankSegment const flank{"flank", {LinePiece{{std::max(0.0, tip), h_a}, {half + h_f * slope, -h_f}}}};
    return symmetric_tooth({flank}, place, h_a, h_f);
}

}  // namespace

Family straight_sided()
{
    using enum scene::Quantity;
    return {
        {"straight",
         "straight flanks at a pressure angle",
         {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
          {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
          {"thickness", positive_length, "tooth thickness at the pitch line, s"},
          {"pressure_angle_deg", angle_deg, "angle between flank and the tooth's centre line, alpha", true, 0, 60}}},
        straight_sided_tooth};
}

}  // namespace hdconj::profile
