// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "arc-chain": any number of arcs and straight lines, each tangent to the one before.
#include <cmath>

#include "base/text.hpp"
#include "families.hpp"
#include "hdconj/profile/polynomial_curve.hpp"
#include "hdconj/units.hpp"
#include "sound_flank.hpp"

namespace hdconj::profile {
namespace {

/// A row as a curve by arc length: line (curvature 0) or arc.
struct ChainPiece
{
    Vec2 start;
    double normal;     ///< angle of the outward normal at the start
    double curvature;  ///< convex positive
    double length;

    [[nodiscard]] CurveJet operator()(double s) const
    {
        double const half = 0.5 * curvature * s;
        double const chord = half == 0 ? s : s * std::sin(half) / half;
        return {start + chord * right_of(direction(normal - half)), right_of(direction(normal - 2 * half))};
    }
    [[nodiscard]] double end_normal() const { return normal - curvature * length; }
};

ChainPiece piece_of(std::vector<double> const& row, Vec2 const& start, double normal)
{
    if (row.size() == 1)
        return {start, normal, 0, row[0]};
    double const sweep = from_deg(row[1]);
    return {start, normal, 1 / row[0], std::abs(row[0]) * sweep};
}

/// The piece as the solver takes it.
PieceShape shape_of(ChainPiece const& piece, double height)
{
    if (piece.curvature == 0)
        return LinePiece{piece.start, piece(piece.length).point};
    // the centre's distance costs digits: 1000 heights cost three
    constexpr double far_centre = 1000;
    if (std::abs(piece.curvature) * height * far_centre > 1)
        return ArcPiece{piece.start - direction(piece.normal) / piece.curvature, 1 / piece.curvature, piece.normal,
                        piece.end_normal()};
    return std::move(polynomial_curve(piece, 0, piece.length, curve_accuracy * height).front());
}

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
Profile arc_chain_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0), h_f = c.number_or("dedendum", 0);
    double const height = h_a + h_f;
    scene::NumberRows const& rows = c.rows("pieces");
    std::size_t const before = faults.size();
    auto const refuse = [&](std::size_t row, std::string const& reason, std::string remedy) {
        faults.push_back(
            scene::parameter_fault(c, "pieces", "row " + std::to_string(row + 1) + " " + reason, std::move(remedy)));
    };
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].size() == 2 && !(rows[i][1] >= 0 && rows[i][1] <= 360))
            refuse(i, "has a sweep of " + short_number(rows[i][1]) + " degrees",
                   "write a sweep from 0 to 360; the sign of the radius says which way the arc bends");
    if (faults.size() > before)
        return {};

    constexpr double one_point = 1e-12;  // share of the height: no piece
    constexpr double typed = 1e-9;       // share of the height that a number typed for the root may miss it by
    std::vector<FlankSegment> flank;
    Vec2 at{0.5 * c.number_or("tip_thickness", 0), h_a};
    double normal = from_deg(c.number_or("tip_angle_deg", 0));
    double root = h_f;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        bool const last = i + 1 == rows.size();
        ChainPiece piece = piece_of(rows[i], at, normal);
        double const end = piece(piece.length).point.y();
        if (!std::isfinite(end)) {
            refuse(i, "is " + short_number(piece.length) + " mm long", "write a shorter piece");
            return {};
        }
        if (!last && end < -h_f - typed * height)
            refuse(i, "goes below the root and is not the last",
                   "leave out the rows after it, or write a larger dedendum");
        if (last && end > -h_f + typed * height)
            refuse(i,
                   "is the last and ends at height " + short_number(end) + ", above the root at " + short_number(-h_f),
                   "write a longer last piece, it is cut at the root; or a smaller dedendum");
        if (faults.size() > before)
            return {};
        if (last && end < -h_f)
            piece.length = at_height(piece, -h_f, 0, piece.length).value_or(piece.length);
        if (last)
            root = -piece(piece.length).point.y();
        if (piece.length > one_point * height) {
            std::string const name = (piece.curvature == 0 ? "line " : "arc ") + std::to_string(i + 1);
            flank.push_back({name, {shape_of(piece, height)}});
            at = end_of(flank.back().pieces.back()).point;
        }
        normal = piece.end_normal();
    }
    if (flank.empty()) {
        refuse(0, "has no length, nor have the others", "write pieces that lead from the tip to the root");
        return {};
    }
    validate_flank(flank, c, "pieces", faults);
    return faults.size() > before ? Profile{} : symmetric_tooth(flank, place, h_a, root);
}

}  // namespace

Family arc_chain()
{
    using enum scene::Quantity;
    return {
        {"arc-chain",
         "arcs and straight lines from the tip to the root, each tangent to the one before",
         {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
          {"dedendum", positive_length, "depth of the root below the pitch line, h_f: the last piece is cut there"},
          {"tip_thickness", nonnegative_length, "thickness of the tooth at the tip"},
          {"tip_angle_deg", angle_deg,
           "angle between flank and the tooth's centre line at the tip; 90 with tip_thickness 0: a round tip", true,
           -60, 90},
          scene::with_words(
              {"pieces", rows,
               "lines [length] and arcs [radius, sweep_deg] from tip to root; radius above 0: convex, below 0: concave",
               true, 1},
              {"[length]", "[radius, sweep_deg]"})}},
        arc_chain_tooth};
}

}  // namespace hdconj::profile
