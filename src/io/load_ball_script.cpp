// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "load_scripts.hpp"
#include "picture_frame.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 100;
constexpr double panel_height = 320;
constexpr double below_axis = 84;
constexpr double height = top + panel_height + below_axis;

constexpr char const* carrying_colour = "#0072b2";
constexpr char const* idle_colour = "#909090";

/// Angle in degrees, -180 ... 180, and force of every ball of the ring: those that carry, or those that do not.
std::string rows_of(BearingMap const& bearing, int sectors, bool carrying)
{
    std::string rows;
    for (std::size_t b = 0; b < bearing.ball_angle.size(); ++b) {
        if ((bearing.ball_force.at(b) > 0) == carrying) {
            for (int i = 0; i < sectors; ++i) {
                double const angle = std::remainder(bearing.ball_angle[b] + 2 * std::numbers::pi * i / sectors, 2 * std::numbers::pi);
                fmt::format_to(std::back_inserter(rows), "{:.6g} {:.6g}\n", angle * degree_per_radian, bearing.ball_force[b]);
            }
        }
    }
    return rows;
}

}  // namespace

bool has_balls(LoadStudy const& study)
{
    auto const* shown = shown_case(study);
    return study.balls > 0 && shown != nullptr && !shown->bearing.ball_force.empty();
}

std::string load_ball_script(LoadStudy const& study, PictureFormat format)
{
    constexpr double air = 1.12, half_turn = 180, shown_angle = 186;  // [deg]
    auto const& shown = *shown_case(study);
    auto const& force = shown.bearing.ball_force;
    auto const idle = rows_of(shown.bearing, study.sectors, false), carrying = rows_of(shown.bearing, study.sectors, true);
    double const largest = *std::max_element(force.begin(), force.end()), ceiling = largest > 0 ? air * largest : 1;
    auto const off = std::count_if(force.begin(), force.end(), [](double each) { return !(each > 0); }) * study.sectors;
    picture::Words const words{shown_load(study), fmt::format("forces of the {} balls on the outer ring{}; bands: lobes of the cam", study.balls, off > 0 ? fmt::format("; {} carry nothing (grey)", off) : ""), "", ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) + picture::axes({.top = top, .bottom = top + panel_height}, height);
    script += fmt::format("set xrange [{0:g}:{1:g}]\nset yrange [0:{2:.6g}]\nset xtics -{3:g},30,{3:g}\nset ytics {4:g}\nset xlabel 'angle from the major axis [°]' noenhanced\n"
                          "set ylabel 'force of a ball [N]' noenhanced\n",
                          -shown_angle, shown_angle, ceiling, half_turn, picture::tic_step(ceiling));
    // a lobe lifts the ring at each end of the major axis
    int const waves = study.solution.scene.wave_generator.waves;
    for (int i = 0; i < waves; ++i) {
        double const lobe = std::remainder(2 * half_turn * i / waves, 2 * half_turn);
        std::vector<double> places{lobe};
        if (std::abs(lobe) == half_turn) {
            places.push_back(-lobe);
        }
        for (double const at : places) {
            script += fmt::format("set arrow from first {0:.6g},0 to first {0:.6g},{1:.6g} nohead back linecolor rgb '#d8d8d8' linewidth 6\n", at, ceiling);
        }
    }
    std::string plot;
    auto const add = [&](char const* name, std::string const& rows, char const* colour) {
        if (rows.empty()) {
            return;
        }
        script += fmt::format("${} << END\n{}END\n", name, rows);
        plot += fmt::format("{}${} using 1:2 with impulses linecolor rgb '{}' linewidth 2 notitle, ${} using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb '{}' notitle",
                            plot.empty() ? "plot " : ", \\\n    ", name, colour, name, colour);
    };
    add("idle", idle, idle_colour);
    add("carrying", carrying, carrying_colour);
    return script + plot + "\n";
}

}  // namespace hdconj
