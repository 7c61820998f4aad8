// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact_cells.hpp"
#include "figures/load_figures.hpp"
#include "hdconj/units.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

/// A flank of one tooth space.
struct LoadedFlank
{
    int space = 0, flank = GapMap::right;
    double force = 0;  ///< all over the face width [N]
};

LoadedFlank worst_flank(LoadMap const& map)
{
    LoadedFlank worst;
    for (std::size_t s = 0; s < map.angle.size(); ++s)
        for (int const flank : {GapMap::left, GapMap::right}) {
            double force = 0;
            for (std::size_t k = 0; k < map.z.size(); ++k)
                force += map.force[map.index(s, flank, k)];
            if (force > worst.force)
                worst = {static_cast<int>(s), flank, force};
        }
    return worst;
}

/// Hertz: largest pressure of a strip of half width a under the line load q [MPa].
double largest_pressure(double q, double a)
{
    return a > 0 ? 2 * q / (std::numbers::pi * a) : 0;
}

}  // namespace

bool has_loaded_flank(LoadStudy const& study)
{
    auto const* shown = figures::shown_case(study);
    return shown != nullptr && !shown->contacts.empty() && worst_flank(shown->map).force > 0;
}

std::string load_flank_script(LoadStudy const& study)
{
    LoadCase const& shown = *figures::shown_case(study);
    LoadMap const& map = shown.map;
    Scene const& scene = study.solution.scene;
    LoadedFlank const worst = worst_flank(map);
    double const pitch_radius = scene.drive.module * scene.drive.circular_spline_teeth / 2;
    double const tip = pitch_radius - shown.tip;
    PairGeometry const& geometry = study.solution.geometry;
    double root = pitch_radius - geometry.circular_spline_inner_radius - geometry.space_depth;
    double const half = map.z.size() > 1 ? 0 : scene.circular_spline.width.value_or(1) / 2;
    auto const border = cell_borders(map.z, map.z.front() - half, map.z.back() + half);
    constexpr double end_zone = 0.5;  // mm at each end of the width where pressures are not determined

    std::vector<ContactForce const*> contacts;
    for (ContactForce const& each : shown.contacts)
        if (each.space == worst.space && each.flank == worst.flank)
            contacts.push_back(&each);
    auto const pressure_of = [&](ContactForce const& c) {
        auto const k = static_cast<std::size_t>(c.slice);
        return largest_pressure(c.force / (border[k + 1] - border[k]), c.half_width);
    };
    double most = 0;
    for (ContactForce const* each : contacts)
        most = std::max(most, pressure_of(*each));
    ColourScale const scale(most);
    PlotColumns strips, sure, unsure, load;
    for (ContactForce const* each : contacts) {
        auto const k = static_cast<std::size_t>(each->slice);
        double const radius = each->place.norm(), height = pitch_radius - radius, pressure = pressure_of(*each);
        // the strip lies along the flank, across its normal
        double const reach = each->half_width * std::abs(cross(each->normal, each->place)) / radius;
        root = std::min(root, height - reach);
        strips.row(height - reach, height + reach, border[k], border[k + 1], scale.colour(scale.band_of(pressure)));
        bool const on_edge = tip - height < study.edge_radius;
        bool const at_end = std::min(map.z[k] - map.z.front(), map.z.back() - map.z[k]) < end_zone;
        (on_edge || at_end ? unsure : sure).row(map.z[k], pressure);
    }
    double most_load = 0;
    for (std::size_t k = 0; k < map.z.size(); ++k) {
        double const here = map.line_load[map.index(static_cast<std::size_t>(worst.space), worst.flank, k)];
        most_load = std::max(most_load, here);
        load.row(map.z[k], here, border[k + 1] - border[k]);
    }
    PlotData data(shown_load(study));
    data.set("angle", map.angle[static_cast<std::size_t>(worst.space)] * per_deg);
    data.set("right_flank", worst.flank == GapMap::right);
    data.set("force", worst.force);
    data.set("most", most);
    data.set("most_load", most_load);
    data.set("height_low", root);
    data.set("height_high", tip);
    data.set("z_low", border.front());
    data.set("z_high", border.back());
    data.set("strips", strips);
    data.set("sure", sure);
    data.set("unsure", unsure);
    data.set("load", load);
    scale.set_in(data, "pressure [MPa]", "");
    return plot_script("load_flank", data);
}

}  // namespace hdconj::report
