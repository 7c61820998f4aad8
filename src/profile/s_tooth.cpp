// SPDX-License-Identifier: GPL-3.0-or-later
#include "s_tooth.hpp"

#include "base/text.hpp"
#include "hdconj/units.hpp"

namespace hdconj::profile {

Profile STooth::build(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    double const h_a = c.number_or("addendum", 0);
    double const h_f = c.number_or("dedendum", 0);
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
               "no point of the locus has it: the least for this deflection is " + short_number(least * per_deg) +
                   " degrees",
               "write a larger angle, or leave the key out, which takes the least");
    HalvedLocus locus{0.5 * place.module * place.tooth_difference, n, kappa,
                      eta_of_angle(kappa, n, std::max(alpha, least)), Vec2::Zero()};
    // at eta = 0 the cycloid of kappa = 1 has a cusp: the curve's radius there is about eta m D / 2
    constexpr double blunt = 0.02;
    if (!(kappa * std::sin(locus.eta_datum) > blunt))
        refuse("pressure_angle_deg", "the locus has its cusp at the datum point",
               "write pressure_angle_deg = " + short_number(std::ceil(60 * blunt / n)) + " or more");
    if (refuse.any())
        return {};

    double const last = std::numbers::pi - locus.eta_datum;
    double const end = rise + locus(last).point.y();
    // at its end the flank lies flat
    constexpr double flat = 0x1p-20;
    if (!(h_a < end - flat * (h_a + h_f))) {
        refuse("addendum", "the locus ends at height " + short_number(end),
               "write a smaller addendum or a larger deflection or datum_rise");
        return {};
    }
    // the thickness is measured at the pitch line, which the straight part crosses when the datum point is above it
    locus.datum.y() = rise;
    locus.datum.x() = rise >= 0 ? half - rise * std::tan(alpha) : half - locus(*at_height(locus, 0, 0, last)).point.x();
    double const tip = *at_height(locus, h_a, 0, last);
    if (!(locus(tip).point.x() > -pointed_tip * h_a)) {
        numeric::BracketedRoot const crossing =
            numeric::bracketed_root([&](double e) { return locus(e).point.x(); }, 0, last);
        std::string const height = short_number(crossing.found ? locus(crossing.x).point.y() : rise);
        refuse("addendum", "the two flanks cross below the tip: the tooth becomes pointed at height " + height,
               "write an addendum of at most " + height + ", or a larger thickness");
        return {};
    }
    FlankSegment const curve = curve_segment("locus", polynomial_curve(locus, tip, 0, curve_accuracy * (h_a + h_f)));
    Vec2 const down = right_of(direction(alpha));
    LinePiece const line{locus.datum, locus.datum + down * ((rise + h_f) / -down.y())};
    return symmetric_tooth({curve, {"straight line", {line}}}, place, h_a, h_f);
}

}  // namespace hdconj::profile
