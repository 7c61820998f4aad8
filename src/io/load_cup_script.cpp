// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "colour_scale.hpp"
#include "load_scripts.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 110;
constexpr double panel_height = 430;
constexpr double panel_width = 405;
constexpr double second_left = 555;
constexpr double below = 84;
constexpr double cup_height = top + panel_height + below;
constexpr double legend_height = 70;
constexpr double stress_height = cup_height + legend_height;

/// A range of a panel, both axes to one scale.
struct View
{
    double r_low, r_high, z_low, z_high;

    void take(double r, double z)
    {
        r_low = std::min(r_low, r);
        r_high = std::max(r_high, r);
        z_low = std::min(z_low, z);
        z_high = std::max(z_high, z);
    }
    /// Some air, then the shorter side is widened.
    void fit()
    {
        constexpr double air = 0.04;
        double const size = std::max(r_high - r_low, z_high - z_low);
        double const mm_per_px = std::max((r_high - r_low + 2 * air * size) / panel_width, (z_high - z_low + 2 * air * size) / panel_height);
        auto const widen = [](double& low, double& high, double to) {
            double const by = (to - (high - low)) / 2;
            low -= by;
            high += by;
        };
        widen(r_low, r_high, mm_per_px * panel_width);
        widen(z_low, z_high, mm_per_px * panel_height);
    }
};

View view_of(CupShape const& shape)
{
    View view{shape.r[0], shape.r[0], shape.z[0], shape.z[0]};
    for (std::size_t p = 0; p < shape.r.size(); ++p) {
        view.take(shape.r[p], shape.z[p]);
    }
    return view;
}

std::string panel(View const& view, double left, double height)
{
    double const step = std::max(picture::tic_step(view.r_high - view.r_low), picture::tic_step(view.z_high - view.z_low));
    return picture::axes({.left = left, .right = left + panel_width, .top = top, .bottom = top + panel_height}, height) +
           fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:g}\nset ytics {:g}\n"
                       "set xlabel 'radius [mm]' noenhanced\nset ylabel 'z above the middle of the bearing [mm]' noenhanced\n",
                       view.r_low, view.r_high, view.z_low, view.z_high, step, step);
}

/// Index of the angle next to @p wanted, a turn more or less being the same.
std::size_t angle_near(CupShape const& shape, double wanted)
{
    std::size_t best = 0;
    for (std::size_t a = 0; a < shape.phi.size(); ++a) {
        auto const off = [&](std::size_t i) { return std::abs(std::remainder(shape.phi[i] - wanted, 2 * std::numbers::pi)); };
        best = off(a) < off(best) ? a : best;
    }
    return best;
}

/// Corners of a cell, its first one again at the end, and an empty line; displaced by @p scale times the displacement.
void add_cell(std::string& rows, CupShape const& shape, std::vector<int> const& cell, std::size_t angle, double scale)
{
    for (std::size_t i = 0; i <= cell.size(); ++i) {
        auto const p = static_cast<std::size_t>(cell[i % cell.size()]);
        std::size_t const at = angle * shape.r.size() + p;
        fmt::format_to(std::back_inserter(rows), "{:.6g} {:.6g}\n", shape.r[p] + scale * shape.u_r[at], shape.z[p] + scale * shape.u_z[at]);
    }
    rows += "\n";
}

std::string cells_of(CupShape const& shape, std::size_t angle, double scale)
{
    std::string rows;
    for (auto const& cell : shape.cells) {
        add_cell(rows, shape, cell, angle, scale);
    }
    return rows;
}

/// 1, 2 or 5 times a power of ten, no larger than @p value but for a little.
double round_scale(double value)
{
    constexpr double a_little = 1.15;
    double const power = std::pow(10.0, std::floor(std::log10(value * a_little)));
    double const rest = value * a_little / power;
    return power * (rest >= 5 ? 5 : rest >= 2 ? 2 : 1);
}

double degrees_of(CupShape const& shape, std::size_t angle)
{
    return shape.phi[angle] * degree_per_radian;
}

/// "0" and never "-0".
std::string degrees_text(double degrees)
{
    constexpr double tenth = 10;
    double const rounded = std::round(degrees * tenth) / tenth;
    return fmt::format("{:g}°", rounded == 0 ? 0.0 : rounded);
}

}  // namespace

