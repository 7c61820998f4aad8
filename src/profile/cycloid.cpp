// SPDX-License-Identifier: GPL-3.0-or-later
#include "cycloid.hpp"

#include <numbers>

#include "cusp.hpp"

#include "base/text.hpp"

namespace hdconj::profile {

double CycloidCurve::last() const
{
    // short of the right angle: the flank must not lie flat
    constexpr double upright = 0.01;
    double const rate = 0.5 + rolling / pitch_radius;
    return std::min(std::numbers::pi - upright,
                    rate > 0 ? (std::numbers::pi / 2 - upright + half_angle) / rate : std::numbers::pi);
}

namespace {

/// Epicycloid from @p tip down to the angle @p cut, two arcs across the pitch point, hypocycloid from there to @p root.
std::vector<FlankSegment> flank_of(CycloidCurve const& outside, double tip, CycloidCurve const& inside, double root,
                                   double cut, double accuracy)
{
    FlankSegment addendum = curve_segment("epicycloid", polynomial_curve(outside, tip, cut, accuracy));
    FlankSegment dedendum{"hypocycloid", {}};
    FlankPoint const upper{outside(cut).point, outside.normal(cut)};
    FlankPoint const lower{inside(cut).point, inside.normal(cut)};
    TwoArcs const arcs = two_arcs(upper, lower);
    if (arcs.convex.radius > 0) {
        addendum.pieces.emplace_back(arcs.convex);
        dedendum.pieces.emplace_back(arcs.concave);
    } else {
        // a dedendum that is radial or nearly so: the epicycloid ends on its tangent
        ArcPiece const arc = arc_onto_line(upper, lower.point, lower.normal);
        addendum.pieces.emplace_back(arc);
        dedendum.pieces.emplace_back(LinePiece{arc.centre + arc.radius * direction(lower.normal), lower.point});
    }
    for (CurvePiece& piece : polynomial_curve(inside, cut, root, accuracy))
        dedendum.pieces.emplace_back(std::move(piece));
    return {addendum, dedendum};
}

}  // namespace

Profile Cycloid::build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0);
    double const h_f = c.number_or("dedendum", 0);
    double const above = c.number_or("addendum_rolling_radius", 0);
    double const below = c.number_or("dedendum_rolling_radius", 0);
    double const r = -place.centre();
    scene::ParameterFaults const refuse(c, faults);
    double const s = thickness_at_pitch(c, place, faults);
    double const largest = std::abs(r) / 2;
    std::string_view const inner_key = place.internal ? "addendum_rolling_radius" : "dedendum_rolling_radius";
    if (!((place.internal ? above : below) <= largest))
        refuse(inner_key, "is more than half the pitch radius: the flank would be undercut",
               "write at most " + short_number(largest) + ", which makes it radial");
    if (refuse.any())
        return {};

    CycloidCurve const outside{r, above, s / (2 * r)};
    CycloidCurve const inside{r, -below, s / (2 * r)};
    // over angles up to t from the pitch point two arcs differ from a cycloid by less than rho t^3 / 60
    double const cut = std::cbrt(60 * 0x1p-40);
    std::optional<double> const tip = at_height(outside, h_a, cut, outside.last());
    std::optional<double> const root = at_height(inside, -h_f, cut, inside.last());
    if (!tip)
        refuse("addendum_rolling_radius",
               "the epicycloid reaches from " + short_number(outside(cut).point.y()) + " to " +
                   short_number(outside(outside.last()).point.y()) + ", not the tip at " + short_number(h_a),
               "write more than half the addendum");
    if (!root)
        refuse("dedendum_rolling_radius",
               "the hypocycloid reaches from " + short_number(inside(cut).point.y()) + " to " +
                   short_number(inside(inside.last()).point.y()) + ", not the root at " + short_number(-h_f),
               "write more than half the dedendum");
    if (refuse.any())
        return {};
    if (!(outside(*tip).point.x() > -pointed_tip * h_a)) {
        numeric::BracketedRoot const crossing =
            numeric::bracketed_root([&](double t) { return outside(t).point.x(); }, 0, *tip);
        std::string const height = short_number(outside(crossing.x).point.y());
        refuse("addendum", "the two flanks cross below the tip: the tooth becomes pointed at height " + height,
               "write an addendum of at most " + height + ", or a larger thickness or addendum_rolling_radius");
        return {};
    }
    return symmetric_tooth(flank_of(outside, *tip, inside, *root, cut, curve_accuracy * (h_a + h_f)), place, h_a, h_f);
}

}  // namespace hdconj::profile
