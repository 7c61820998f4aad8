// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places of the contacts of an elastic drive; private to src/load.
#pragma once

#include <cstddef>
#include <vector>

#include "elastic_drive.hpp"

namespace hdconj::load {

/// A flank contact as components at the stations of the cup.
struct Footing
{
    int at;                  ///< grid angle of the tooth
    std::size_t station[3];  ///< radial, tangential and turn of the slice
    double share[3];         ///< component of a unit force along the normal at each
};

[[nodiscard]] Footing footing(ElasticDrive const& drive, FlankContact const& c);

/// A place at which the wave generator may press.
struct BearingNode
{
    std::size_t height;  ///< index into ElasticDrive::bearing_z
    std::size_t angle;   ///< index into ElasticDrive::bearing_steps
    int at;              ///< grid angle
};
/// All of them, heights within angles.
[[nodiscard]] std::vector<BearingNode> bearing_nodes(ElasticDrive const& drive);

}  // namespace hdconj::load
