// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact_scripts.hpp"
#include "gap_bands.hpp"
#include "gap_on_surface.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 82;
constexpr double panel_height = 420;
constexpr double below = 164;
constexpr double height = top + panel_height + below;
constexpr double right_axis = 62;
constexpr double row_height = 1;

/// The flank refined across the slices: rows of places along the flank [mm] and gaps there [mm], linear between what the map holds.
struct Sheet
{
    std::vector<double> z;
    std::vector<std::vector<double>> along;  ///< (rows, stations)
    std::vector<std::vector<double>> gap;
    bool in_mm = true;  ///< else shares of the flank's length
};

/// Places of the stations along the flank of each slice; empty where the outline does not say.
std::vector<std::vector<double>> places(ContactStudy const& study, int flank)
{
    auto const& spline = study.solution.circular_spline;
    if (spline.landmarks.empty() || spline.outline.size() != study.map.z.size()) {
        return {};
    }
    FlankStations const stations(spline, flank);
    std::vector<std::vector<double>> result;
    for (auto const& slice : spline.outline) {
        result.push_back(stations.along(slice, study.map.station));
    }
    return result;
}

Sheet refined(ContactStudy const& study, FlankOfMap const& flank)
{
    auto const& map = study.map;
    Sheet sheet;
    auto along = places(study, flank.flank);
    if (along.empty()) {
        sheet.in_mm = false;
        along.assign(map.z.size(), map.station);
    }
    auto z = map.z;
    if (z.size() == 1) {
        double const half = study.solution.scene.circular_spline.width.value_or(1) / 2;
        z = {z[0] - half, z[0] + half};
        along.push_back(along[0]);
    }
    int const rows = static_cast<int>(panel_height / row_height);
    for (int i = 0; i <= rows; ++i) {
        double const at = z.front() + (z.back() - z.front()) * i / rows;
        std::size_t k = 0;
        while (k + 2 < z.size() && z[k + 1] <= at) {
            ++k;
        }
        double const share = (at - z[k]) / (z[k + 1] - z[k]);
        std::size_t const lower = std::min(k, map.z.size() - 1), upper = std::min(k + 1, map.z.size() - 1);
        sheet.z.push_back(at);
        sheet.along.emplace_back();
        sheet.gap.emplace_back();
        for (std::size_t p = 0; p < map.station.size(); ++p) {
            sheet.along.back().push_back((1 - share) * along[k][p] + share * along[k + 1][p]);
            sheet.gap.back().push_back((1 - share) * map.at(flank.space, flank.flank, lower, p) +
                                       share * map.at(flank.space, flank.flank, upper, p));
        }
    }
    return sheet;
}

/// Where the gap passes @p end between two places, as a share of the way; none where it does not.
bool passes(double a, double b, double end)
{
    return (a <= end) != (b <= end);
}

/// Rectangles between the exact places where one band ends and the next begins.
ColouredCells cells_of(Sheet const& sheet, GapBands const& bands)
{
    ColouredCells cells;
    for (std::size_t row = 0; row + 1 < sheet.z.size(); ++row) {
        auto const& along = sheet.along[row];
        auto const& gap = sheet.gap[row];
        std::size_t band = bands.band_of(gap.front());
        double begin = along.front();
        for (std::size_t p = 0; p + 1 < gap.size(); ++p) {
            std::size_t const next = bands.band_of(gap[p + 1]);
            while (band != next) {
                double const end = bands.ends()[std::min(band, next > band ? band : band - 1)];
                double const share = (end - gap[p]) / (gap[p + 1] - gap[p]);
                double const place = along[p] + share * (along[p + 1] - along[p]);
                if (place > begin) {
                    cells.add(begin, place, sheet.z[row], sheet.z[row + 1], band);
                }
                begin = place;
                band += next > band ? 1 : std::size_t(-1);
            }
        }
        cells.add(begin, along.back(), sheet.z[row], sheet.z[row + 1], band);
    }
    return cells;
}

/// The line gap = @p end, in pieces of one cell each.
std::string contour(Sheet const& sheet, double end)
{
    std::string lines;
    for (std::size_t row = 0; row + 1 < sheet.z.size(); ++row) {
        for (std::size_t p = 0; p + 1 < sheet.gap[row].size(); ++p) {
            std::vector<Vec2> crossing;
            auto const edge = [&](std::size_t r0, std::size_t p0, std::size_t r1, std::size_t p1) {
                double const a = sheet.gap[r0][p0], b = sheet.gap[r1][p1];
                if (passes(a, b, end)) {
                    double const share = (end - a) / (b - a);
                    crossing.emplace_back((1 - share) * sheet.along[r0][p0] + share * sheet.along[r1][p1],
                                          (1 - share) * sheet.z[r0] + share * sheet.z[r1]);
                }
            };
            edge(row, p, row, p + 1);
            edge(row, p + 1, row + 1, p + 1);
            edge(row + 1, p + 1, row + 1, p);
            edge(row + 1, p, row, p);
            for (std::size_t i = 0; i + 1 < crossing.size(); i += 2) {
                lines += fmt::format("{:.6g} {:.6g}\n{:.6g} {:.6g}\n\n", crossing[i].x(), crossing[i].y(),
                                     crossing[i + 1].x(), crossing[i + 1].y());
            }
        }
    }
    return lines;
}

}  // namespace

std::string flank_script(ContactStudy const& study, PictureFormat format)
{
    auto const& map = study.map;
    auto const flank = fullest_flank(map, study.contact_gap);
    GapBands const bands(study.contact_gap, study.solution.scene.solver.tolerance);
    Sheet const sheet = refined(study, flank);
    double widest = 0;
    for (auto const& row : sheet.along) {
        widest = std::max(widest, row.back());
    }
    picture::Words const words{
        shown_case(study),
        fmt::format("{} flank of the tooth space at {:.2f}°, the one with {}; circular spline turned to first contact",
                    flank.flank == GapMap::right ? "right" : "left", map.angle[flank.space] * degree_per_radian,
                    flank.in_contact ? "most contact" : "the smallest gap"),
        "", ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) +
                         bands.legend(height - below + 104, height) +
                         picture::axes({.right = picture::width - right_axis, .top = top, .bottom = top + panel_height}, height);
    script += fmt::format(
        "set xrange [0:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:g}\nset ytics {:g}\n"
        "set xlabel {} noenhanced\nset ylabel 'z [mm]' noenhanced\n",
        widest, sheet.z.front(), sheet.z.back(), picture::tic_step(widest), picture::tic_step(sheet.z.back() - sheet.z.front()),
        sheet.in_mm ? "'along the flank, from the land corner to the flank end [mm]'"
                    : "'along the flank, from the land corner to the flank end [share of its length]'");
    // The slices that were computed; between them gaps are interpolated.
    std::string slices;
    for (double const z : map.z) {
        slices += fmt::format("{}'' {:.6g}", slices.empty() ? "" : ",", z);
    }
    script += fmt::format(
        "set border 11\nset y2range [{:.6g}:{:.6g}]\nset y2tics ({})\nset y2label 'slices computed' noenhanced offset -1,0\n",
        sheet.z.front(), sheet.z.back(), slices);
    auto const line = contour(sheet, study.contact_gap);
    script += cells_of(sheet, bands).block("cells");
    std::string plot = "plot " + ColouredCells::command("cells");
    if (!line.empty()) {
        script += "$contour << END\n" + line + "END\n";
        plot += ", \\\n    $contour using 1:2 with lines linecolor rgb '#ffffff' linewidth 1.8 notitle";
    }
    return script + plot + "\n";
}

}  // namespace hdconj
