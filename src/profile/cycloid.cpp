// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "cycloid": epicycloid above the pitch circle, hypocycloid below.
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "cusp.hpp"
#include "families.hpp"
#include "hdconj/profile/polynomial_curve.hpp"

namespace hdconj::profile {
namespace {

/// One of the two curves from the pitch point, by the angle t.
struct CycloidCurve
{
    double pitch_radius;  ///< R
    double rolling;       ///< rho: > 0 outside of the pitch circle, < 0 inside
    double half_angle;    ///< s/(2 R)

    [[nodiscard]] double beta(double t) const { return half_angle - (0.5 + rolling / pitch_radius) * t; }
    /// Angle of the outward normal.
    [[nodiscard]] double normal(double t) const { return -beta(t); }

    [[nodiscard]] CurveJet operator()(double t) const
    {
        double const share = rolling / pitch_radius;
        double const p = 1 + share;
        double const q = -share;
        // the product of sines is a sum: frequencies p = 1 + rho/R and q = -rho/R, the latter next to nothing
        double const fast = std::sin(0.5 * p * t) / p;
        double const slow = 0.5 * t * (q * t == 0 ? 1.0 : std::sin(0.5 * q * t) / (0.5 * q * t));
        double const fast_at = 0.5 * p * t - half_angle;
        double const slow_at = 0.5 * q * t + half_angle;
        Vec2 const sum{fast * std::cos(fast_at) - slow * std::cos(slow_at),
                       fast * std::sin(fast_at) + slow * std::sin(slow_at)};
        double const half = std::sin(0.5 * half_angle);
        Vec2 const pitch_point{pitch_radius * std::sin(half_angle), -2 * pitch_radius * half * half};
        double const b = beta(t);
        return {pitch_point + 2 * rolling * p * sum,
                2 * rolling * p * std::sin(0.5 * t) * Vec2(std::sin(b), std::cos(b))};
    }

    /// Where the curve has turned by a right angle, or the circle by half a turn: it reaches no further from the pitch
    /// circle.
    [[nodiscard]] double last() const
    {
        // short of the right angle: the flank must not lie flat
        constexpr double upright = 0.01;
        double const rate = 0.5 + rolling / pitch_radius;
        return std::min(std::numbers::pi - upright,
                        rate > 0 ? (std::numbers::pi / 2 - upright + half_angle) / rate : std::numbers::pi);
    }
};

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

/// Right flank: a point of a circle of radius rho_a that rolls on the outside of the pitch circle (radius R = m z / 2,
/// which the pitch line touches at x = 0), and of one of radius rho_f that rolls inside, both from the pitch point at
/// the polar angle s/(2 R). With rho = rho_a or -rho_f and the circle turned by t against its line of centres,
///
///   P(t) = P(0) + 2 rho (1 + rho/R) integral_0^t sin(tau/2) (sin beta, cos beta) dtau,   beta(tau) = s/(2 R) - (1/2 +
///   rho/R) tau
///
/// Cut flat at y = h_a and y = -h_f. R < 0 on the circular spline. At the pitch point both curves are radial, with no
/// radius of curvature: the flank is tangent-continuous there, and within rho/1e12 of the cycloids a convex and a
/// concave arc stand in for them. Degenerate: rho_f = R/2 gives a radial dedendum. Accuracy elsewhere: curve_accuracy
/// of the height.
Profile cycloid_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0), h_f = c.number_or("dedendum", 0);
    double const above = c.number_or("addendum_rolling_radius", 0);
    double const below = c.number_or("dedendum_rolling_radius", 0);
    double const r = -place.centre();
    scene::ParameterFaults const refuse(c, faults);
    double const s = thickness_at_pitch(c, place, faults);
    double const largest = std::abs(r) / 2;
    std::string_view const inner_key = place.internal ? "addendum_rolling_radius" : "dedendum_rolling_radius";
    if (!((place.internal ? above : below) <= largest))
        refuse(inner_key, "is more than half the pitch radius: the flank would be undercut",
               "write at most " + at_most_text(largest) + ", which makes it radial");
    if (refuse.any())
        return {};

    CycloidCurve const outside{r, above, s / (2 * r)};
    CycloidCurve const inside{r, -below, s / (2 * r)};
    // over angles up to t from the pitch point two arcs differ from a cycloid by less than rho t^3 / 60
    double const cut = std::cbrt(60 * 0x1p-40);
    std::optional<double> const tip = at_height(outside, h_a, cut, outside.last());
    std::optional<double> const root = at_height(inside, -h_f, cut, inside.last());
    // the flank ends beside the middle of the tooth, a little lower than twice the radius
    auto const enough = [&](double radius, double side, double height) {
        constexpr int rounds = 8;
        constexpr double more = 1.001;
        for (int i = 0; i < rounds; ++i) {
            CycloidCurve const curve{r, side * radius, s / (2 * r)};
            radius *= height / std::abs(curve(curve.last()).point.y());
        }
        return short_number(more * radius);
    };
    if (!tip)
        refuse("addendum_rolling_radius",
               "the flank above the pitch line ends at height " + short_number(outside(outside.last()).point.y()) +
                   ", below the tip at " + short_number(h_a),
               "write at least " + enough(above, 1, h_a));
    if (!root)
        refuse("dedendum_rolling_radius",
               "the flank below the pitch line ends at height " + short_number(inside(inside.last()).point.y()) +
                   ", above the root at " + short_number(-h_f),
               "write at least " + enough(below, -1, h_f));
    if (refuse.any())
        return {};
    if (!(outside(*tip).point.x() > -pointed_tip * h_a)) {
        numeric::BracketedRoot const crossing =
            numeric::bracketed_root([&](double t) { return outside(t).point.x(); }, 0, *tip);
        refuse_crossing(refuse, outside(crossing.x).point.y(), "a larger thickness or addendum_rolling_radius");
        return {};
    }
    return symmetric_tooth(flank_of(outside, *tip, inside, *root, cut, curve_accuracy * (h_a + h_f)), place, h_a, h_f);
}

}  // namespace

Family cycloid()
{
    using enum scene::Quantity;
    return {{"cycloid",
             "epicycloid above the pitch circle of radius module * teeth / 2, hypocycloid below",
             {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
              {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
              {"addendum_rolling_radius", positive_length,
               "radius of the circle that rolls outside of the pitch circle, rho_a; above addendum / 2"},
              {"dedendum_rolling_radius", positive_length,
               "radius of the circle that rolls inside, rho_f; above dedendum / 2"},
              {"thickness", positive_length, "tooth thickness on the pitch circle, s; default pi module / 2", false}}},
            cycloid_tooth};
}

}  // namespace hdconj::profile
