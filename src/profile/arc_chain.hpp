// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "arc-chain": any number of arcs and straight lines, each tangent to the one before.
#pragma once

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// Right flank from the tip corner (tip_thickness/2, h_a), whose normal stands tip_angle_deg above the horizontal, down
/// to y = -h_f. Each row of `pieces` goes on along the tangent:
///   [length]             a straight line
///   [radius, sweep_deg]  an arc; radius > 0 convex (the normal falls by the sweep), radius < 0 concave (it rises)
/// The last piece is cut at the root; the chain must reach it.
///
/// Degenerate: tip_thickness 0 is a pointed or, with tip_angle_deg = 90, a round tip. Lines of length 0 and arcs of
/// sweep 0 are left out. Arcs so short that their ends are one point to 1e-12 of the height are left out as well, their
/// sweep stays (as a corner); arcs of radius above 1000 heights are written as polynomials of degree 9, since their
/// centres would lie further away than the digits reach. Accuracy: roundoff of the height.
struct ArcChain
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {
            "arc-chain",
            "arcs and straight lines from the tip to the root, each tangent to the one before",
            {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
             {"dedendum", positive_length, "depth of the root below the pitch line, h_f: the last piece is cut there"},
             {"tip_thickness", nonnegative_length, "thickness of the tooth at the tip"},
             {"tip_angle_deg",
              angle_deg,
              "angle between flank and the tooth's centre line at the tip; 90 with tip_thickness 0: a round tip",
              true,
              {},
              -60,
              90},
             {"pieces",
              rows,
              "lines [length] and arcs [radius, sweep_deg] from tip to root; radius above 0: convex, below 0: concave",
              true,
              {"[length]", "[radius, sweep_deg]"},
              1}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

}  // namespace hdconj::profile
