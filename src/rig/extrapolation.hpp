// SPDX-License-Identifier: GPL-3.0-or-later
// Angles at the torque where the load has gone, from readings under load.
#pragma once

#include <vector>

#include "found.hpp"

namespace hdconj::rig {

/// The readings to extrapolate from, by their distance from the torque at which the backlash is crossed [N mm].
struct Reach
{
    double gap = 0;  ///< nearer, the drive may lie anywhere in its backlash
    double far = 0;
};

/// One value by polynomials of degree 1, 2 ... of the angle over the torque, as far as the readings tell them.
using ByDegree = std::vector<Found>;
inline constexpr int highest_degree = 2;

/// The mean over all branches for each degree that all of them have.
[[nodiscard]] std::vector<Estimate> means_of(std::vector<ByDegree> const& branches);

/// What a curve that need not be straight says: the value by the line, or by the parabola where both differ by more
/// than three standard errors.
///
/// On a straight curve they differ by d, with the variance of the parabola less that of the line, because the line is
/// then the best estimate (Hausman, Econometrica 46, 1978). The root of what d^2 has beyond 1.5^2 times that variance
/// is curvature. Over such distances the parabola has at least twice the error of the line; where steps of an encoder
/// hide that, twice is taken. A parabola is taken to leave at most as much as it takes off: this is added to its error,
/// and twice this to that of the line. A power p of the torque, over distances from 1 to 6, leaves 0 d for p = 2, 0.3 d
/// for p = 1.5, 1.3 d for p = 0.8 and 1.8 d for p = 2/3; a bend at 1.8 leaves 1.7 d. Exact for lines. Curvature that
/// the noise hides, and a bend nearer than all readings, are not in the error. Domain: not empty.
[[nodiscard]] Estimate extrapolated(std::vector<Estimate> const& by_degree);

}  // namespace hdconj::rig
