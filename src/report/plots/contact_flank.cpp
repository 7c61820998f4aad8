// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "contact_cells.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

/// The flank refined across the slices: rows of places along the flank [mm] and gaps there [mm], linear between what
/// the map holds.
struct FlankSheet
{
    std::vector<double> z;
    std::vector<std::vector<double>> along;  ///< (rows, stations)
    std::vector<std::vector<double>> gap;
    bool in_mm = true;  ///< else shares of the flank's length
};

/// Places of the stations along the flank of each slice; empty where the outline does not say.
std::vector<std::vector<double>> station_places(ContactStudy const& study, int flank)
{
    auto const& spline = study.solution.circular_spline;
    if (spline.landmarks.empty() || spline.outline.size() != study.map.z.size())
        return {};
    io::FlankStations const stations(spline, flank);
    std::vector<std::vector<double>> places;
    for (auto const& slice : spline.outline)
        places.push_back(stations.along(slice, study.map.station));
    return places;
}

FlankSheet refined_flank(ContactStudy const& study, io::FlankOfMap const& flank)
{
    auto const& map = study.map;
    FlankSheet sheet;
    auto along = station_places(study, flank.flank);
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
    constexpr int rows = 420;  // one for each pixel
    for (int i = 0; i <= rows; ++i) {
        double const at = z.front() + (z.back() - z.front()) * i / rows;
        std::size_t k = 0;
        while (k + 2 < z.size() && z[k + 1] <= at)
            ++k;
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

/// Rectangles between the exact places where one band ends and the next begins.
PlotColumns flank_cells(FlankSheet const& sheet, GapBands const& bands)
{
    PlotColumns cells;
    for (std::size_t row = 0; row + 1 < sheet.z.size(); ++row) {
        auto const& along = sheet.along[row];
        auto const& gap = sheet.gap[row];
        auto const add = [&](double begin, double end, std::size_t band) {
            cells.row(begin, end, sheet.z[row], sheet.z[row + 1], GapBands::colour(band));
        };
        std::size_t band = bands.band_of(gap.front());
        double begin = along.front();
        for (std::size_t p = 0; p + 1 < gap.size(); ++p) {
            std::size_t const next = bands.band_of(gap[p + 1]);
            while (band != next) {
                double const end = bands.ends()[std::min(band, next > band ? band : band - 1)];
                double const share = (end - gap[p]) / (gap[p + 1] - gap[p]);
                double const place = along[p] + share * (along[p + 1] - along[p]);
                if (place > begin)
                    add(begin, place, band);
                begin = place;
                band += next > band ? 1 : std::size_t(-1);
            }
        }
        add(begin, along.back(), band);
    }
    return cells;
}

/// The line gap = @p end, in pieces of one cell each.
PlotColumns gap_contour(FlankSheet const& sheet, double end)
{
    Polylines pieces;
    for (std::size_t row = 0; row + 1 < sheet.z.size(); ++row) {
        for (std::size_t p = 0; p + 1 < sheet.gap[row].size(); ++p) {
            std::vector<Vec2> crossing;
            auto const edge = [&](std::size_t r0, std::size_t p0, std::size_t r1, std::size_t p1) {
                double const a = sheet.gap[r0][p0], b = sheet.gap[r1][p1];
                if ((a <= end) != (b <= end)) {
                    double const share = (end - a) / (b - a);
                    crossing.emplace_back((1 - share) * sheet.along[r0][p0] + share * sheet.along[r1][p1],
                                          (1 - share) * sheet.z[r0] + share * sheet.z[r1]);
                }
            };
            edge(row, p, row, p + 1);
            edge(row, p + 1, row + 1, p + 1);
            edge(row + 1, p + 1, row + 1, p);
            edge(row + 1, p, row, p);
            for (std::size_t i = 0; i + 1 < crossing.size(); i += 2)
                pieces.push_back({crossing[i], crossing[i + 1]});
        }
    }
    return PlotColumns(pieces);
}

}  // namespace

std::string flank_script(ContactStudy const& study)
{
    auto const flank = io::fullest_flank(study.map, study.contact_gap);
    GapBands const bands(study.contact_gap, study.solution.scene.solver.tolerance);
    FlankSheet const sheet = refined_flank(study, flank);
    double longest = 0;
    for (auto const& row : sheet.along)
        longest = std::max(longest, row.back());
    PlotColumns slices;
    for (double const z : study.map.z)
        slices.row(z);
    PlotData data = shown_flank_data(study, flank);
    data.set("longest", longest);
    data.set("in_mm", sheet.in_mm);
    data.set("z_low", sheet.z.front());
    data.set("z_high", sheet.z.back());
    data.set("cells", flank_cells(sheet, bands));
    data.set("contour", gap_contour(sheet, study.contact_gap));
    data.set("slices", slices);
    return plot_script("contact_flank", data);
}

}  // namespace hdconj::report
