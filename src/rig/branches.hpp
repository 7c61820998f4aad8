// SPDX-License-Identifier: GPL-3.0-or-later
// The branches of a load cycle: samples between two turning points of the torque.
#pragma once

#include <cstddef>
#include <vector>

namespace hdconj::rig {

/// Readings of a rig in the order in which they were taken.
struct Samples
{
    std::vector<double> time;    ///< number of the reading from the middle of the log on
    std::vector<double> twist;   ///< [rad]
    std::vector<double> torque;  ///< [N mm]
};

/// Samples from one turning point of the torque to the next, both included.
struct LoadBranch
{
    std::size_t first = 0, last = 0;
    bool rising = false;
};

/// Turning points are extremes from which the torque comes back by more than @p reversal [N mm].
[[nodiscard]] std::vector<LoadBranch> branches_of(std::vector<double> const& torque, double reversal);

/// Positions of the readings of a branch, by ascending torque.
[[nodiscard]] std::vector<std::size_t> by_torque(Samples const& samples, LoadBranch const& branch);

}  // namespace hdconj::rig
