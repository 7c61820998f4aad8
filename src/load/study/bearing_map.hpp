// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of the bearing at one torque.
#pragma once

#include <limits>

#include "hdconj/load.hpp"
#include "load/equilibrium.hpp"

namespace hdconj::load {

/// Forces between bearing and cup, and of the balls.
[[nodiscard]] BearingMap bearing_map(ElasticDrive const& drive, Equilibrium const& state);

/// The most heavily loaded ball.
struct BallPeak
{
    double force = 0;  ///< [N], of a line [N/mm]
    double phi = 0;    ///< angle from the major axis [rad]
    int carrying = 0;  ///< single balls that carry force, all around the ring
};
[[nodiscard]] BallPeak ball_peak(ElasticDrive const& drive, Equilibrium const& state);

/// Resultant over the lobe at the major axis. A force between two lobes counts half for either.
struct LobeReaction
{
    double along = 0;   ///< along the major axis [N]
    double across = 0;  ///< across it, clockwise positive [N]
    /// Height at which `along` acts [mm]. NaN, not determined, where it does not press outward or would act beyond the
    /// bearing, as the forces of one wave may: they are a couple rather than a force.
    double z = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] LobeReaction lobe_reaction(BearingMap const& bearing, int sectors, int waves);

/// Force at @p angle of the balls, interpolated between neighbours: exact at a ball. Domain: a map with balls.
[[nodiscard]] double ball_force_at(BearingMap const& map, double angle, int sectors);

/// Largest difference between the forces of the balls of two grids; of a line, interpolated between its points. Unlike
/// the difference of the two peaks it is not small by chance.
[[nodiscard]] double ball_distance(BearingMap const& fine, BearingMap const& coarse, int sectors);

}  // namespace hdconj::load
