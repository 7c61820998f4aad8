// SPDX-License-Identifier: GPL-3.0-or-later
// What each branch of a load cycle says: angle without load, stiffness, the jump by the backlash.
#pragma once

#include <vector>

#include "branches.hpp"
#include "extrapolation.hpp"
#include "fits.hpp"
#include "found.hpp"

namespace hdconj::rig {

/// What all branches share.
struct BranchLimits
{
    double loaded = 0;       ///< torque that a branch of a load cycle reaches [N mm]
    Reach reach;             ///< of the lines about the backlash
    double engaged = 0;      ///< torque from which the flanks touch in every loading branch [N mm]
    double drift_error = 0;  ///< standard error of the drift [rad per reading]
    Noise noise;
};

/// What all branches say.
struct BranchFigures
{
    std::vector<Found> first, second, knee, whole;     ///< of loading branches
    std::vector<ByCurve> positive, negative;           ///< angles at zero torque of unloading branches, by side
    std::vector<double> positive_time, negative_time;  ///< when the load was off
    std::vector<ByCurve> jumps;                        ///< from one side of the backlash to the other
    int straight = 0;                                  ///< loading branches without a bend
};

/// All branches.
/// @param friction  as friction_torque() finds it [N mm]
[[nodiscard]] BranchFigures branch_figures(Samples const& samples, std::vector<LoadBranch> const& branches,
                                           Found const& friction, BranchLimits limits);

}  // namespace hdconj::rig
