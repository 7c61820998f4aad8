// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "b-spline": a cubic spline through points that stand in the scene.
#pragma once

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// The spline of family "points" (cubic, continuous curvature, not-a-knot ends, parameter = chord length) through
/// points of the scene.
///
/// side = "right" (default): the right flank between tip and root, mirrored; "full": the whole tooth from left root to
/// right root. The addendum and dedendum are the largest and smallest y. Accuracy: passes through every point to
/// roundoff. Refused: neighbours on each other, flanks that cross themselves or the centre line.
struct BSpline
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {"b-spline",
                "a smooth spline through points given in the scene",
                {{"points", rows, "points of the tooth, y from the pitch line", true, {"[x, y]"}, 4},
                 {"side", word, "what the points are; default \"right\"", false, {"right", "full"}}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

}  // namespace hdconj::profile
