// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "figures/inspect_figures.hpp"
#include "figures/number_text.hpp"
#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
/// A band from the least to the largest deviation of all flanks of a side, and some of the flanks.
struct SideTraces
{
    PlotColumns traces, band;
    std::size_t drawn = 0, flanks = 0;
};

/// The teeth with the largest form, slope and total deviation among the flanks of a side of the first plane.
std::set<int> worst_teeth(Inspection const& inspection, bool right)
{
    std::set<int> teeth;
    for (Uncertain FlankFigures::*const figure : {&FlankFigures::form, &FlankFigures::slope, &FlankFigures::total}) {
        FlankFigures const* worst = nullptr;
        for (FlankFigures const& flank : inspection.flanks)
            if (flank.right == right && flank.z == inspection.nominal.front().z &&
                (worst == nullptr || std::abs((flank.*figure).value) > std::abs((worst->*figure).value)))
                worst = &flank;
        if (worst != nullptr)
            teeth.insert(worst->tooth);
    }
    return teeth;
}

/// Least and largest deviation by height of flanks whose points are sorted by arc length.
PlotColumns band_of(std::map<int, std::vector<Vec2>> const& flanks, double length)
{
    constexpr int heights = 64;
    std::map<int, std::pair<double, double>> band;
    auto const widen = [&](double height, double value) {
        auto const [at, is_new] = band.try_emplace(static_cast<int>(std::lround(height)), value, value);
        at->second = {std::min(at->second.first, value), std::max(at->second.second, value)};
    };
    for (auto const& [tooth, points] : flanks)
        for (std::size_t i = 0; i < points.size(); ++i) {
            double const here = points[i].x() / length * heights;
            widen(here, points[i].y());
            double const before = i > 0 ? points[i - 1].x() / length * heights : here;
            for (double height = std::ceil(before); height < here; ++height)
                widen(height, std::lerp(points[i - 1].y(), points[i].y(), (height - before) / (here - before)));
        }
    PlotColumns columns;
    for (auto const& [height, range] : band)
        columns.row(height * length / heights, range.first, range.second);
    if (band.empty())
        columns.row(no_value, no_value, no_value);
    return columns;
}

/// Of a side in the first plane by arc length: the band of all flanks, and every k-th of them with the worst ones.
SideTraces traces_of(Inspection const& inspection, bool right)
{
    constexpr std::size_t most_drawn = 24;
    std::map<int, std::vector<Vec2>> flanks;
    for (PointDeviation const& point : inspection.points)
        if (point.right == right && point.fate == PointFate::used && point.z == inspection.nominal.front().z)
            flanks[point.tooth].emplace_back(point.arc_length, point.deviation * per_um);
    std::set<int> const worst = worst_teeth(inspection, right);
    Polylines lines;
    std::size_t const step = flanks.size() / (most_drawn + 1) + 1;
    std::size_t number = 0;
    for (auto& [tooth, points] : flanks) {
        std::sort(points.begin(), points.end(), [](Vec2 const& a, Vec2 const& b) { return a.x() < b.x(); });
        if (number++ % step == 0 || worst.contains(tooth))
            lines.push_back(points);
    }
    SideTraces side{{}, band_of(flanks, inspection.nominal.front().flank_length), lines.size(), flanks.size()};
    if (lines.empty())
        lines.push_back({Vec2(no_value, no_value)});
    side.traces = PlotColumns(lines);
    return side;
}

PlotColumns strays_of(Inspection const& inspection, bool right)
{
    PlotColumns columns;
    columns.row(no_value, no_value);
    for (PointDeviation const& point : inspection.points)
        if (point.right == right && point.fate == PointFate::stray)
            columns.row(point.arc_length, point.deviation * per_um);
    return columns;
}

