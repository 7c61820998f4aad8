// SPDX-License-Identifier: GPL-3.0-or-later
// The instant at which a tooth of given undeformed angle is where it is.
#pragma once

#include <cmath>
#include <string>

#include "hdconj/error.hpp"
#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::motion {

/// The motion's parameter at the undeformed angle @p phi, for a motion whose phi grows with it.
/// Accuracy: roundoff. @throws NumericalError where phi does not grow
template <class Motion>
[[nodiscard]] double parameter_at(Motion const& motion, double phi)
{
    auto const excess = [&](double u) { return motion.angles(u).phi - phi; };
    double const first = excess(phi);
    if (first == 0)
        return phi;
    // u - phi is periodic and small: v/r to first order
    constexpr double margin = 2;
    double const reach = margin * std::abs(first) + 16 * unit_roundoff * std::abs(phi);
    for (double step = reach; step < motion.half_lobe(); step *= 2) {
        double const other = first > 0 ? phi - step : phi + step;
        double const at_other = excess(other);
        if (std::signbit(at_other) == std::signbit(first) && at_other != 0)
            continue;
        numeric::BracketedRoot const root = other < phi ? numeric::bracketed_root(excess, other, phi, at_other, first)
                                                        : numeric::bracketed_root(excess, phi, other, first, at_other);
        if (root.found)
            return root.x;
    }
    throw NumericalError(ErrorCode::not_converged, "motion", "phi = " + std::to_string(phi),
                         "the angle on the deformed curve could not be found");
}

}  // namespace hdconj::motion
