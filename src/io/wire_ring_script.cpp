// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "picture_palette.hpp"
#include "picture_plot.hpp"
#include "wire_post.hpp"
#include "wire_scripts.hpp"

namespace hdconj {
namespace {

using picture::line;
using picture::Plot;
using picture::Window;

constexpr char const* colour_contour = picture::black;
constexpr char const* colour_wire = picture::blue;
constexpr char const* colour_lead = picture::vermilion;
constexpr char const* colour_stop = picture::purple;

constexpr double margin = 0.04;         // around, in widths of the drawing
constexpr double finest_detail = 0.05;  // [px], what thinning may move a line

Window window_of(WireProgram const& program)
{
    Window window{0, 0, 0, 0};
    auto const take = [&](Vec2 const& at) {
        window = {std::min(window.left, at.x()), std::max(window.right, at.x()), std::min(window.low, at.y()), std::max(window.high, at.y())};
    };
    Vec2 const first = program.nominal.lower.front();
    window = {first.x(), first.x(), first.y(), first.y()};
    for (auto const* face : {&program.nominal.lower, &program.nominal.upper}) {
        for (auto const& point : *face) {
            take(point);
        }
    }
    take(program.passes.front().moves.front().lower);
    take(program.passes.front().moves.back().lower);
    double const air = margin * (window.right - window.left);
    return {window.left - air, window.right + air, window.low - air, window.high + air};
}

std::string mark(Vec2 const& at, char const* text, char const* colour, double turn)
{
    return fmt::format("set label {} at first {:.6f},{:.6f} point pointtype 7 pointsize 0.8 linecolor rgb '{}' offset 0.9,{} noenhanced textcolor "
                       "rgb '{}' front\n",
                       gnuplot_quoted(text), at.x(), at.y(), colour, turn, colour);
}

/// Start hole, direction of travel, and stop.
std::string marks(WirePass const& pass, bool closed)
{
    std::string script = mark(pass.moves.front().lower, closed ? "start hole" : "start", colour_lead, 0.5);
    if (!closed) {
        script += mark(pass.moves.back().lower, "end", colour_lead, 0.5);
    }
    for (auto const& move : pass.moves) {
        if (move.tag == WireTag::stop) {
            script += mark(move.lower, "stop", colour_stop, -0.9);
        }
    }
    return script;
}

/// An arrow along the first twentieth of the path.
std::string arrow(WireProgram const& program, Window const& window)
{
    auto const& pass = program.passes.front();
    constexpr double from = 0.05, to = 0.1;
    double const inside = program.external ? 1.06 : 0.93;  // in the void
    std::size_t const count = pass.moves.size();
    auto const at = [&](double share) { return pass.moves[std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)))].lower; };
    Vec2 const middle((window.left + window.right) / 2, (window.low + window.high) / 2);
    Vec2 const centre = program.closed() ? middle : Vec2(0, 0);
    Vec2 const a = centre + inside * (at(from) - centre), b = centre + inside * (at(to) - centre);
    return fmt::format("set arrow from first {:.6f},{:.6f} to first {:.6f},{:.6f} head filled size screen 0.014,18 linecolor rgb '{}' linewidth 1.6 front\n",
                       a.x(), a.y(), b.x(), b.y(), colour_wire);
}

}  // namespace

std::string wire_ring_script(WireProgram const& program, PictureFormat format)
{
    Window const window = window_of(program);
    double const tolerance = finest_detail / window.scale();
    auto contour = program.nominal.lower;
    contour.push_back(contour.front());
    auto const& pass = program.passes.front();
    std::vector<Vec2> wire, in, out;
    for (std::size_t i = 0; i < pass.moves.size(); ++i) {
        auto const& move = pass.moves[i];
        if (move.tag == WireTag::thread || move.tag == WireTag::lead_in) {
            in.push_back(move.lower);
        } else if (move.tag == WireTag::lead_out) {
            out = {pass.moves[i - 1].lower, move.lower};
        }
        if (move.tag != WireTag::thread && move.tag != WireTag::lead_out) {
            wire.push_back(move.lower);
        }
    }
    Plot plot(window);
    plot.add({thinned(contour, tolerance)}, line(colour_contour, 1.6), "contour of the part, lower face");
    plot.add({thinned(wire, tolerance)}, line(colour_wire, 0.9), "centre of the wire, lower face, first pass");
    plot.add({in, out}, line(colour_lead, 1.5), "straight in and out");
    WireFigures const figures = measured(program);
    std::size_t blocks = 0;
    for (auto const& each : figures.passes) {
        blocks += each.blocks;
    }
    picture::Words const words{program.closed() ? program.name : program.name + ", " + set_up_words(program),
                               fmt::format("{} pass{}, {} blocks;  lower face {:.4f} to {:.4f} mm, upper face {:.4f} to {:.4f} mm from the axis",
                                           program.passes.size(), program.passes.size() == 1 ? "" : "es", blocks, figures.lower.inner,
                                           figures.lower.outer, figures.upper.inner, figures.upper.outer),
                               "x [mm]", "y [mm]"};
    return picture::terminal(format, window.height()) + picture::frame(window, words) + marks(pass, program.closed()) + arrow(program, window) + plot.text();
}

}  // namespace hdconj
