// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The tooth at instants spread over the lobe, as it is drawn.
#pragma once

#include <vector>

#include "hdconj/motion/any_motion.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::conjugate {

/// Adds the tooth at 41 instants from one end of the lobe to the other to @p family, as polygons, each moved by -@p
/// down along y [mm].
inline void add_positions(profile::Profile const& tooth, motion::AnyMotion const& motion, double down,
                          std::vector<std::vector<Vec2>>& family)
{
    constexpr int positions = 40;
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, (tooth.addendum + tooth.dedendum) * 0x1p-10);
    for (int i = 0; i <= positions; ++i) {
        Pose const pose = motion.pose(motion.half_lobe() * (2.0 * i / positions - 1));
        std::vector<Vec2> placed;
        placed.reserve(polygon.size());
        for (Vec2 const& p : polygon)
            placed.push_back(pose(p) - Vec2(0, down));
        family.push_back(std::move(placed));
    }
}

}  // namespace hdconj::conjugate
