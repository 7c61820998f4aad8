// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_places.hpp"

namespace hdconj::load {
namespace {

int grid_of(ElasticDrive const& drive, FlankContact const& c)
{
    int const grid = drive.response.grid();
    int const at = c.tooth * drive.steps_per_tooth % grid;
    return at < 0 ? at + grid : at;
}

}  // namespace

Footing footing(ElasticDrive const& drive, FlankContact const& c)
{
    DriveStations const& s = drive.stations;
    return {grid_of(drive, c), {s.radial(c.slice), s.tangential(c.slice), s.turn(c.slice)}, {c.c_r, c.c_t, c.c_turn}};
}

std::vector<BearingNode> bearing_nodes(ElasticDrive const& drive)
{
    std::vector<BearingNode> nodes;
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w)
        for (std::size_t j = 0; j < drive.stations.bearing; ++j)
            nodes.push_back({j, w, drive.bearing_steps[w]});
    return nodes;
}

}  // namespace hdconj::load
