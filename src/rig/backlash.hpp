// SPDX-License-Identifier: GPL-3.0-or-later
// The backlash of a loop with friction.
#pragma once

#include <optional>

#include "branches.hpp"
#include "extrapolation.hpp"
#include "fits.hpp"

namespace hdconj::rig {

/// The jump of the angle from one side of the backlash to the other.
struct Jump
{
    ByCurve heights;     ///< [rad]
    bool seen = false;   ///< noise would not make it; else the height at the torque of the friction
    double engaged = 0;  ///< torque from which the flanks touch, without sign [N mm]
};

/// Torque about which the loop is symmetric: the reading of a sensor that is not loaded [N mm].
///
/// The angle jumps by the backlash at this torque plus the friction on the way up and minus it on the way down. Where
/// two thirds of the branches of each sense that pass a torque jump there, by more than noise makes, it is the mean of
/// both torques. It is 0 where that is less than the gap of @p reach or than two readings are apart there, and where
/// there are no such jumps.
[[nodiscard]] double unloaded_torque(Samples const& samples, std::vector<LoadBranch> const& branches,
                                     Reach const& reach, Noise const& noise);

/// The jump of the angle where a branch passes from one side of the backlash to the other [rad, positive].
///
/// With Coulomb friction T_f the elastic torque is T - T_f on the way up, so that the drive crosses the backlash at
/// T = T_f, not at zero, and the loop at zero torque is wider than the backlash by twice T_f over the stiffness. The
/// jump itself is the backlash, whatever the friction. It is looked for from zero to the friction and somewhat beyond:
/// where two parallel lines are furthest apart, and about there between the two readings that leave the least squares.
/// Where the friction is within half the gap of @p reach from there, it is taken. Two parallel lines, and two
/// parabolas that half a turn lays onto each other, are then fitted to the readings beyond the gap, one below and one
/// above: nearer, a reading may lie anywhere in the backlash.
///
/// The largest of many heights is no estimate of a small one: noise alone has a positive maximum, and where the curve
/// bends the lines differ by a negative height. A height below five of its standard errors is therefore taken at the
/// torque where the backlash is crossed, which is the friction: the height of two lines at a known place is without
/// bias.
/// @param friction  as friction_torque() finds it [N mm]
/// @returns nothing where the branch does not pass through all of these torques, or has fewer than three readings on
/// either side within the reach, or fewer than two beyond the gap; nor where no clear height is found, and the friction
/// may be larger than all torques looked at
[[nodiscard]] std::optional<Jump> jump_of_play(Samples const& samples, LoadBranch const& branch, Found const& friction,
                                               Reach const& reach, Noise const& noise);

}  // namespace hdconj::rig
