// SPDX-License-Identifier: GPL-3.0-or-later
// Between which limits `solver.tolerance` may lie.
#pragma once

#include <limits>

#include "hdconj/scene.hpp"

namespace hdconj::scene {

/// Pitch radius of the flexspline, m z_f/2 [mm].
[[nodiscard]] inline double flexspline_pitch_radius(Drive const& drive)
{
    return drive.module * drive.flexspline_teeth / 2;
}

/// A tolerance above a tenth of the module says nothing about a tooth [mm].
[[nodiscard]] inline double largest_tolerance(Drive const& drive)
{
    return drive.module / 10;
}

/// Tolerances below so many roundings of the pitch radius cannot be reached in double precision [mm].
[[nodiscard]] inline double least_tolerance(Drive const& drive)
{
    constexpr double roundings_of_radius = 100;
    return roundings_of_radius * std::numeric_limits<double>::epsilon() * flexspline_pitch_radius(drive);
}

}  // namespace hdconj::scene
