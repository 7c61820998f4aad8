// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "plot_window.hpp"
#include "plots.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::report {
namespace {

PlotWindow ring_window(WireProgram const& program)
{
    PlotWindow window;
    window.take(program.nominal.lower);
    window.take(program.nominal.upper);
    window.take(program.passes.front().moves.front().lower);
    window.take(program.passes.front().moves.back().lower);
    constexpr double air = 0.04;
    window.widen(air * window.width(), air * window.width());
    return window;
}

/// Along the first twentieth of the path, in the void beside it.
std::vector<Vec2> direction_arrow(WireProgram const& program, PlotWindow const& window)
{
    auto const& moves = program.passes.front().moves;
    double const beside = program.external ? 1.06 : 0.93;
    Vec2 const centre = program.closed() ? window.middle() : Vec2(0, 0);
    auto const at = [&](double share) -> Vec2 {
        auto const i = static_cast<std::size_t>(share * static_cast<double>(moves.size()));
        return centre + beside * (moves[std::min(moves.size() - 1, i)].lower - centre);
    };
    constexpr double from = 0.05, to = 0.1;
    return {at(from), at(to)};
}

/// The path with its ends and stops.
void set_path(PlotData& data, WireProgram const& program, double tolerance)
{
    auto const& moves = program.passes.front().moves;
    std::vector<Vec2> path, in, out;
    PlotColumns marks;
    auto const mark = [&](Vec2 const& at, bool stop, char const* words) {
        marks.named_row(words, at.x(), at.y(), stop);
    };
    mark(moves.front().lower, false, program.closed() ? "start hole" : "start");
    if (!program.closed())
        mark(moves.back().lower, false, "end");
    for (std::size_t i = 0; i < moves.size(); ++i) {
        auto const& move = moves[i];
        if (move.tag == WireTag::thread || move.tag == WireTag::lead_in)
            in.push_back(move.lower);
        if (move.tag == WireTag::lead_out)
            out = {moves[i - 1].lower, move.lower};
        if (move.tag == WireTag::stop)
            mark(move.lower, true, "stop");
        if (move.tag != WireTag::thread && move.tag != WireTag::lead_out)
            path.push_back(move.lower);
    }
    data.set("path", PlotColumns({thinned(path, tolerance)}));
    data.set("leads", PlotColumns({in, out}));
    data.set("marks", marks);
}

}  // namespace

std::string wire_ring_script(WireProgram const& program)
{
    PlotWindow const window = ring_window(program);
    WireFigures const figures = measured(program);
    std::size_t blocks = 0;
    for (auto const& each : figures.passes)
        blocks += each.blocks;
    PlotData data(program.closed() ? program.name : program.name + ", " + wedm::set_up_words(program));
    data.set("passes", static_cast<double>(program.passes.size()));
    data.set("blocks", static_cast<double>(blocks));
    data.set("lower_inner", figures.lower.inner);
    data.set("lower_outer", figures.lower.outer);
    data.set("upper_inner", figures.upper.inner);
    data.set("upper_outer", figures.upper.outer);
    window.set_in(data);
    constexpr double finest_detail = 0.05;  // [px], what thinning may move a line
    double const tolerance = finest_detail * window.pixel();
    auto contour = program.nominal.lower;
    contour.push_back(contour.front());
    data.set("contour", PlotColumns({thinned(contour, tolerance)}));
    set_path(data, program, tolerance);
    data.set("arrow", PlotColumns({direction_arrow(program, window)}));
    return plot_script("wire_ring", data);
}

}  // namespace hdconj::report
