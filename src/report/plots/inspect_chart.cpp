// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>

#include "figures/inspect_figures.hpp"
#include "figures/number_text.hpp"
#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_drawn = 24;  // flanks of a side: more are one grey band

/// The traces of a side in the first plane, by arc length: of all teeth, or of every k-th.
PlotColumns traces_of(Inspection const& inspection, bool right)
{
    std::map<int, std::vector<Vec2>> flanks;
    for (PointDeviation const& point : inspection.points)
        if (point.right == right && point.fate == PointFate::used && point.z == inspection.nominal.front().z)
            flanks[point.tooth].emplace_back(point.arc_length, point.deviation * per_um);
    Polylines lines;
    std::size_t const step = (flanks.size() + most_drawn - 1) / most_drawn, first = 0;
    std::size_t number = first;
    for (auto& [tooth, points] : flanks) {
        if (number++ % std::max<std::size_t>(step, 1) != 0)
            continue;
        std::sort(points.begin(), points.end(), [](Vec2 const& a, Vec2 const& b) { return a.x() < b.x(); });
        lines.push_back(points);
    }
    if (lines.empty())
        lines.push_back({Vec2(no_value, no_value)});
    return PlotColumns(lines);
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
    data.set("left_traces", traces_of(inspection, false));
    data.set("right_traces", traces_of(inspection, true));
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
