// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "bezier": Bezier curves from control points.
#include "base/text.hpp"
#include "families.hpp"
#include "sound_flank.hpp"

namespace hdconj::profile {
namespace {

/// Largest degree of a Bezier curve: its meshing condition has degree 2 d - 1, and Bernstein work arrays end at 23.
constexpr int largest_bezier_degree = (numeric::bernstein_max_degree + 1) / 2;

/// Right flank from its control points, from tip to root, y from the pitch line: x(t) = sum_i B_i^d(t) points[i].
///
/// `degree` d: each curve takes d + 1 points and begins with the last point of the one before; absent: one curve
/// through all of them. Where two curves join with a bend the flank has a corner (convex: it sweeps a path of its own).
/// Degree 1 is a polygon. The addendum and dedendum are the heights of the first and the last point. Exact: no
/// approximation. Refused: curves without tangent (end points on each other, cusps), flanks that cross themselves or
/// the centre line.
Profile bezier_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    scene::NumberRows const& rows = c.rows("points");
    scene::ParameterFaults const refuse(c, faults);
    bool const given = c.has("degree");
    auto const degree = given ? static_cast<std::size_t>(c.number_or("degree", 1)) : rows.size() - 1;
    if (!given && degree > static_cast<std::size_t>(largest_bezier_degree))
        refuse("points",
               "one curve of " + std::to_string(rows.size()) + " points has degree " + std::to_string(degree) +
                   ", above " + std::to_string(largest_bezier_degree),
               "write degree = 3 and curves of 4 points that share their ends, or fewer points");
    else if ((rows.size() - 1) % degree != 0)
        refuse(
            "points",
            std::to_string(rows.size()) + " points make no whole number of curves of degree " + std::to_string(degree),
            "write " + std::to_string((rows.size() - 1) / degree * degree + 1) + " or " +
                std::to_string(((rows.size() - 1) / degree + 1) * degree + 1) + " points");
    double const h_a = rows.front()[1];
    double const h_f = -rows.back()[1];
    if (!(h_a > 0) || !(h_f > 0))
        refuse("points",
               "the flank goes from height " + short_number(h_a) + " to " + short_number(-h_f) +
                   " and does not cross the pitch line y = 0 downwards",
               "give the points from tip to root and measure y from the pitch line, up towards the tip");
    if (refuse.any())
        return {};

    std::vector<FlankSegment> flank;
    for (std::size_t first = 0; first + degree < rows.size(); first += degree) {
        std::vector<double> x, y;
        for (std::size_t i = first; i <= first + degree; ++i) {
            x.push_back(rows[i][0]);
            y.push_back(rows[i][1]);
        }
        std::string const name = degree + 1 == rows.size() ? "curve" : "curve " + std::to_string(first / degree + 1);
        Vec2 const a{x.front(), y.front()};
        Vec2 const b{x.back(), y.back()};
        if (degree == 1)
            flank.push_back({name, {LinePiece{a, b}}});
        else
            flank.push_back({name, {CurvePiece(std::move(x), std::move(y))}});
        if (degree == 1 && a == b)
            refuse("points", "point " + std::to_string(first + 2) + " repeats the one before",
                   "remove the repeated point");
    }
    if (refuse.any())
        return {};
    validate_flank(flank, c, "points", faults);
    return refuse.any() ? Profile{} : symmetric_tooth(flank, place, h_a, h_f);
}

}  // namespace

Family bezier()
{
    using enum scene::Quantity;
    return {{"bezier",
             "Bezier curves from control points",
             {scene::with_words({"points", rows,
                                 "control points of the right flank from tip to root, y from the pitch line", true, 2},
                                {"[x, y]"}),
              {"degree", count,
               "degree d of each curve: curves of d + 1 points, the last of one is the first of the next; default: one "
               "curve of all points",
               false, 1, largest_bezier_degree}}},
            bezier_tooth};
}

}  // namespace hdconj::profile
