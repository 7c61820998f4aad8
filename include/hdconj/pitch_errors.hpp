// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pitch errors of both rings, tooth by tooth.
#pragma once

#include <vector>

namespace hdconj {

/// Where the teeth of both rings stand beside their places along the pitch circle, clockwise, from tooth and space 0 on
/// [mm]; empty: on them.
struct PitchErrors
{
    std::vector<double> flexspline;       ///< of its teeth
    std::vector<double> circular_spline;  ///< of its tooth spaces, each with both flanks
};

}  // namespace hdconj
