// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "colour_bands.hpp"
#include "hdconj/units.hpp"
#include "plot_window.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

/// A node displaced by a multiple of its displacement at an angle; x is the radius, y the place along the axis.
Vec2 moved_node(CupShape const& shape, std::size_t node, std::size_t angle, double multiple)
{
    std::size_t const at = angle * shape.r.size() + node;
    return {shape.r[node] + multiple * shape.u_r[at], shape.z[node] + multiple * shape.u_z[at]};
}

void take_nodes(PlotWindow& window, CupShape const& shape, std::size_t angle, double multiple)
{
    for (std::size_t p = 0; p < shape.r.size(); ++p)
        window.take(moved_node(shape, p, angle, multiple));
}

/// Adds some air, then widens the shorter side until both axes have the same scale.
void fit_panel(PlotWindow& window)
{
    constexpr double panel_width = 405, panel_height = 430;  // [px]
    constexpr double air = 0.04;
    double const around = 2 * air * std::max(window.width(), window.height());
    double const mm_per_px =
        std::max((window.width() + around) / panel_width, (window.height() + around) / panel_height);
    window.widen((mm_per_px * panel_width - window.width()) / 2, (mm_per_px * panel_height - window.height()) / 2);
}

/// Index of the angle next to @p wanted, a turn more or less being the same.
std::size_t angle_near(CupShape const& shape, double wanted)
{
    auto const off = [&](double phi) { return std::abs(std::remainder(phi - wanted, 2 * std::numbers::pi)); };
    auto const best =
        std::min_element(shape.phi.begin(), shape.phi.end(), [&](double a, double b) { return off(a) < off(b); });
    return static_cast<std::size_t>(best - shape.phi.begin());
}

/// Corners of an element as a closed polygon.
void add_cell(PlotColumns& columns, CupShape const& shape, std::vector<int> const& cell, std::size_t angle,
              double multiple)
{
    for (std::size_t i = 0; i <= cell.size(); ++i) {
        Vec2 const corner = moved_node(shape, static_cast<std::size_t>(cell[i % cell.size()]), angle, multiple);
        columns.row(corner.x(), corner.y());
    }
    columns.end_line();
}

PlotColumns section_cells(CupShape const& shape, std::size_t angle, double multiple)
{
    PlotColumns columns;
    for (auto const& cell : shape.cells)
        add_cell(columns, shape, cell, angle, multiple);
    return columns;
}

/// 1, 2 or 5 times a power of ten, no larger than @p value but for a little.
double round_multiple(double value)
{
    constexpr double a_little = 1.15;
    double const power = std::pow(10.0, std::floor(std::log10(value * a_little)));
    double const rest = value * a_little / power;
    return power * (rest >= 5 ? 5 : rest >= 2 ? 2 : 1);
}

/// In tenths of a degree, and never "-0".
double shown_degrees(double angle)
{
    constexpr double tenth = 10;
    double const rounded = std::round(angle * per_deg * tenth) / tenth;
    return rounded == 0 ? 0 : rounded;
}

/// The largest stress of each node over all angles.
std::vector<double> worst_stress(CupShape const& shape)
{
    std::vector<double> worst(shape.r.size(), 0.0);
    for (std::size_t i = 0; i < shape.stress.size(); ++i)
        worst[i % worst.size()] = std::max(worst[i % worst.size()], shape.stress[i]);
    return worst;
}

/// The corner of an element where it is largest and determined: what is drawn is what is named.
std::size_t worst_corner(CupShape const& shape, std::vector<double> const& worst)
{
    std::vector<bool> named(worst.size(), true);
    for (int const node : shape.seat)
        named[static_cast<std::size_t>(node)] = false;
    auto place = static_cast<std::size_t>(shape.cells.front().front());
    for (auto const& cell : shape.cells) {
        for (int const node : cell)
            if (auto const n = static_cast<std::size_t>(node); named[n] && worst[n] > worst[place])
                place = n;
    }
    return place;
}

/// Sets elements by the colour of their corners' mean.
void set_stress_cells(PlotData& data, CupShape const& shape, std::vector<double> const& worst, ColourScale const& scale)
{
    std::map<std::size_t, PlotColumns> by_band;
    for (auto const& cell : shape.cells) {
        double sum = 0;
        for (int const node : cell)
            sum += worst[static_cast<std::size_t>(node)];
        add_cell(by_band[scale.band_of(sum / static_cast<double>(cell.size()))], shape, cell, 0, 0);
    }
    PlotColumns colours, cells;
    for (auto const& [band, columns] : by_band) {
        colours.row(scale.colour(band));
        cells.append(columns);
        cells.end_index();
    }
    data.set("cells", cells);
    data.set("colours", colours);
}

}  // namespace

std::string load_cup_script(LoadStudy const& study)
{
    auto const& shape = study.shape;
    std::size_t const major = angle_near(shape, 0),
                      minor = angle_near(shape, std::numbers::pi / study.solution.scene.wave_generator.waves);
    PlotWindow window;
    take_nodes(window, shape, major, 0);
    double largest_move = 0;
    for (std::size_t const angle : {major, minor}) {
        for (std::size_t p = 0; p < shape.r.size(); ++p) {
            double const move = (moved_node(shape, p, angle, 1) - moved_node(shape, p, angle, 0)).norm();
            largest_move = std::max(largest_move, move);
        }
    }
    constexpr double shown_share = 0.08;  // of the cup, by the largest displacement
    double const size = std::max(window.width(), window.height());
    double const multiple = largest_move > 0 ? round_multiple(shown_share * size / largest_move) : 1;
    take_nodes(window, shape, major, multiple);
    take_nodes(window, shape, minor, multiple);
    fit_panel(window);
    PlotData data(shown_load(study));
    window.set_in(data);
    data.set("multiple", multiple);
    data.set("largest", largest_move * per_um);
    data.set("major_angle", shown_degrees(shape.phi[major]));
    data.set("minor_angle", shown_degrees(shape.phi[minor]));
    data.set("made", section_cells(shape, major, 0));
    data.set("major", section_cells(shape, major, multiple));
    data.set("minor", section_cells(shape, minor, multiple));
    return plot_script("load_cup", data);
}

std::string load_stress_script(LoadStudy const& study)
{
    auto const& shape = study.shape;
    auto const worst = worst_stress(shape);
    std::size_t const node = worst_corner(shape, worst);
    ColourScale const scale(worst[node]);
    PlotWindow window;
    take_nodes(window, shape, 0, 0);
    fit_panel(window);
    PlotColumns around, place;
    for (std::size_t a = 0; a < shape.phi.size(); ++a)
        around.row(shape.phi[a] * per_deg, shape.stress[a * shape.r.size() + node]);
    place.row(shape.r[node], shape.z[node]);
    PlotData data(shown_load(study));
    window.set_in(data);
    data.set("largest", worst[node]);
    data.set("around", around);
    data.set("place", place);
    set_stress_cells(data, shape, worst, scale);
    scale.set_in(data, "stress [MPa]", "");
    return plot_script("load_stress", data);
}

}  // namespace hdconj::report
