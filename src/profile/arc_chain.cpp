// SPDX-License-Identifier: GPL-3.0-or-later
#include "arc_chain.hpp"

#include <cmath>
#include <optional>

#include "base/text.hpp"
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

}  // namespace

Profile ArcChain::build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0);
    double const h_f = c.number_or("dedendum", 0);
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

}  // namespace hdconj::profile
