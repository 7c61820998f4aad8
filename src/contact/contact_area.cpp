// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_area.hpp"

namespace hdconj::contact {

ContactArea contact_area(GapMap const& map, FlankGrid const& grid, int flank, double limit, double width)
{
    auto const& line = grid.point[static_cast<std::size_t>(flank)];
    // one slice is a strip between two copies of itself
    bool const strip = grid.slices() == 1;
    ContactArea result;
    double whole = 0;  // of each space: all have the same flanks
    for (std::size_t space = 0; space < map.angle.size(); ++space) {
        double contact = 0;
        for (std::size_t low = 0; low + (strip ? 0 : 1) < grid.slices(); ++low) {
            std::size_t const high = strip ? low : low + 1;
            double const z_low = strip ? -width / 2 : grid.z[low];
            double const z_high = strip ? width / 2 : grid.z[high];
            double const* const gap_low = map.gap.data() + map.index(space, flank, low, 0);
            double const* const gap_high = map.gap.data() + map.index(space, flank, high, 0);
            auto const corner = [&](std::size_t slice, double z, double gap, std::size_t point) {
                Vec2 const& p = line[slice][point];
                return AreaCorner{{p.x(), p.y(), z}, gap - limit};
            };
            for (std::size_t a = 0, b = 1; b < grid.points(); ++a, ++b) {
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
