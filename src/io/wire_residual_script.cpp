// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"
#include "wire_scripts.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 82;
constexpr double panel_height = 400;
constexpr double below = 148;
constexpr double height = top + panel_height + below;

/// What is told apart: face, and whether it meshes.
struct Group
{
    bool upper, meshing;
    char const* look;
    char const* name;
};
constexpr std::array groups = {Group{false, false, "pointtype 6 pointsize 0.7 linecolor rgb '#0072b2'", "lower face, does not mesh"},
                               Group{true, false, "pointtype 4 pointsize 1.1 linecolor rgb '#009e73'", "upper face, does not mesh"},
                               Group{false, true, "pointtype 7 pointsize 0.7 linecolor rgb '#d55e00'", "lower face, meshes"},
                               Group{true, true, "pointtype 12 pointsize 1.2 linecolor rgb '#cc79a7'", "upper face, meshes"}};

std::string rows_of(std::vector<Residual> const& residuals, Group const& group, int pass)
{
    std::string rows;
    for (auto const& each : residuals) {
        if (each.pass == pass && each.upper == group.upper && each.meshing == group.meshing) {
            fmt::format_to(std::back_inserter(rows), "{} {:.6g}\n", each.tooth, each.height * um_per_mm);
        }
    }
    return rows;
}

}  // namespace

std::string wire_residual_script(WireSetUps const& programs, PictureFormat format)
{
    auto const& program = programs.front();
    std::vector<Residual> residuals;
    for (auto const& each : programs) {
        residuals.insert(residuals.end(), each.residuals.begin(), each.residuals.end());
    }
    int last = 0, least = 0, most = 0;
    double highest = 0;
    for (auto const& each : residuals) {
        last = std::max(last, each.pass);
        least = std::min(least, each.tooth);
        most = std::max(most, each.tooth);
    }
    for (auto const& each : residuals) {
        highest = std::max(highest, each.pass == last ? each.height * um_per_mm : 0);
    }
    constexpr double headroom = 1.1;
    double const range = headroom * (highest > 0 ? highest : 1);
    picture::Words const words{program.name,
                               fmt::format("material that pass {} cannot reach with a wire of {:g} mm, above the contour", last, program.wire_diameter), "",
                               ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) +
                         picture::axes({.top = top, .bottom = top + panel_height}, height);
    script += fmt::format(
        "set xrange [{}:{}]\nset yrange [0:{:.6g}]\nset ytics {:g}\nset xlabel 'tooth space' noenhanced\n"
        "set ylabel 'residual material [µm]' noenhanced\n",
        least - 1, most + 1, range, picture::tic_step(range));
    std::string plot;
    constexpr double legend_top = 106, column = 440, row = 26, gap = 18;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        std::string const rows = rows_of(residuals, groups[i], last);
        if (rows.empty()) {
            continue;
        }
        double const x = picture::left_margin + static_cast<double>(shown % 2) * column;
        double const y = top + panel_height + legend_top - row / 2 + static_cast<double>(shown / 2) * row;
        script += fmt::format("$group{} << END\n{}END\nset label '' at {} point {}\nset label {} at {} noenhanced\n", i, rows, picture::screen(x, y, height),
                              groups[i].look, gnuplot_quoted(groups[i].name), picture::screen(x + gap, y, height));
        plot += fmt::format("{} $group{} using 1:2 with points {}", plot.empty() ? "plot" : ", \\\n    ", i, groups[i].look);
        ++shown;
    }
    return script + plot + "\n";
}

}  // namespace hdconj
