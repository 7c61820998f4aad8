// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact_cells.hpp"
#include "figures/contact_figures.hpp"
#include "hdconj/units.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

double smallest_along(GapMap const& map, std::size_t space, int flank, std::size_t slice)
{
    auto const begin = map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(space, flank, slice, 0));
    return *std::min_element(begin, begin + static_cast<std::ptrdiff_t>(map.station.size()));
}

PlotColumns map_cells(GapMap const& map, int flank, GapBands const& bands, std::vector<double> const& z)
{
    std::vector<std::size_t> spaces(map.angle.size());  // by their angle
    std::iota(spaces.begin(), spaces.end(), std::size_t{0});
    std::sort(spaces.begin(), spaces.end(), [&](auto a, auto b) { return map.angle[a] < map.angle[b]; });
    std::vector<double> middles;
    for (std::size_t const space : spaces)
        middles.push_back(map.angle[space] * per_deg);
    constexpr double half_turn = 180;  // [deg]
    return merged_cells(cell_borders(middles, -half_turn, half_turn), z, [&](std::size_t i, std::size_t k) {
        return GapBands::colour(bands.band_of(smallest_along(map, spaces[i], flank, k)));
    });
}

}  // namespace

std::vector<double> cell_borders(std::vector<double> const& at, double first, double last)
{
    std::vector<double> borders = {first};
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
        borders.push_back((at[i] + at[i + 1]) / 2);
    borders.push_back(last);
    return borders;
}

PlotColumns merged_cells(std::vector<double> const& x, std::vector<double> const& y,
                         std::function<int(std::size_t, std::size_t)> const& colour_of)
{
    PlotColumns cells;
    for (std::size_t k = 0; k + 1 < y.size(); ++k) {
        std::size_t begin = 0;
        int colour = colour_of(0, k);
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            bool const last = i + 2 == x.size();
            int const next = last ? colour : colour_of(i + 1, k);
            if (last || next != colour) {
                cells.row(x[begin], x[i + 1], y[k], y[k + 1], colour);
                begin = i + 1;
                colour = next;
            }
        }
    }
    return cells;
}

PlotData shown_flank_data(ContactStudy const& study, io::FlankOfMap const& flank)
{
    std::string heading = study.solution.scene.drive.name;
    if (study.written_case < study.cases.size()) {
        auto const& each = study.cases[study.written_case];
        heading +=
            fmt::format(":  {},  side clearance {:.3g} µm", figures::case_name(each), each.backlash_offset * per_um);
    }
    PlotData data(heading);
    data.set("right_flank", flank.flank == GapMap::right);
    data.set("angle", study.map.angle[flank.space] * per_deg);
    data.set("in_contact", flank.in_contact);
    GapBands(study.contact_gap, study.solution.scene.solver.tolerance).set_in(data);
    return data;
}

std::string map_script(ContactStudy const& study)
{
    auto const& map = study.map;
    // A single slice stands for the width of the circular spline.
    double const half = map.z.size() == 1 ? study.solution.scene.circular_spline.width.value_or(1) / 2 : 0;
    auto const z = cell_borders(map.z, map.z.front() - half, map.z.back() + half);
    GapBands const bands(study.contact_gap, study.solution.scene.solver.tolerance);
    PlotData data = shown_flank_data(study, io::fullest_flank(map, study.contact_gap));
    if (study.written_case < study.cases.size()) {
        constexpr double steps = 1000;  // of a degree
        double const angle = std::round(study.cases[study.written_case].state.wave_generator * per_deg * steps) / steps;
        data.set("wave_generator", angle == 0 ? 0.0 : angle);  // never "-0"
    }
    data.set("z_low", z.front());
    data.set("z_high", z.back());
    data.set("right", map_cells(map, GapMap::right, bands, z));
    data.set("left", map_cells(map, GapMap::left, bands, z));
    return plot_script("contact_map", data);
}

}  // namespace hdconj::report
