// SPDX-License-Identifier: GPL-3.0-or-later
// The backlash of a loop with friction.
#pragma once

#include <optional>

#include "branches.hpp"
#include "found.hpp"

namespace hdconj::rig {

/// The jump of the angle from one side of the backlash to the other.
struct Jump
{
    Found height;        ///< [rad]
    bool seen = false;   ///< noise would not make it
    double engaged = 0;  ///< torque of the first sample beyond it, without sign [N mm]
};

/// The jump of the angle where a branch passes from one side of the backlash to the other [rad, positive].
///
/// With Coulomb friction T_f the elastic torque is T - T_f on the way up, so that the drive crosses the backlash at
/// T = T_f, not at zero, and the loop at zero torque is wider than the backlash by twice T_f over the stiffness. The
/// jump itself is the backlash, whatever the friction. Two parallel lines are fitted to the samples with
/// |T| <= measured_at::near_zero of the largest torque, one below the jump and one above; the jump is put between the
/// two samples that leave the least squares. Samples below measured_at::no_load are left out: without load the drive
/// may lie anywhere in its backlash.
/// @returns nothing where the branch does not pass through all of these torques, or has fewer than three samples of
/// either sign there
[[nodiscard]] std::optional<Jump> jump_at_zero(Samples const& samples, LoadBranch const& branch, double largest_torque);

}  // namespace hdconj::rig
