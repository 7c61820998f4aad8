// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

#include "hdconj/units.hpp"
#include "report/plots/contact_cells.hpp"
#include "static_axes.hpp"

namespace hdconj::report {
namespace static_cells {  // many sources are one translation unit
namespace {

constexpr double largest_shown = 20 * um, interference = 0.01 * um;

/// Cividis in its light form, as web/src/dom.js has it: a small gap is dark, a large one light, interference vermilion.
std::string colour_of(double gap)
{
    constexpr std::array<std::array<int, 3>, 6> cividis{
        {{0, 32, 77}, {49, 68, 107}, {102, 105, 112}, {149, 144, 120}, {203, 186, 105}, {255, 234, 70}}};
    if (gap < -interference)
        return "#d55e00";
    double const place = std::clamp(gap / largest_shown, 0.0, 1.0) * (cividis.size() - 1);
    auto const at = std::min(static_cast<std::size_t>(place), cividis.size() - 2);
    std::array<long, 3> mixed{};
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = std::lround(cividis[at][i] + (cividis[at + 1][i] - cividis[at][i]) * (place - double(at)));
    return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

}  // namespace
}  // namespace static_cells

std::string static_gap_maps(Json const& contact)
{
    using namespace static_cells;
    Json const map = group_at(contact, {"contact", "map"});
    std::vector<double> const angle = column_of(map, "angle", deg), z = column_of(map, "z"),
                              gap = column_of(map, "gap");
    std::size_t const flanks = angle.size() * 2 * z.size(), points = flanks > 0 ? gap.size() / flanks : 0;
    if (points == 0)
        return "";
    // Tooth spaces follow each other around the ring; slices end with the face width, of which one stands for 1 mm.
    double const half_pitch = angle.size() > 1 ? (angle[1] - angle[0]) / 2 : 0.5, half = z.size() > 1 ? 0 : 0.5;
    std::vector<double> const xs = cell_borders(angle, angle.front() - half_pitch, angle.back() + half_pitch),
                              ys = cell_borders(z, z.front() - half, z.back() + half);
    Axis const x = horizontal_axis(xs.front(), xs.back()), y = vertical_axis(ys.front(), ys.back());
    std::string html;
    for (std::size_t flank = 0; flank < 2; ++flank) {
        std::map<std::string, std::string> cells;  // a path for each colour
        for (std::size_t s = 0; s < angle.size(); ++s)
            for (std::size_t k = 0; k < z.size(); ++k) {
                auto const first = gap.begin() + static_cast<std::ptrdiff_t>(((s * 2 + flank) * z.size() + k) * points);
                double const smallest = *std::min_element(first, first + static_cast<std::ptrdiff_t>(points));
                fmt::format_to(std::back_inserter(cells[colour_of(smallest)]), "M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z",
                               x(xs[s]), y(ys[k]), x(xs[s + 1]), y(ys[k + 1]), x(xs[s]));
            }
        std::string drawing;
        for (auto const& [colour, path] : cells)
            drawing += fmt::format("<path fill=\"{}\" d=\"{}\"/>", colour, path);
        html += static_figure(
            fmt::format("Smallest gap of each flank, {} flank", flank == 0 ? "left" : "right"),
            drawing + axes_svg(x, y, "tooth space, degrees from the major axis", "z [mm]"),
            "<span>dark: touches</span><span>light: 20 um and more</span><span>vermilion: interference</span>");
    }
    return html;
}

}  // namespace hdconj::report
