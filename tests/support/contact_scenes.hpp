// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Keys of scenes with slices and tilts, and the case that a study of contact is of where it has one.
#pragma once

#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "coned_drive.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/units.hpp"

namespace hdconj::test {

inline constexpr double degree = std::numbers::pi / 180;

using Keys = std::vector<std::string>;

inline std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

inline Keys sliced(int count, std::string const& surface)
{
    return {"slices.count=" + std::to_string(count), "slices.surface=" + surface};
}

inline Keys tilted(double angle_deg, std::string const& kind = "radial")
{
    return {"tilt.angle_deg=" + number(angle_deg), "tilt.kind=" + kind};
}

/// Few enough points that a study takes a tenth of a second.
inline Keys small(Keys const& more)
{
    return with({"contact.flank_points=60"}, more);
}

inline ContactCase only_case(Scene const& scene, ContactOptions const& options = {})
{
    return study_contact(scene, options).cases.front();
}

}  // namespace hdconj::test
