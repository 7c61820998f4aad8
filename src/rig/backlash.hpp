// SPDX-License-Identifier: GPL-3.0-or-later
// The backlash of a loop with friction.
#pragma once

#include <optional>

#include "branches.hpp"
#include "fits.hpp"

namespace hdconj::rig {

/// The jump of the angle from one side of the backlash to the other.
struct Jump
{
    Found height;        ///< [rad]
    bool seen = false;   ///< noise would not make it; else the height at the torque of the friction
    double engaged = 0;  ///< torque of the first sample beyond it, without sign [N mm]
};

/// Torque about which the loop is symmetric: the reading of a sensor that is not loaded [N mm].
///
/// The angle jumps by the backlash at this torque plus the friction on the way up and minus it on the way down. Where
/// two thirds of the branches of each sense that pass a torque jump there, by more than noise makes, it is the mean of
/// both torques. It is 0 where that is less than half of @p window, where jump_of_play() finds the jump anyway, and
/// where there are no such jumps.
/// @param window  how far lines reach to either side of a jump [N mm]
[[nodiscard]] double unloaded_torque(Samples const& samples, std::vector<LoadBranch> const& branches, double window,
                                     Noise const& noise);

/// The jump of the angle where a branch passes from one side of the backlash to the other [rad, positive].
///
/// With Coulomb friction T_f the elastic torque is T - T_f on the way up, so that the drive crosses the backlash at
/// T = T_f, not at zero, and the loop at zero torque is wider than the backlash by twice T_f over the stiffness. The
/// jump itself is the backlash, whatever the friction. It is looked for from zero to the friction and somewhat beyond:
/// where two parallel lines, of the samples within @p window to either side, are
/// furthest apart. The lines are then fitted to the samples about that place (about zero, where it is less than a
/// quarter of the window away), one below the jump and one above; the jump is put between the two samples that leave
/// the least squares.
///
/// The largest of many heights is no estimate of a small one: noise alone has a positive maximum, and where the curve
/// bends the lines differ by a negative height. A height below five of its standard errors is therefore taken at the
/// torque where the backlash is crossed, which is the friction: the height of two lines at a known place is without
/// bias.
///
/// Samples below @p no_load [N mm] are left out: without load the drive may lie anywhere in its backlash.
/// @param friction  as friction_torque() finds it [N mm]
/// @param window  up to where a branch is a straight line to either side of its jump [N mm]
/// @returns nothing where the branch does not pass through all of these torques, or has fewer than three samples on
/// either side there
[[nodiscard]] std::optional<Jump> jump_of_play(Samples const& samples, LoadBranch const& branch, double friction,
                                               double window, double no_load, Noise const& noise);

}  // namespace hdconj::rig
