// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "s-tooth": half the path that a tooth describes.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "families.hpp"
#include "hdconj/profile/polynomial_curve.hpp"
#include "hdconj/units.hpp"

namespace hdconj::profile {
namespace {

/// The halved locus from its datum point, by eta - eta_M.
struct HalvedLocus
{
    double size;   ///< m D / 2
    double waves;  ///< n
    double kappa;
    double eta_datum;  ///< eta_M
    Vec2 datum;        ///< M

    [[nodiscard]] CurveJet operator()(double e) const
    {
        double const eta = eta_datum + e;
        double const middle = eta_datum + 0.5 * e;
        double const turn = std::sin(0.5 * e);
        Vec2 const from_datum{-0.5 * size / waves * (e - 2 * kappa * std::cos(middle) * turn),
                              kappa * size * std::sin(middle) * turn};
        return {datum + from_datum,
                {-0.5 * size / waves * (1 - kappa * std::cos(eta)), 0.5 * kappa * size * std::sin(eta)}};
    }
};

/// Least pressure angle of the locus [rad]; 0 for kappa >= 1.
double least_locus_angle(double kappa, double waves)
{
    return kappa < 1 ? std::atan(std::sqrt(1 - kappa * kappa) / (waves * kappa)) : 0;
}

/// eta_M: the last eta with pressure angle @p alpha >= the least. From n kappa tan(alpha) sin eta + kappa cos eta = 1.
double eta_of_angle(double kappa, double waves, double alpha)
{
    double const k = waves * std::tan(alpha);
    return std::atan(k) + std::acos(std::min(1.0, 1 / (kappa * std::hypot(1.0, k))));
}

/// Where the flank meets the centre line, or ends at the parameter @p last.
double pointed_height(HalvedLocus const& locus, double last)
{
    numeric::BracketedRoot const crossing =
        numeric::bracketed_root([&](double e) { return locus(e).point.x(); }, 0, last);
    return locus(crossing.found ? crossing.x : last).point.y();
}

/// A tip between the datum point and the end of the locus at @p last, where the flank is nearly flat, or where the
/// tooth becomes pointed; for numbers of teeth that do not meet, that of those that do. At most 0 where no tip is that
/// low [mm].
double usual_height(ToothPlace const& place, HalvedLocus const& locus, double last)
{
    constexpr double low_tip = 0.9;
    bool const meets = place.tooth_difference > 0 && place.tooth_difference % place.waves == 0;
    double const share = low_tip * (meets ? 1 : static_cast<double>(place.waves) / std::max(1, place.tooth_difference));
    double const rise = locus.datum.y();
    return locus.datum.x() > 0 ? rise + share * (pointed_height(locus, last) - rise) : 0;
}

/// Refuses an addendum beyond the @p end of the locus. @param usual  usual_height()
void refuse_height(scene::ParameterFaults const& refuse, double usual, double end)
{
    std::string const height = usual > 0 ? short_number(usual, 3) : "";
    refuse("addendum", "the flank ends at height " + short_number(end) + ", below the tip",
           (usual > 0 ? "write an addendum of at most " + height + ", or " : "write ") +
               "a larger deflection or datum_rise",
           height);
}

/// The S-tooth after Ishikawa ("IH"): a tooth of the flexspline moves along the locus (rack limit: many teeth, no
/// rotation)
///
///   L(eta) = m D (eta/n - (kappa/n) sin eta, kappa cos eta) / 2,   D = z_c - z_f, eta = n phi, kappa = 2 w0 / (m D)
///   the deflection coefficient
///
/// and the flank is this locus halved, from the datum point M up to the tip:  P(eta) = M + (L(eta_M) - L(eta))/2, eta_M
/// < eta < pi. A flank of the circular spline M - (L(eta_M) - L(eta))/2 then touches it at every eta at once with
/// parallel tangents, in the rack limit. eta_M is where the flank has the pressure angle alpha: tan(alpha) = (1 - kappa
/// cos eta)/(n kappa sin eta); for kappa < 1 (negative deviation) the least is sqrt(1 - kappa^2)/(n kappa), at the
/// locus's point of inflexion. Below M the flank is straight, along the tangent at M, with continuous curvature when
/// alpha is that least angle. Source: the definitions of eta, kappa and M of EP 0266972 and US 5,458,023; equations
/// derived from the drive's own kinematics. Accuracy: curve_accuracy of the height. Refused: an addendum above the
/// locus's end at eta = pi, a pressure angle that no point has, the cusp of kappa = 1 at eta = 0 for M.
Profile s_tooth_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0), h_f = c.number_or("dedendum", 0);
    double const kappa = c.number_or("deflection", 0);
    double const n = place.waves;
    double const rise = c.number_or("datum_rise", 0);
    double const least = least_locus_angle(kappa, n);
    double const alpha = c.has("pressure_angle_deg") ? from_deg(c.number_or("pressure_angle_deg", 0)) : least;
    scene::ParameterFaults const refuse(c, faults);
    double const half = thickness_at_pitch(c, place, faults) / 2;

