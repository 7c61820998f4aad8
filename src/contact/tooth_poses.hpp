// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where all flexspline teeth are at one angle of the wave generator, slice by slice.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::contact {

/// Teeth `first` ... of a drive: tooth i has the undeformed angle phi_i = 2 pi i / z_f + phase, and its pose is given
/// in the frame of tooth space i, whose centre line is at (z_f/z_c) phi_i from the major axis. Going on over the ends
/// of a turn, tooth i + z_f is tooth i.
struct ToothPoses
{
    int first = 0;
    std::size_t slices = 0;
    std::vector<Pose> pose;  ///< (teeth, slices)

    [[nodiscard]] Pose const& at(int tooth, std::size_t slice) const
    {
        return pose[static_cast<std::size_t>(tooth - first) * slices + slice];
    }
};

}  // namespace hdconj::contact
