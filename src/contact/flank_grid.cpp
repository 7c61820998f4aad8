// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact/flank_grid.hpp"

#include <algorithm>

#include "hdconj/contact/gap_map.hpp"

namespace hdconj {

FlankGrid flank_grid(MatchedOutline const& outline, std::vector<double> const& z, int count)
{
    FlankGrid grid;
    grid.z = z;
    std::size_t const middle = z.size() / 2;
    auto const& line = outline.points[middle];
    std::size_t const left_land = outline.landmarks[0], left_end = outline.landmarks[1];
    std::size_t const right_end = outline.landmarks[3], right_land = outline.landmarks[4];
    // lengths along the right flank, from the land corner down; the left one has the mirror image's indices where the outline is symmetric
    std::vector<std::size_t> right_index, left_index;
    auto const choose = [&](std::size_t from, std::size_t to, std::vector<std::size_t>& chosen) {
        std::ptrdiff_t const step = to > from ? 1 : -1;
        std::vector<double> length{0};
        for (auto i = static_cast<std::ptrdiff_t>(from); i != static_cast<std::ptrdiff_t>(to); i += step)
            length.push_back(length.back() + (line[static_cast<std::size_t>(i + step)] - line[static_cast<std::size_t>(i)]).norm());
        std::vector<double> stations;
        for (int j = 0; j < count; ++j)
        {
            double const wanted = length.back() * j / (count - 1);
            auto const after = std::lower_bound(length.begin(), length.end(), wanted) - length.begin();
            auto const at = std::min<std::ptrdiff_t>(after, static_cast<std::ptrdiff_t>(length.size()) - 1);
            auto const best = at > 0 && wanted - length[static_cast<std::size_t>(at - 1)] < length[static_cast<std::size_t>(at)] - wanted ? at - 1 : at;
            auto const index = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + step * best);
            if (!chosen.empty() && chosen.back() == index)
                continue;
            chosen.push_back(index);
            stations.push_back(length[static_cast<std::size_t>(best)] / length.back());
        }
        return stations;
    };
    grid.station = choose(right_land, right_end, right_index);
    (void)choose(left_land, left_end, left_index);
    // an asymmetric pair's flanks may differ in their number of points: the shorter list decides
    std::size_t const points = std::min(right_index.size(), left_index.size());
    grid.station.resize(points);
    for (int const flank : {GapMap::left, GapMap::right})
    {
        auto const& index = flank == GapMap::right ? right_index : left_index;
        auto& point = grid.point[static_cast<std::size_t>(flank)];
        auto& normal = grid.normal[static_cast<std::size_t>(flank)];
        point.resize(z.size());
        normal.resize(z.size());
        for (std::size_t k = 0; k < z.size(); ++k)
        {
            for (std::size_t j = 0; j < points; ++j)
            {
                std::size_t const i = j + 1 == points ? index.back() : index[j];
                point[k].push_back(outline.points[k][i]);
                normal[k].push_back(outline.normals[k][i]);
            }
        }
    }
    return grid;
}

FlankGrid moved_into_material(FlankGrid grid, double offset)
{
    for (std::size_t flank = 0; flank < 2; ++flank)
        for (std::size_t k = 0; k < grid.slices(); ++k)
            for (std::size_t i = 0; i < grid.points(); ++i)
                grid.point[flank][k][i] += offset * grid.normal[flank][k][i];
    return grid;
}

}  // namespace hdconj
