// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/four_roller.hpp"

#include <cmath>

#include "base/text.hpp"
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
    FourRoller const shape(choice.number_or(radial_deformation, 0), beta, place.waves);
    if (!shape.is_largest_on_axis()) {
        constexpr double step = 0.1;
        double largest = std::floor(to_deg(shape.h_) / step);
        while (!FourRoller(1, from_deg(largest * step), place.waves).is_largest_on_axis())
            --largest;
        std::string const value = short_number(largest * step), usual = short_number(60.0 / place.waves);
        scene::ParameterFaults(choice, faults)(
            key,
            "between rollers this far from the major axis the ring sinks in, and reaches out farthest beside the axis",
            "write at most " + value + " (" + usual + " is usual)", value);
        return {};
    }
    return shape;
}

bool FourRoller::is_largest_on_axis() const
{
    return h_ > beta_ && one_force(beta_).w2 < 0;
}

}  // namespace hdconj::wavegen
