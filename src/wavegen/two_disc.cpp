// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/two_disc.hpp"
#include "hdconj/units.hpp"

#include "hdconj/error.hpp"
#include "hdconj/numeric/panel_integral.hpp"

namespace hdconj::wavegen {

TwoDisc::TwoDisc(double w0, double beta, int n, double r_m) : w0_(w0), n_(n), r_m_(r_m), breaks_{-beta, beta}
{
    // the excess length is nearly linear in the disc's radius: secant steps
    double before = r_m;
    fit(before);
    double excess_before = mean_length() - r_m;
    double now = r_m - w0;
    constexpr int budget = 60;
    double const settled = 4 * unit_roundoff * r_m;
    for (int i = 0; i < budget; ++i) {
        if (!(now > 0))
            break;
        fit(now);
        double const excess = mean_length() - r_m;
        double const step = excess * (now - before) / (excess - excess_before);
        if (!(std::abs(excess) > settled) || !(std::abs(step) > settled))
            return;
        before = now;
        excess_before = excess;
        now -= step;
        if (!std::isfinite(now))
            break;
    }
    throw NumericalError(ErrorCode::no_solution, "wave generator", "two-disc",
                         "no disc radius makes the curve as long as the ring");
}

void TwoDisc::fit(double disc)
{
    disc_ = disc;
    eccentricity_ = r_m_ + w0_ - disc;
    RadialDisplacement const joint = on_disc(breaks_[1]);
    double const y = breaks_[1] - std::numbers::pi / n_;
    double const s = std::sin(y);
    double const c = std::cos(y);
    // tangent and bending moment: two equations for A and D
    double const a11 = -s, a12 = s + y * c, a21 = -c, a22 = 2 * c - y * s;
    double const det = a11 * a22 - a12 * a21;  // = y - sin y cos y
    a_ = (joint.w1 * a22 - a12 * joint.w2) / det;
    d_ = (a11 * joint.w2 - a21 * joint.w1) / det;
    c_ = joint.w - a_ * c - d_ * y * s;
}

double TwoDisc::mean_length() const
{
    auto const element = [&](double u) {
        RadialDisplacement const d = (*this)(u);
        return std::hypot(r_m_ + d.w, d.w1);
    };
    return numeric::PanelIntegral(element, 2 * std::numbers::pi / n_, breaks_).mean();
}

TwoDisc TwoDisc::build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    constexpr std::string_view key = "wrap_angle_deg";
    if (place.waves < 2) {
        faults.push_back(
            waves_fault(choice, place.waves, "a single disc leaves the ring a circle beside the axis", "write 2 or 3"));
        return {};
    }
    double const wrap = choice.number_or(key, 0);
    double const most = 90.0 / place.waves;
    if (!(wrap < most)) {
        faults.push_back(scene::parameter_fault(
            choice, key, "the discs would hold the ring beyond the middle of its flanks, where it bends inwards",
            "write less than " + std::to_string(static_cast<int>(most)) + " (20 to 40 are usual)"));
        return {};
    }
    double const w0 = choice.number_or(radial_deformation, 0);
    if (!(place.r_m > 0) || !(w0 < place.r_m))
        return {};  // reported with the drive's dimensions
    try {
        return {w0, from_deg(wrap), place.waves, place.r_m};
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::no_solution)
            throw;
        faults.push_back(scene::parameter_fault(choice, radial_deformation,
                                                "no disc radius makes the neutral curve as long as the ring",
                                                "write about one module"));
        return {};
    }
}

}  // namespace hdconj::wavegen
