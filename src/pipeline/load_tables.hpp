// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a settled torque is told as.
#pragma once

#include "hdconj/pipeline/load_study.hpp"
#include "load_settle.hpp"

namespace hdconj::detail {

/// Figures of one torque. @param middle  turn that twist is counted from [rad]
[[nodiscard]] LoadedState summary_of(LoadWork const& work, Loaded const& loaded, double torque, double middle);

/// The ball that is pressed most.
struct BallPeak
{
    double force = 0;  ///< [N], of a line [N/mm]
    double phi = 0;    ///< [rad]
    int carrying = 0;  ///< single balls that push, all round
};
[[nodiscard]] BallPeak ball_peak(ElasticDrive const& drive, Equilibrium const& state);

/// Forces between bearing and cup, and of the balls.
[[nodiscard]] BearingMap bearing_map(ElasticDrive const& drive, Equilibrium const& state);

/// Resultant over the lobe at the major axis: along it, across it (clockwise) [N], and its height [mm]. A force between two lobes is half of either.
struct LobeReaction
{
    double along = 0, across = 0, z = 0;
};
[[nodiscard]] LobeReaction lobe_reaction(BearingMap const& bearing, int sectors, int waves);

/// Forces over space, flank and slice.
[[nodiscard]] LoadMap map_of(LoadWork const& work, Loaded const& loaded, double torque);

/// Largest distance between the forces of the balls of two grids, of a line between its points. Unlike that of their peaks it is not small by chance.
[[nodiscard]] double ball_distance(BearingMap const& fine, BearingMap const& coarse, int sectors);

}  // namespace hdconj::detail
