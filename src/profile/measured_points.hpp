// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "points": a spline through given points.
#pragma once

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// Cubic spline with continuous curvature and not-a-knot ends through the points of a CSV file, parameter = chord
/// length.
///
/// The file has two columns x,y in mm, y from the pitch line, '#' starts a comment, one header line is allowed.
/// side = "right" (default): the right flank between tip and root, mirrored; "full": the whole tooth from left root to
/// right root. Accuracy: passes through every point to roundoff; between points O(h^4) for data from a smooth curve.
/// Domain: 4 to 10 000 points, no two neighbours equal. The addendum and dedendum are the largest and smallest y.
struct MeasuredPoints
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {"points",
                "a smooth spline through measured or computed points",
                {{"file", file, "CSV file with columns x,y in mm, y from the pitch line"},
                 {"side", word, "what the file holds; default \"right\"", false, {"right", "full"}}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

/// The interpolating spline as one Bernstein piece per interval between its knots.
/// @param points  (n,2), n >= 4, neighbours distinct
[[nodiscard]] std::vector<CurvePiece> spline_through(std::vector<Vec2> const& points);

/// The tooth of the spline through @p points, either way round; `side` of @p choice says what they are. Faults name @p
/// key.
[[nodiscard]] Profile tooth_through(std::vector<Vec2> points, scene::FamilyChoice const& choice, std::string_view key,
                                    ToothPlace const& place, Faults& faults);

}  // namespace hdconj::profile
