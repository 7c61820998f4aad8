// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "colour_scale.hpp"
#include "hdconj/contact/gap_map.hpp"
#include "load_scripts.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double first_top = 100;
constexpr double pressure_height = 230;
constexpr double distance = 130;
constexpr double force_height = 170;
constexpr double below = 84;
constexpr double height = first_top + pressure_height + distance + force_height + below;

// Numbers of what only the upper panel has.
constexpr int peak = 1001;

/// Borders of cells about @p at, half way between neighbours; at the ends as far outside, or to @p first and @p last.
std::vector<double> borders(std::vector<double> const& at, double outside)
{
    std::vector<double> result = {at.front() - outside};
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        result.push_back((at[i] + at[i + 1]) / 2);
    }
    result.push_back(at.back() + outside);
    return result;
}

double force_on(LoadMap const& map, std::size_t space, int flank)
{
    double sum = 0;
    for (std::size_t k = 0; k < map.z.size(); ++k) {
        sum += map.force[map.index(space, flank, k)];
    }
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

}  // namespace

std::string load_pressure_script(LoadStudy const& study, PictureFormat format)
{
    auto const& map = shown_case(study)->map;
    int const flank = loaded_flank(map), other = flank == GapMap::right ? GapMap::left : GapMap::right;
    std::vector<double> degrees;
    for (double const angle : map.angle) {
        degrees.push_back(angle * degree_per_radian);
    }
    double const half_pitch = degrees.size() > 1 ? (degrees[1] - degrees[0]) / 2 : 180.0 / std::max(1, study.sectors);
    auto const angle = borders(degrees, half_pitch);
    auto const z = borders(map.z, map.z.size() > 1 ? 0 : study.solution.scene.circular_spline.width.value_or(1) / 2);
    std::size_t largest = map.index(0, flank, 0);
    std::size_t peak_space = 0, peak_slice = 0;
    for (std::size_t s = 0; s < degrees.size(); ++s) {
        for (std::size_t k = 0; k < map.z.size(); ++k) {
            if (map.pressure[map.index(s, flank, k)] > map.pressure[largest]) {
                largest = map.index(s, flank, k);
                peak_space = s;
                peak_slice = k;
            }
        }
    }
    ColourScale const scale(map.pressure[largest]);
    std::string cells;
    double most = 0, least = 0;
    std::string forces;
    for (std::size_t k = 0; k < map.z.size(); ++k) {
        // Neighbours of one colour are one rectangle.
        std::size_t begin = 0;
        for (std::size_t s = 0; s < degrees.size(); ++s) {
            auto const band = [&](std::size_t space) { return scale.band_of(map.pressure[map.index(space, flank, k)]); };
            if (s + 1 == degrees.size() || band(s + 1) != band(s)) {
                fmt::format_to(std::back_inserter(cells), "{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {}\n", (angle[begin] + angle[s + 1]) / 2, (z[k] + z[k + 1]) / 2, angle[begin], angle[s + 1],
                               z[k], z[k + 1], scale.colour(band(s)));
                begin = s + 1;
            }
        }
    }
    for (std::size_t s = 0; s < degrees.size(); ++s) {
        double const here = force_on(map, s, flank), there = force_on(map, s, other);
        most = std::max(most, here);
        least = std::min(least, -there);
        fmt::format_to(std::back_inserter(forces), "{:.6g} {:.6g} {:.6g} {:.6g}\n", degrees[s], here, -there, angle[s + 1] - angle[s]);
    }
    picture::Words const words{shown_load(study),
                               fmt::format("largest pressure on the {} flanks, and the force on each tooth{}", flank == GapMap::right ? "right" : "left",
                                           study.sectors > 1 ? fmt::format("; it repeats {} times around the ring", study.sectors) : ""),
                               "", ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) + scale.legend("pressure [MPa]", "no force", first_top + pressure_height + 66, height) +
                         "set multiplot\n" + picture::axes({.top = first_top, .bottom = first_top + pressure_height}, height);
    script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:g}\nset ytics {:g}\nset xlabel ''\nset ylabel 'z [mm]' noenhanced\n", angle.front(), angle.back(),
                          z.front(), z.back(), picture::tic_step(angle.back() - angle.front()), picture::tic_step((z.back() - z.front()) * 2));
    if (map.pressure[largest] > 0) {
        script += fmt::format("set arrow {} from first {:.6g}, graph 1.06 to first {:.6g}, graph 1.0 head filled size screen 0.006,25 linewidth 1.2 linecolor rgb '#303030' front\n"
                              "set label {} '{:.0f} MPa{}' at first {:.6g}, graph 1.10 {} noenhanced\n",
                              peak, degrees[peak_space], degrees[peak_space], peak, map.pressure[largest],
                              shown_case(study)->pressure_at_edge ? ", at an end of the face width: not converged" : "", degrees[peak_space],
                              2 * peak_space > degrees.size() ? "right" : "left");
    }
    script += "$cells << END\n" + cells +
              fmt::format("END\n$peak << END\n{:.6g} {:.6g}\nEND\nplot $cells using 1:2:3:4:5:6:7 with boxxyerror linecolor rgb variable linewidth 0.4 fillstyle solid 1 border notitle, \\\n"
                          "    $peak using 1:2 with points pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb '#ffffff' notitle\n",
                          degrees[peak_space], (z[peak_slice] + z[peak_slice + 1]) / 2) +
              "unset label\nunset object\nunset arrow\n";
    script += picture::axes({.top = first_top + pressure_height + distance, .bottom = first_top + pressure_height + distance + force_height}, height);
    constexpr double air = 1.08;
    double const range = most - least > 0 ? most - least : 1;
    script += fmt::format("set yrange [{:.6g}:{:.6g}]\nset ytics {:g}\nset xlabel 'tooth space, degrees clockwise from the major axis' noenhanced\n"
                          "set ylabel 'force [N]' noenhanced\nset boxwidth 0.85 relative\n$forces << END\n{}END\n"
                          "plot $forces using 1:2 with boxes linecolor rgb '#0072b2' fillstyle solid 1 noborder notitle",
                          air * least, air * most + (most > 0 ? 0 : range), picture::tic_step(range * 2), forces);
    if (least < 0) {
        script += ", \\\n    $forces using 1:3 with boxes linecolor rgb '#d55e00' fillstyle solid 1 noborder notitle";
        script = script.insert(script.rfind("plot $forces"), "set label 'downwards: on the other flanks' at graph 0.0, graph 1.07 left noenhanced textcolor rgb '#d55e00'\n");
    }
    return script + "\nunset multiplot\n";
}

}  // namespace hdconj
