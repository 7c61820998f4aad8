// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "contact_cells.hpp"
#include "hdconj/units.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

double force_on(LoadMap const& map, std::size_t space, int flank)
{
    double sum = 0;
    for (std::size_t k = 0; k < map.z.size(); ++k)
        sum += map.force[map.index(space, flank, k)];
    return sum;
}

/// The flank that carries more.
int loaded_flank(LoadMap const& map)
{
    double left = 0, right = 0;
    for (std::size_t s = 0; s < map.angle.size(); ++s) {
        left += force_on(map, s, GapMap::left);
        right += force_on(map, s, GapMap::right);
    }
    return left > right ? GapMap::left : GapMap::right;
}

/// Sets the forces on each tooth; @p angle holds the borders of the spaces.
void set_forces(PlotData& data, LoadMap const& map, int flank, std::vector<double> const& angle)
{
    int const other = flank == GapMap::right ? GapMap::left : GapMap::right;
    PlotColumns forces;
    double most = 0, least = 0;
    for (std::size_t s = 0; s < map.angle.size(); ++s) {
        double const here = force_on(map, s, flank), there = -force_on(map, s, other);
        most = std::max(most, here);
        least = std::min(least, there);
        forces.row(map.angle[s] * per_deg, here, there, angle[s + 1] - angle[s]);
    }
    data.set("forces", forces);
    data.set("most", most);
    data.set("least", least);
}

}  // namespace

std::string load_pressure_script(LoadStudy const& study)
{
    auto const& shown = *figures::shown_case(study);
    auto const& map = shown.map;
    int const flank = loaded_flank(map);
    std::vector<double> middles;
    for (double const at : map.angle)
        middles.push_back(at * per_deg);
    double const half_pitch = middles.size() > 1 ? (middles[1] - middles[0]) / 2 : 180.0 / std::max(1, study.sectors);
    auto const angle = cell_borders(middles, middles.front() - half_pitch, middles.back() + half_pitch);
    double const half = map.z.size() > 1 ? 0 : study.solution.scene.circular_spline.width.value_or(1) / 2;
    auto const z = cell_borders(map.z, map.z.front() - half, map.z.back() + half);
    auto const line_load = [&](std::size_t s, std::size_t k) { return map.line_load[map.index(s, flank, k)]; };
    std::size_t space = 0, slice = 0;  // of the largest
    for (std::size_t s = 0; s < map.angle.size(); ++s) {
        for (std::size_t k = 0; k < map.z.size(); ++k) {
            if (line_load(s, k) > line_load(space, slice)) {
                space = s;
                slice = k;
            }
        }
    }
    ColourScale const scale(line_load(space, slice));
    PlotColumns peak;
    if (line_load(space, slice) > 0)
        peak.row(middles[space], (z[slice] + z[slice + 1]) / 2, line_load(space, slice));
    PlotData data(shown_load(study));
    data.set("right_flank", flank == GapMap::right);
    data.set("sectors", study.sectors);
    data.set("angle_low", angle.front());
    data.set("angle_high", angle.back());
    data.set("z_low", z.front());
    data.set("z_high", z.back());
    data.set("cells", merged_cells(angle, z, [&](std::size_t s, std::size_t k) {
                 return scale.colour(scale.band_of(line_load(s, k)));
             }));
    data.set("peak", peak);
    set_forces(data, map, flank, angle);
    scale.set_in(data, "line load [N/mm]", "no force");
    return plot_script("load_pressure", data);
}

}  // namespace hdconj::report
