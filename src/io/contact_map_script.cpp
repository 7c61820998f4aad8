// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact_figures.hpp"
#include "contact_scripts.hpp"
#include "gap_bands.hpp"
#include "gap_on_surface.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double panel_height = 200;
constexpr double panel_distance = 88;
constexpr double first_top = 104;
constexpr double below = 150;
constexpr double height = first_top + 2 * panel_height + panel_distance + below;

// Numbers of what each panel has; gnuplot counts from 1 for what has no number.
constexpr int label_of_panel = 1001, label_of_fullest = 1002, arrow_to_fullest = 1001;

constexpr double half_turn = 180;  // [deg]

/// Borders of cells about @p at: half way between neighbours, @p first and @p last at the ends.
std::vector<double> borders(std::vector<double> const& at, double first, double last)
{
    std::vector<double> result = {first};
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        result.push_back((at[i] + at[i + 1]) / 2);
    }
    result.push_back(last);
    return result;
}

/// Tooth spaces by their angle [deg].
struct Spaces
{
    std::vector<std::size_t> number;
    std::vector<double> angle;
};

Spaces by_angle(GapMap const& map)
{
    Spaces spaces;
    spaces.number.resize(map.angle.size());
    std::iota(spaces.number.begin(), spaces.number.end(), std::size_t{0});
    std::sort(spaces.number.begin(), spaces.number.end(), [&](auto a, auto b) { return map.angle[a] < map.angle[b]; });
    for (std::size_t const number : spaces.number) {
        spaces.angle.push_back(map.angle[number] * degree_per_radian);
    }
    return spaces;
}

double smallest_along(GapMap const& map, std::size_t space, int flank, std::size_t slice)
{
    double smallest = map.at(space, flank, slice, 0);
    for (std::size_t p = 1; p < map.station.size(); ++p) {
        smallest = std::min(smallest, map.at(space, flank, slice, p));
    }
    return smallest;
}

/// Neighbours of one colour become one rectangle.
ColouredCells cells_of(GapMap const& map, Spaces const& spaces, int flank, GapBands const& bands,
                       std::vector<double> const& z)
{
    auto const angle = borders(spaces.angle, -half_turn, half_turn);
    ColouredCells cells;
    for (std::size_t k = 0; k < map.z.size(); ++k) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < spaces.number.size(); ++i) {
            auto const band_at = [&](std::size_t n) {
                return bands.band_of(smallest_along(map, spaces.number[n], flank, k));
            };
            if (i + 1 == spaces.number.size() || band_at(i + 1) != band_at(i)) {
                cells.add(angle[begin], angle[i + 1], z[k], z[k + 1], band_at(i));
                begin = i + 1;
            }
        }
    }
    return cells;
}

/// Where the slices lie along z; a single one stands for the width of the circular spline.
std::vector<double> z_borders(ContactStudy const& study)
{
    auto const& z = study.map.z;
    double const half = study.solution.scene.circular_spline.width.value_or(1) / 2;
    return z.size() == 1 ? borders(z, z[0] - half, z[0] + half) : borders(z, z.front(), z.back());
}

/// "circular spline turned to first contact, wave generator at 3°"
std::string shown_state(ContactStudy const& study)
{
    std::string const turned = "circular spline turned to first contact";
    if (study.shown >= study.cases.size()) {
        return turned;
    }
    constexpr double steps = 1000;  // of a degree
    double const angle = std::round(study.cases[study.shown].state.wave_generator * degree_per_radian * steps) / steps;
    return fmt::format("{}, wave generator at {:g}°", turned, angle == 0 ? 0.0 : angle);
}

/// Where a label at this angle [deg] lies of its place, so that it stays within the picture.
char const* side_of(double angle)
{
    constexpr double near_edge = 150;
    return angle > near_edge ? "right" : angle < -near_edge ? "left" : "center";
}

}  // namespace

std::string shown_case(ContactStudy const& study)
{
    std::string const& drive = study.solution.scene.drive.name;
    if (study.shown >= study.cases.size()) {
        return drive;
    }
    auto const& each = study.cases[study.shown];
    return fmt::format("{}:  {},  side clearance {:.3g} µm", drive, case_name(each), each.backlash_offset * um_per_mm);
}

std::string map_script(ContactStudy const& study, PictureFormat format)
{
    auto const& map = study.map;
    GapBands const bands(study.contact_gap, study.solution.scene.solver.tolerance);
    Spaces const spaces = by_angle(map);
    auto const z = z_borders(study);
    auto const fullest = fullest_flank(map, study.contact_gap);
    picture::Words const words{shown_case(study), "smallest gap along each flank, " + shown_state(study), "", ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) +
                         bands.legend(height - below + 90, height) + "set multiplot\n";
    struct Half
    {
        int flank;
        char const* name;
    };
    double top = first_top;
    for (auto const& [flank, name] : {Half{GapMap::right, "right flanks, driving side"}, Half{GapMap::left, "left flanks"}}) {
        std::string const data = flank == GapMap::right ? "right" : "left";
        script += picture::axes({.top = top, .bottom = top + panel_height}, height);
        script += fmt::format(
            "set xrange [{}:{}]\nset yrange [{:.6g}:{:.6g}]\nset xtics 45\nset ytics {:g}\n"
            "set xlabel {} noenhanced offset 0,0.4\nset ylabel 'z [mm]' noenhanced\n"
            "set label {} {} at graph 0,1.09 left noenhanced\n",
            -half_turn, half_turn, z.front(), z.back(), picture::tic_step((z.back() - z.front()) * 2),
            flank == GapMap::left ? "'tooth space, degrees clockwise from the major axis'" : "''", label_of_panel, gnuplot_quoted(name));
        if (flank == fullest.flank) {
            script += fmt::format(
                "set label {} '{}' at first {:.6g}, graph 1.09 {} noenhanced\n"
                "set arrow {} from first {:.6g}, graph 1.055 to first {:.6g}, graph 1.0 head filled size screen 0.006,25 "
                "linewidth 1.2 linecolor rgb '#303030'\n",
                label_of_fullest, fullest.in_contact ? "most contact" : "smallest gap", map.angle[fullest.space] * degree_per_radian,
                side_of(map.angle[fullest.space] * degree_per_radian), arrow_to_fullest,
                map.angle[fullest.space] * degree_per_radian, map.angle[fullest.space] * degree_per_radian);
        } else {
            script += fmt::format("unset label {}\nunset arrow {}\n", label_of_fullest, arrow_to_fullest);
        }
        script += cells_of(map, spaces, flank, bands, z).block(data) + "plot " + ColouredCells::command(data) + "\n";
        // What belongs to the whole picture is drawn once.
        if (flank == GapMap::right) {
            script += "unset label\nunset object\nunset arrow\n";
        }
        top += panel_height + panel_distance;
    }
    return script + "unset multiplot\n";
}

}  // namespace hdconj
