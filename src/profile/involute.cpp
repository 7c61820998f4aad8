// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "involute": flanks unwound from a base circle.
#include <cmath>

#include "base/text.hpp"
#include "cusp.hpp"
#include "families.hpp"
#include "hdconj/profile/polynomial_curve.hpp"
#include "hdconj/units.hpp"

namespace hdconj::profile {
namespace {

/// The right flank's involute by the angle rolled from the pitch point.
struct InvoluteCurve
{
    double pitch_radius;  ///< r
    double alpha;
    double half_angle;  ///< s/(2 r)

    [[nodiscard]] double base_radius() const { return pitch_radius * std::cos(alpha); }
    /// Where the string has length 0.
    [[nodiscard]] double base() const { return -std::tan(alpha); }
    [[nodiscard]] double beta(double t) const { return half_angle - alpha - t; }
    /// Angle of the outward normal: the tangent stands at beta clockwise from y, so the normal at -beta from x.
    [[nodiscard]] double normal(double t) const { return -beta(t); }

    [[nodiscard]] CurveJet operator()(double t) const
    {
        double const half = std::sin(0.5 * half_angle);
        double const b = beta(t);
        // sin b - sin beta(0) and cos b - cos beta(0) as products: no difference of close numbers of size r_b
        double const turn = 2 * std::sin(0.5 * t);
        double const mean = b + 0.5 * t;
        double const sine = -turn * std::cos(mean);
        double const cosine = turn * std::sin(mean);
        double const x = t * std::cos(b) - base() * cosine + sine;
        double const y = -t * std::sin(b) + base() * sine + cosine;
        Vec2 const pitch_point{pitch_radius * std::sin(half_angle), -2 * pitch_radius * half * half};
        return {pitch_point + base_radius() * Vec2(x, y),
                base_radius() * (t - base()) * Vec2(std::sin(b), std::cos(b))};
    }
};

/// The flank from its parameter @p tip down to y = -h_f.
std::vector<FlankSegment> flank_down_from(double tip, InvoluteCurve const& involute, double h_a, double h_f)
{
    double const height = h_a + h_f;
    std::vector<FlankSegment> flank{{"involute", {}}};
    auto const add_curve = [&](double to) {
        for (CurvePiece& piece : polynomial_curve(involute, tip, to, curve_accuracy * height))
            flank.front().pieces.emplace_back(std::move(piece));
    };
    // an arc over the first roll angle t from the base circle differs from the involute by less than r_b t^3 / 32
    double const cut = involute.base() + std::cbrt(32 * 0x1p-40 * height / involute.base_radius());
    if (involute(cut).point.y() <= -h_f) {
        add_curve(*at_height(involute, -h_f, cut, tip));
        return flank;
    }
    add_curve(cut);
    Vec2 const end = involute(cut).point;
    double const radial = involute.normal(involute.base());
    ArcPiece const arc = arc_onto_line({end, involute.normal(cut)}, involute(involute.base()).point, radial);
    Vec2 const landing = arc.centre + arc.radius * direction(radial);
    auto const straight_to_root = [&](Vec2 const& from, double normal) {
        Vec2 const way = right_of(direction(normal));
        return LinePiece{from, from + way * ((from.y() + h_f) / -way.y())};
    };
    if (landing.y() > -h_f) {
        flank.front().pieces.emplace_back(arc);
        flank.push_back({"radial line", {straight_to_root(landing, radial)}});
    } else
        flank.push_back({"radial line", {straight_to_root(end, involute.normal(cut))}});
    return flank;
}

/// Right flank: involute of the circle r_b = r cos(alpha) about the undeformed gear's centre, r = m z / 2 the pitch
/// circle, which the pitch line y = 0 touches at x = 0; r < 0 on the circular spline, whose centre is on the other side
/// and whose flanks are concave. Rolled by t from the pitch point (string of length r_b (tan alpha + t)) its tangent
/// stands at beta(t) = s/(2 r) - alpha - t clockwise from y, and
///
///   P(t) = P(0) + r_b integral_0^t (tan alpha + tau) (sin beta(tau), cos beta(tau)) dtau,   P(0) = r (sin, cos -
///   1)(s/(2 r))
///
/// Cut flat at y = h_a and at y = -h_f; where the root lies below the base circle the flank goes on along the radius.
/// At the base circle the involute has no radius of curvature: within 1e-12 of the tooth's height it is replaced by a
/// small arc. Accuracy: curve_accuracy of the height. Refused: flanks that cross below the tip; on the circular spline
/// a tip beyond the base circle.
Profile involute_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0), h_f = c.number_or("dedendum", 0);
    double const r = -place.centre();
    scene::ParameterFaults const refuse(c, faults);
    double const s = thickness_at_pitch(c, place, faults);
    if (!(h_f < std::abs(r)))
        refuse("dedendum", "is more than the pitch radius " + short_number(std::abs(r)), "write about 1.2 modules");
    if (refuse.any())
        return {};

    InvoluteCurve const involute{r, from_deg(c.number_or("pressure_angle_deg", 0)), s / (2 * r)};
    // the flank leans over until its tangent is 69 degrees from y; it has crossed the centre line long before
    constexpr double leaning = 1.2;
    double const last = involute.beta(0) + leaning;
    double const base_height = involute(involute.base()).point.y();
    if (place.internal && !(h_a < base_height)) {
        refuse("addendum",
               "the tip lies beyond the base circle, where the involute ends at height " + short_number(base_height),
               "write a smaller addendum or a larger pressure_angle_deg");
        return {};
    }
    double const tip_end = place.internal ? involute.base() : last;
    std::optional<double> const tip = at_height(involute, h_a, 0, tip_end);
    double const half_tip = tip ? involute(*tip).point.x() : -1;
    if (!(half_tip > -pointed_tip * h_a)) {
        numeric::BracketedRoot const crossing = numeric::bracketed_root([&](double t) { return involute(t).point.x(); },
                                                                        std::min(0.0, tip_end), std::max(0.0, tip_end));
        refuse_crossing(refuse, involute(crossing.x).point.y(), "a larger thickness or a smaller pressure_angle_deg");
        return {};
    }
    if (!place.internal)
        return symmetric_tooth(flank_down_from(*tip, involute, h_a, h_f), place, h_a, h_f);
    std::optional<double> const root = at_height(involute, -h_f, 0, leaning);
    if (!root) {
        refuse("dedendum", "the involute does not reach down to the root", "write about 1.2 modules");
        return {};
    }
    FlankSegment const flank =
        curve_segment("involute", polynomial_curve(involute, *tip, *root, curve_accuracy * (h_a + h_f)));
    return symmetric_tooth({flank}, place, h_a, h_f);
}

}  // namespace

Family involute()
{
    using enum scene::Quantity;
    return {{"involute",
             "involutes of a base circle about the undeformed gear's centre",
             {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
              {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
              {"pressure_angle_deg", angle_deg,
               "pressure angle on the pitch circle of radius module * teeth / 2, alpha", true, 1, 60},
              {"thickness", positive_length, "tooth thickness on the pitch circle, s; default pi module / 2", false}}},
            involute_tooth};
}

}  // namespace hdconj::profile
