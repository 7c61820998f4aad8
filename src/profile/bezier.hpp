// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tooth family "bezier": Bezier curves from control points.
#pragma once

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// Largest degree of a Bezier curve: its meshing condition has degree 2 d - 1, and Bernstein work arrays end at 23.
inline constexpr int largest_bezier_degree = (numeric::bernstein_max_degree + 1) / 2;

/// Right flank from its control points, from tip to root, y from the pitch line: x(t) = sum_i B_i^d(t) points[i].
///
/// `degree` d: each curve takes d + 1 points and begins with the last point of the one before; absent: one curve
/// through all of them. Where two curves join with a bend the flank has a corner (convex: it sweeps a path of its own).
/// Degree 1 is a polygon. The addendum and dedendum are the heights of the first and the last point. Exact: no
/// approximation. Refused: curves without tangent (end points on each other, cusps), flanks that cross themselves or
/// the centre line.
struct Bezier
{
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        using enum scene::Quantity;
        return {"bezier",
                "Bezier curves from control points",
                {{"points",
                  rows,
                  "control points of the right flank from tip to root, y from the pitch line",
                  true,
                  {"[x, y]"},
                  2},
                 {"degree",
                  count,
                  "degree d of each curve: curves of d + 1 points, the last of one is the first of the next; default: "
                  "one curve of all points",
                  false,
                  {},
                  1,
                  largest_bezier_degree}}};
    }

    [[nodiscard]] static Profile build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults);
};

}  // namespace hdconj::profile
