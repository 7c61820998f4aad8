// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_area.hpp"

#include <algorithm>

namespace hdconj::contact {
namespace {

/// 0, stride, 2 stride, ... and the last index.
std::vector<std::size_t> every(std::size_t stride, std::size_t count)
{
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < count; i += stride)
        chosen.push_back(i);
    if (chosen.back() != count - 1)
        chosen.push_back(count - 1);
    return chosen;
}

}  // namespace

ContactArea contact_area(GapMap const& map, FlankGrid const& grid, int flank, double limit, double width,
                         std::size_t stride)
{
    std::vector<std::size_t> const points = every(stride, grid.points());
    std::vector<std::size_t> const slices = every(stride, grid.slices());
    auto const& line = grid.point[static_cast<std::size_t>(flank)];
    // one slice is a strip between two copies of itself
    bool const strip = slices.size() == 1;
    ContactArea result;
    double whole = 0;  // of each space: all have the same flanks
    for (std::size_t space = 0; space < map.angle.size(); ++space) {
        double contact = 0;
        for (std::size_t i = 0; i + 1 < (strip ? 2 : slices.size()); ++i) {
            std::size_t const low = slices[i];
            std::size_t const high = strip ? low : slices[i + 1];
            double const z_low = strip ? -width / 2 : grid.z[low];
            double const z_high = strip ? width / 2 : grid.z[high];
            double const* const gap_low = map.gap.data() + map.index(space, flank, low, 0);
            double const* const gap_high = map.gap.data() + map.index(space, flank, high, 0);
            auto const corner = [&](std::size_t slice, double z, double gap, std::size_t point) {
                Vec2 const& p = line[slice][point];
                return AreaCorner{{p.x(), p.y(), z}, gap - limit};
            };
            for (std::size_t j = 0; j + 1 < points.size(); ++j) {
                std::size_t const a = points[j], b = points[j + 1];
                bool const apart = std::min({gap_low[a], gap_low[b], gap_high[a], gap_high[b]}) > limit;
                double of_space = 0;
                if (space == 0 || !apart)
                    add_cell({corner(low, z_low, gap_low[a], a), corner(low, z_low, gap_low[b], b),
                              corner(high, z_high, gap_high[b], b), corner(high, z_high, gap_high[a], a)},
                             contact, space == 0 ? whole : of_space);
            }
        }
        result.contact += contact;
        result.whole += whole;
        result.spaces += contact > 0 ? 1 : 0;
    }
    return result;
}

}  // namespace hdconj::contact
