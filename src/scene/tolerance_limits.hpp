// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of `solver.tolerance` and of other small lengths.
#pragma once

#include <cmath>
#include <limits>

#include "hdconj/scene.hpp"

namespace hdconj::scene {

/// Pitch radius of the flexspline, m z_f/2 [mm].
[[nodiscard]] inline double flexspline_pitch_radius(Drive const& drive)
{
    return drive.module * drive.flexspline_teeth / 2;
}

/// A tenth of the module [mm]: the largest tolerance, contact gap or relief that is accepted. It is the next larger
/// number, because 0.35/10 is rounded to less than 0.035.
[[nodiscard]] inline double tenth_of_module(Drive const& drive)
{
    return std::nextafter(drive.module / 10, drive.module);
}

/// Tolerances below so many roundings of the pitch radius cannot be reached in double precision [mm].
[[nodiscard]] inline double least_tolerance(Drive const& drive)
{
    constexpr double roundings_of_radius = 100;
    return roundings_of_radius * std::numeric_limits<double>::epsilon() * flexspline_pitch_radius(drive);
}

}  // namespace hdconj::scene