    if (!(rise < h_a) || !(rise > -h_f))
        refuse("datum_rise", "the datum point would not lie between tip and root",
               "write a height between " + short_number(-h_f) + " and " + short_number(h_a));
    // an angle typed with the digits of `least` may fall short of it by its own rounding
    constexpr double typed = 1e-6;
    if (alpha < least * (1 - typed))
        refuse("pressure_angle_deg",
               "no point of the flank has it: the least for this deflection is " + short_number(least * per_deg) +
                   " degrees",
               "write a larger angle, or leave the key out, which takes the least");
    HalvedLocus locus{0.5 * place.module * place.tooth_difference, n, kappa,
                      eta_of_angle(kappa, n, std::max(alpha, least)), Vec2::Zero()};
    // at eta = 0 the cycloid of kappa = 1 has a cusp: the curve's radius there is about eta m D / 2
    constexpr double blunt = 0.02;
    if (std::string const blunted = short_number(std::ceil(60 * blunt / n));
        !(kappa * std::sin(locus.eta_datum) > blunt))
        refuse("pressure_angle_deg", "the flank would have a cusp at its datum point",
               "write pressure_angle_deg = " + blunted + " or more", blunted);
    if (refuse.any())
        return {};

    double const last = std::numbers::pi - locus.eta_datum;
    locus.datum.y() = rise;
    // the thickness is measured at the pitch line, which the straight part crosses when the datum point is above it
    std::optional<double> const pitch_line = rise < 0 ? at_height(locus, 0, 0, last) : std::nullopt;
    locus.datum.x() = half - (pitch_line ? locus(*pitch_line).point.x() : std::max(0.0, rise) * std::tan(alpha));
    // at its end the flank lies flat
    constexpr double flat = 0x1p-20;
    double const end = locus(last).point.y();
    if (!(h_a < end - flat * (h_a + h_f))) {
        refuse_height(refuse, usual_height(place, locus, last), end);
        return {};
    }
    if (!(locus.datum.x() > 0)) {
        refuse("thickness", "the two flanks cross below the datum point",
               "write a larger thickness or a smaller datum_rise");
        return {};
    }
    double const tip = *at_height(locus, h_a, 0, last);
    if (!(locus(tip).point.x() > -pointed_tip * h_a)) {
        refuse_crossing(refuse, pointed_height(locus, last), "a larger thickness");
        return {};
    }
    FlankSegment const curve = curve_segment("locus", polynomial_curve(locus, tip, 0, curve_accuracy * (h_a + h_f)));
    Vec2 const down = right_of(direction(alpha));
    LinePiece const line{locus.datum, locus.datum + down * ((rise + h_f) / -down.y())};
    return symmetric_tooth({curve, {"straight line", {line}}}, place, h_a, h_f);
}

}  // namespace

Family s_tooth()
{
    using enum scene::Quantity;
    return {{"s-tooth",
             "half the locus of a tooth (Ishikawa's S-tooth), straight below its datum point",
             {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
              {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
              {"deflection", number,
               "deflection coefficient kappa = 2 w0 / (m (z_c - z_f)); below 1: negative deviation", true, 0.2, 1.5},
              {"pressure_angle_deg", angle_deg,
               "of the straight part and at the datum point, alpha; default: the least there is, which deflection 1 or "
               "more does not have",
               false, 0, 45},
              {"thickness", positive_length, "tooth thickness at the pitch line, s; default pi module / 2", false},
              {"datum_rise", length, "height of the datum point above the pitch line; default 0", false}}},
            s_tooth_tooth};
}

}  // namespace hdconj::profile
