// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/four_roller.hpp"
#include "hdconj/units.hpp"

namespace hdconj::wavegen {

FourRoller::FourRoller(double w0, double beta, int n)
    : w0_(w0),
      beta_(beta),
      n_(n),
      h_(std::numbers::pi / n),
      e_(h_ / (4 * std::sin(h_))),
      bend_(1 + h_ / std::tan(h_)),
      scale_(1),
      breaks_{-beta, beta}
{
    scale_ = w0 / (*this)(0).w;
}

FourRoller FourRoller::build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    constexpr std::string_view key = "roller_angle_deg";
    double const beta = from_deg(choice.number_or(key, 0));
    if (place.waves < 2) {
        faults.push_back(waves_fault(choice, place.waves,
                                     "one wave of forces moves the ring as a whole and does not deform it",
                                     "write 2 or 3"));
        return {};
    }
    if (!(place.waves * beta < std::numbers::pi / 2)) {
        faults.push_back(scene::parameter_fault(
            choice, key, "rollers this far from the major axis press the ring flat where it should bulge",
            "write less than " + std::to_string(90 / place.waves) + " (25 to 35 are usual)"));
        return {};
    }
    return {choice.number_or(radial_deformation, 0), beta, place.waves};
}

}  // namespace hdconj::wavegen
