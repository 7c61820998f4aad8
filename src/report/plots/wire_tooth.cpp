// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "hdconj/units.hpp"
#include "plot_window.hpp"
#include "plots.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::report {
namespace {

/// The tooth space that is shown, and the turn that brings its middle onto the y axis.
struct ToothView
{
    int tooth = -1;  ///< -1: the part has no teeth, all of it is shown
    Eigen::Rotation2Dd turn{0};

    [[nodiscard]] bool shows(WireMove const& move) const
    {
        bool const on_contour = move.tag == WireTag::contour || move.tag == WireTag::stop;
        return on_contour && (tooth < 0 || move.tooth == tooth);
    }
    [[nodiscard]] Polylines turned(std::vector<Vec2> points, double tolerance) const
    {
        for (auto& point : points)
            point = turn * point;
        return {thinned(points, tolerance)};
    }
};

/// The space with the highest residual; where there is none, the third one from the start, clear of leads and marks.
ToothView tooth_view(WireProgram const& program)
{
    ToothView view;
    int last = -1;
    for (auto const& move : program.passes.back().moves)
        last = std::max(last, move.tooth);
    auto const& all = program.residuals;
    auto const highest =
        std::max_element(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.height < b.height; });
    constexpr int third = 2;
    int const plain = program.closed()
                          ? std::min(third, last)
                          : (program.set_up.first + std::min(third, program.set_up.spaces - 1)) % program.teeth;
    view.tooth = highest != all.end() && highest->tooth >= 0 ? highest->tooth : plain;
    if (view.tooth >= 0)
        view.turn = Eigen::Rotation2Dd(2 * std::numbers::pi * view.tooth / program.teeth);
    return view;
}

/// The part of the last pass that is shown.
std::vector<WireMove> shown_moves(WireProgram const& program, ToothView const& view)
{
    std::vector<WireMove> moves;
    for (auto const& move : program.passes.back().moves)
        if (view.shows(move))
            moves.push_back({view.turn * move.lower, view.turn * move.upper, move.tag, move.tooth});
    return moves;
}

/// Around the wire and the contour next to it.
PlotWindow tooth_window(std::vector<WireMove> const& moves, double reach)
{
    PlotWindow window;
    for (auto const& move : moves) {
        window.take(move.lower);
        window.take(move.upper);
    }
    constexpr double air = 0.08;  // in widths of the drawing
    double const by = reach + air * window.width();
    window.widen(by, by);
    return window;
}

/// Sets places of the wire spread evenly along what is shown.
void set_wires(PlotData& data, std::vector<WireMove> const& moves, bool level)
{
    constexpr int wires_shown = 9;
    double length = 0;
    for (std::size_t i = 1; i < moves.size(); ++i)
        length += (moves[i].lower - moves[i - 1].lower).norm();
    PlotColumns lower, upper;
    double along = 0;
    int found = 0;
    for (std::size_t i = 0; i < moves.size() && found < wires_shown; ++i) {
        along += i > 0 ? (moves[i].lower - moves[i - 1].lower).norm() : 0;
        if (along < length * (found + 0.5) / wires_shown)
            continue;
        ++found;
        lower.row(moves[i].lower.x(), moves[i].lower.y());
        if (!level)
            upper.row(moves[i].upper.x(), moves[i].upper.y());
    }
    data.set("wires_lower", lower);
    data.set("wires_upper", upper);
}

/// Centre of the wire; the lead-in ends on the path.
std::vector<Vec2> wire_centres(WirePass const& pass, Vec2 WireMove::*face)
{
    std::vector<Vec2> path;
    for (auto const& move : pass.moves)
        if (move.tag != WireTag::thread && move.tag != WireTag::lead_out)
            path.push_back(move.*face);
    return path;
}

}  // namespace

std::string wire_tooth_script(WireProgram const& program)
{
    ToothView const view = tooth_view(program);
    auto const moves = shown_moves(program, view);
    auto const& last = program.passes.back();
    PlotWindow const window = tooth_window(moves, last.offset);
    bool const level = is_untilted(program);  // equal faces are drawn once
    WireFigures const figures = measured(program);
    PlotData data(program.name);
    data.set("space", view.tooth);
    data.set("face_shift", figures.face_shift * per_um);
    data.set("guide_shift", figures.guide_shift * per_um);
    data.set("upper_face", wedm::upper_face_words(figures));
    data.set("level", level);
    data.set("wire_diameter", program.wire_diameter);
    data.set("spark_gap", program.spark_gap);
    window.set_in(data);
    constexpr double finest_detail = 0.05;  // [px], what thinning may move a line
    double const tolerance = finest_detail * window.pixel();
    auto const set_line = [&](char const* name, std::vector<Vec2> const& points, bool shown) {
        data.set(name, shown ? PlotColumns(view.turned(points, tolerance)) : PlotColumns());
    };
    auto const closed = [](std::vector<Vec2> points) {
        points.push_back(points.front());
        return points;
    };
    set_line("lower", closed(program.nominal.lower), true);
    set_line("upper", closed(program.nominal.upper), !level);
    set_line("path_lower", wire_centres(last, &WireMove::lower), true);
    set_line("path_upper", wire_centres(last, &WireMove::upper), !level);
    PlotColumns earlier;
    for (std::size_t i = 0; i + 1 < program.passes.size(); ++i)
        earlier.append(PlotColumns(view.turned(wire_centres(program.passes[i], &WireMove::lower), tolerance)));
    data.set("earlier", earlier);
    set_wires(data, moves, level);
    return plot_script("wire_tooth", data);
}

}  // namespace hdconj::report
