// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where the contacts of an elastic drive stand; private to src/load.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/load/elastic_drive.hpp"

namespace hdconj::detail {

/// A flank contact as components of stations.
struct Footing
{
    int at;
    std::size_t station[3];
    double share[3];
};

[[nodiscard]] Footing footing(ElasticDrive const& drive, FlankContact const& c);

/// A place at which the wave generator may press.
struct BearingNode
{
    std::size_t height;  ///< which of ElasticDrive::bearing_z
    std::size_t angle;   ///< which of ElasticDrive::bearing_steps
    int at;              ///< and that
};
/// In the order of ElasticDrive::balls: heights within angles.
[[nodiscard]] std::vector<BearingNode> bearing_nodes(ElasticDrive const& drive);

}  // namespace hdconj::detail