/// Positions of the flanks of the first plane by tooth, and the radial shift.
PlotColumns ring_of(Inspection const& inspection)
{
    struct Row
    {
        double left = no_value, right = no_value, radial = no_value;
    };
    std::map<int, Row> teeth;
    double const z = inspection.nominal.front().z;
    for (FlankFigures const& flank : inspection.flanks)
        if (flank.z == z)
            (flank.right ? teeth[flank.tooth].right : teeth[flank.tooth].left) = flank.position.value * per_um;
    for (ToothFigures const& tooth : inspection.teeth)
        if (tooth.z == z)
            teeth[tooth.tooth].radial = tooth.radial.value * per_um;
    PlotColumns columns;
    int before = 0;
    for (auto const& [tooth, row] : teeth) {
        if (before > 0 && tooth != before + 1)
            columns.end_line();
        columns.row(tooth, row.left, row.right, row.radial);
        before = tooth;
    }
    if (teeth.empty())
        columns.row(no_value, no_value, no_value, no_value);
    return columns;
}

/// "slope 2.84, crowning 0.92, form 1.02 um" of a side of the first plane: means, and the largest form.
std::string words_of_side(Inspection const& inspection, bool right)
{
    for (SideFigures const& side : inspection.sides)
        if (side.right == right && side.z == inspection.nominal.front().z)
            return fmt::format("slope {}, crowning {}, form {} µm", figures::fixed<2>(side.slope.value * per_um),
                               figures::fixed<2>(side.crowning.value * per_um),
                               figures::fixed<2>(side.form.value * per_um));
    return "";
}

/// "23 of 100 flanks drawn, grey: all"; empty where all are drawn.
std::string words_of_drawn(SideTraces const& side)
{
    return side.drawn == side.flanks ? "" : fmt::format("{} of {} flanks drawn, grey: all", side.drawn, side.flanks);
}

std::string words_of_ring(Inspection const& inspection)
{
    std::string words;
    for (SideFigures const& side : inspection.sides)
        if (side.pitches > 0 && side.z == inspection.nominal.front().z)
            words += fmt::format("{}: f_pt {}, F_p {} µm;  ", figures::flank_word(side.right),
                                 figures::fixed<2>(side.single_pitch.value * per_um),
                                 figures::fixed<2>(side.total_pitch.value * per_um));
    for (PlaneFigures const& plane : inspection.planes)
        if (plane.teeth > 1 && plane.z == inspection.nominal.front().z)
            words += fmt::format("runout {} µm", figures::fixed<2>(plane.runout.value * per_um));
    return words;
}

}  // namespace

std::string inspect_chart_script(Inspection const& inspection)
{
    PlotData data(inspection.scene.drive.name + ":  " + std::string(to_string(inspection.options.part)) + ",  " +
                  inspection.file);
    SideTraces const left = traces_of(inspection, false), right = traces_of(inspection, true);
    data.set("left_traces", left.traces);
    data.set("right_traces", right.traces);
    data.set("left_band", left.band);
    data.set("right_band", right.band);
    data.set("left_drawn", words_of_drawn(left));
    data.set("right_drawn", words_of_drawn(right));
    data.set("left_strays", strays_of(inspection, false));
    data.set("right_strays", strays_of(inspection, true));
    data.set("ring", ring_of(inspection));
    auto const [first, last] = std::minmax_element(inspection.flanks.begin(), inspection.flanks.end(),
                                                   [](auto const& a, auto const& b) { return a.tooth < b.tooth; });
    data.set("first_tooth", inspection.flanks.empty() ? 0 : first->tooth);
    data.set("last_tooth", inspection.flanks.empty() ? 1 : last->tooth);
    data.set("left_words", words_of_side(inspection, false));
    data.set("right_words", words_of_side(inspection, true));
    data.set("ring_words", words_of_ring(inspection));
    data.set("registration", std::string_view(to_string(inspection.options.registration)));
    data.set("flank_length", inspection.nominal.front().flank_length);
    return plot_script("inspect_chart", data);
}

}  // namespace hdconj::report
