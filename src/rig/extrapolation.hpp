// SPDX-License-Identifier: GPL-3.0-or-later
// Angles at the torque where the load has gone, from readings under load.
#pragma once

#include <cstddef>
#include <vector>

#include "fits.hpp"
#include "found.hpp"

namespace hdconj::rig {

/// The readings to extrapolate from, by their distance from the torque at which the backlash is crossed [N mm].
struct Reach
{
    double gap = 0;  ///< nearer, the drive may lie anywhere in its backlash
    double far = 0;
};

/// A reading beside that torque.
struct BesideCrossing
{
    double distance = 0;  ///< below 0: on the negative side [N mm]
    double angle = 0;     ///< [rad]
};

/// One value in three ways, as far as the readings tell them: by a line through the readings within reach; what it
/// changes by where the curve has the curvature of the readings up to twice as far; by a parabola within reach.
using ByCurve = std::vector<Found>;
enum CurveOf : std::size_t
{
    line,
    bend,
    parabola
};

/// What is wanted of the crossing.
enum class AtCrossing
{
    angle,  ///< from readings of the positive side
    jump,   ///< of the angle, from readings of both sides: their curves are alike, turned by half a turn about its
            ///< middle
};

/// The readings that a value is found from, by torque.
struct CrossingReadings
{
    std::vector<BesideCrossing> near;     ///< within reach
    std::vector<BesideCrossing> farther;  ///< the same and more
};

/// @param far  the reach [N mm]
/// @returns nothing where near are fewer than two on a side
[[nodiscard]] ByCurve extrapolations(CrossingReadings const& readings, AtCrossing wanted, double far,
                                     Noise const& noise);

/// The mean over all branches of each way that all of them have.
[[nodiscard]] std::vector<Estimate> means_of(std::vector<ByCurve> const& branches);

/// What a curve that need not be straight says: a mean of line and parabola.
///
/// Both differ by d, on a straight curve with the variance v of the parabola less that of the line, because the line is
/// then the best estimate (Hausman, Econometrica 46, 1978). Over such distances the parabola has at least twice the
/// error of the line; where steps of an encoder hide that, twice is taken. How far the line is off is not known before,
/// but the farther readings tell it with a sixth of that error: as b^2 on average, less the noise in it, of a curve
/// whose curvature is the same near zero torque. It may be three times as large there, p = (3 b)^2. The mean with the
/// least error then takes the share p/(p + v) of the parabola.
///
/// A parabola leaves some of a curve that is none: as much as it takes off, or twice what d is larger than b, which is
/// how the curvature grows towards zero torque. This is added to the error as far as d is beyond 1.5 deviations of its
/// noise. Of a power p of the torque the parabola leaves 0 d for p = 2, 0.3 d for p = 1.5, 1.4 d for p = 0.8 and 1.9 d
/// for p = 2/3. Without a parabola it is the line, with an error of 2 b. Exact for lines. A bend nearer than all
/// readings is not in the error. Domain: not empty.
[[nodiscard]] Estimate extrapolated(std::vector<Estimate> const& by_curve);

}  // namespace hdconj::rig