std::string load_cup_script(LoadStudy const& study, PictureFormat format)
{
    auto const& shape = study.shape;
    View view = view_of(shape);
    double const size = std::max(view.r_high - view.r_low, view.z_high - view.z_low);
    std::size_t const major = angle_near(shape, 0), minor = angle_near(shape, std::numbers::pi / study.solution.scene.wave_generator.waves);
    double largest = 0;
    for (std::size_t const angle : {major, minor}) {
        for (std::size_t p = 0; p < shape.r.size(); ++p) {
            std::size_t const at = angle * shape.r.size() + p;
            largest = std::max(largest, std::hypot(shape.u_r[at], shape.u_z[at]));
        }
    }
    constexpr double shown_share = 0.08;  // of the cup, by the largest displacement
    double const scale = largest > 0 ? round_scale(shown_share * size / largest) : 1;
    for (std::size_t const angle : {major, minor}) {
        for (std::size_t p = 0; p < shape.r.size(); ++p) {
            std::size_t const at = angle * shape.r.size() + p;
            view.take(shape.r[p] + scale * shape.u_r[at], shape.z[p] + scale * shape.u_z[at]);
        }
    }
    view.fit();
    picture::Words const words{shown_load(study),
                               fmt::format("section of the cup, grey as made, blue displaced by {:g} times its radial and axial displacement (largest {:.3g} µm)", scale, largest * um_per_mm), "", ""};
    std::string script = picture::terminal(format, cup_height) + picture::title(cup_height, words) + "set multiplot\n";
    bool first = true;
    for (std::size_t const angle : {major, minor}) {
        script += panel(view, first ? picture::left_margin : second_left, cup_height);
        std::string const name = first ? "major" : "minor";
        script += fmt::format("set label 1001 '{} axis, {}' at graph 0,1.03 left noenhanced\n$made_{} << END\n{}END\n$bent_{} << END\n{}END\n", name, degrees_text(degrees_of(shape, angle)), name,
                              cells_of(shape, angle, 0), name, cells_of(shape, angle, scale));
        script += fmt::format("plot $made_{} using 1:2 with filledcurves closed fillcolor rgb '#dcdcdc' fillstyle solid 1 noborder notitle, \\\n"
                              "    $bent_{} using 1:2 with filledcurves closed fillcolor rgb '#a6cde6' fillstyle solid 1 noborder notitle, \\\n"
                              "    $bent_{} using 1:2 with lines linecolor rgb '#0072b2' linewidth 0.7 notitle\n",
                              name, name, name);
        if (first) {
            script += "unset label\n";
        }
        first = false;
    }
    return script + "unset multiplot\n";
}

std::string load_stress_script(LoadStudy const& study, PictureFormat format)
{
    auto const& shape = study.shape;
    std::size_t const nodes = shape.r.size();
    std::vector<double> worst(nodes, 0.0);
    for (std::size_t i = 0; i < shape.stress.size(); ++i) {
        worst[i % nodes] = std::max(worst[i % nodes], shape.stress[i]);
    }
    // Corners only: what is drawn is what is named.
    std::size_t place = static_cast<std::size_t>(shape.cells.front().front());
    for (auto const& cell : shape.cells) {
        for (int const node : cell) {
            place = worst[static_cast<std::size_t>(node)] > worst[place] ? static_cast<std::size_t>(node) : place;
        }
    }
    ColourScale const scale(worst[place]);
    std::map<std::size_t, std::string> by_band;
    for (auto const& cell : shape.cells) {
        double sum = 0;
        for (int const node : cell) {
            sum += worst[static_cast<std::size_t>(node)];
        }
        add_cell(by_band[scale.band_of(sum / static_cast<double>(cell.size()))], shape, cell, 0, 0);
    }
    View view = view_of(shape);
    view.fit();
    picture::Words const words{shown_load(study), "von Mises stress in the cup (elements: mean of their corners), and around the axis where it is largest", "", ""};
    std::string script = picture::terminal(format, stress_height) + picture::title(stress_height, words) + scale.legend("stress [MPa]", "", cup_height + 14, stress_height) + "set multiplot\n";
    script += panel(view, picture::left_margin, stress_height);
    std::string plot;
    for (auto const& [band, rows] : by_band) {
        script += fmt::format("$band{} << END\n{}END\n", band, rows);
        plot += fmt::format("{}$band{} using 1:2 with filledcurves closed fillcolor rgb '#{:06x}' fillstyle solid 1 border linecolor rgb '#{:06x}' notitle", plot.empty() ? "plot " : ", \\\n    ", band,
                            scale.colour(band), scale.colour(band));
    }
    script += fmt::format("$place << END\n{:.6g} {:.6g}\nEND\n", shape.r[place], shape.z[place]);
    plot += ", \\\n    $place using 1:2 with points pointtype 6 pointsize 1.4 linewidth 1.5 linecolor rgb '#0072b2' notitle";
    script += "set label 1001 'largest over all angles' at graph 0,1.03 left noenhanced\n" + plot + "\nunset label\nunset object\n";
    script += picture::axes({.left = second_left, .right = second_left + panel_width, .top = top, .bottom = top + panel_height}, stress_height);
    std::string around;
    for (std::size_t a = 0; a < shape.phi.size(); ++a) {
        fmt::format_to(std::back_inserter(around), "{:.6g} {:.6g}\n", degrees_of(shape, a), shape.stress[a * nodes + place]);
    }
    constexpr double air = 1.05;
    double const from = degrees_of(shape, 0), to = shape.phi.size() > 1 ? degrees_of(shape, shape.phi.size() - 1) : from + 1;
    constexpr double whole_turn = 300, in_a_turn = 60;  // tics that fit a turn [deg]
    script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [0:{:.6g}]\nset xtics {:g}\nset ytics {:g}\nset xlabel 'degrees clockwise from the major axis' noenhanced\n"
                          "unset ylabel\nset label 1001 'stress [MPa] at r = {:.2f} mm, z = {:.2f} mm (the circle)' at graph 0,1.03 left noenhanced\n$around << END\n{}END\n"
                          "plot $around using 1:2 with lines linecolor rgb '#0072b2' linewidth 2 notitle\nunset multiplot\n",
                          from, to, worst[place] > 0 ? air * worst[place] : 1, to - from > whole_turn ? in_a_turn : picture::tic_step(to - from), picture::tic_step(worst[place] > 0 ? worst[place] : 1), shape.r[place], shape.z[place], around);
    return script;
}

}  // namespace hdconj
