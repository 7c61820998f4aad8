// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "picture_palette.hpp"
#include "picture_plot.hpp"
#include "summary_figures.hpp"
#include "wire_post.hpp"
#include "wire_scripts.hpp"

namespace hdconj {
namespace {

using picture::line;
using picture::Plot;
using picture::Polylines;
using picture::Window;

constexpr char const* colour_wire = picture::pale_blue;
constexpr char const* colour_lower = picture::black;
constexpr char const* colour_upper = picture::vermilion;
constexpr char const* colour_lower_wire = picture::blue;
constexpr char const* colour_upper_wire = picture::orange;
constexpr char const* colour_earlier = picture::grey;

constexpr double margin = 0.08;         // around, in widths of the drawing
constexpr double finest_detail = 0.05;  // [px], what thinning may move a line
constexpr int wires_shown = 9;

/// The tooth space that is shown, and the turn that brings its middle onto the y axis.
struct View
{
    int tooth = -1;  ///< -1: the part has no teeth, all of it is shown
    double cosine = 1, sine = 0;

    [[nodiscard]] Vec2 turned(Vec2 const& p) const { return {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()}; }
    [[nodiscard]] bool shows(WireMove const& move) const
    {
        bool const on_contour = move.tag == WireTag::contour || move.tag == WireTag::stop;
        return on_contour && (tooth < 0 || move.tooth == tooth);
    }
};

/// The space with the highest residual; where there is none, the third one from the start, clear of leads and marks.
View view_of(WireProgram const& program)
{
    View view;
    int last = -1;
    for (auto const& move : program.passes.back().moves) {
        last = std::max(last, move.tooth);
    }
    auto const& all = program.residuals;
    auto const highest = std::max_element(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.height < b.height; });
    constexpr int third = 2;
    int const plain = program.closed() ? std::min(third, last) : (program.set_up.first + std::min(third, program.set_up.spaces - 1)) % program.teeth;
    view.tooth = highest != all.end() && highest->tooth >= 0 ? highest->tooth : plain;
    Vec2 sum = Vec2::Zero();
    for (auto const& move : program.passes.back().moves) {
        sum += view.tooth >= 0 && view.shows(move) ? move.lower : Vec2(0, 0);
    }
    if (sum.norm() > 0) {
        view.cosine = sum.y() / sum.norm();
        view.sine = sum.x() / sum.norm();
    }
    return view;
}

/// The part of the last pass that is shown.
std::vector<WireMove> shown_moves(WireProgram const& program, View const& view)
{
    std::vector<WireMove> moves;
    for (auto const& move : program.passes.back().moves) {
        if (view.shows(move)) {
            moves.push_back(move);
        }
    }
    return moves;
}

/// Around the wire and the contour next to it.
Window window_of(std::vector<WireMove> const& moves, View const& view, double reach)
{
    Window window{1, -1, 1, -1};
    bool first = true;
    for (auto const& move : moves) {
        for (Vec2 const& at : {view.turned(move.lower), view.turned(move.upper)}) {
            window.left = first ? at.x() : std::min(window.left, at.x());
            window.right = first ? at.x() : std::max(window.right, at.x());
            window.low = first ? at.y() : std::min(window.low, at.y());
            window.high = first ? at.y() : std::max(window.high, at.y());
            first = false;
        }
    }
    double const air = reach + margin * (window.right - window.left);
    return {window.left - air, window.right + air, window.low - air, window.high + air};
}

/// The pieces of a line that pass through the window, with some of what is outside; the others would only make the file large.
Polylines cut(std::vector<Vec2> const& points, View const& view, Window const& window, bool closed)
{
    double const beyond = (window.right - window.left) / 2;
    Polylines pieces;
    bool inside = false;
    std::size_t const count = points.size() + (closed && !points.empty() ? 1 : 0);
    std::vector<Vec2> turned;
    for (std::size_t k = 0; k < count; ++k) {
        turned.push_back(view.turned(points[k % points.size()]));
    }
    auto const is_near = [&](Vec2 const& a, Vec2 const& b) {
        return std::max(a.x(), b.x()) > window.left - beyond && std::min(a.x(), b.x()) < window.right + beyond &&
               std::max(a.y(), b.y()) > window.low - beyond && std::min(a.y(), b.y()) < window.high + beyond;
    };
    for (std::size_t k = 0; k + 1 < turned.size(); ++k) {
        bool const near = is_near(turned[k], turned[k + 1]);
        if (near && !inside) {
            pieces.push_back({turned[k]});
        }
        if (near) {
            pieces.back().push_back(turned[k + 1]);
        }
        inside = near;
    }
    double const tolerance = finest_detail / window.scale();
    for (auto& piece : pieces) {
        piece = thinned(piece, tolerance);
    }
    return pieces;
}

std::vector<Vec2> circle(Vec2 const& centre, double radius)
{
    constexpr int steps = 72;
    std::vector<Vec2> points;
    for (int i = 0; i <= steps; ++i) {
        points.emplace_back(centre + radius * direction(2 * std::numbers::pi * i / steps));
    }
    return points;
}

/// Circles about the wire at places spread evenly along what is shown.
Polylines circles(std::vector<WireMove> const& moves, View const& view, double radius, bool upper)
{
    Polylines found;
    double length = 0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        length += (moves[i].lower - moves[i - 1].lower).norm();
    }
    double along = 0;
    int next = 0;
    for (std::size_t i = 0; i < moves.size() && next < wires_shown; ++i) {
        along += i > 0 ? (moves[i].lower - moves[i - 1].lower).norm() : 0;
        if (along >= length * (next + 0.5) / wires_shown) {
            found.push_back(circle(view.turned(upper ? moves[i].upper : moves[i].lower), radius));
            ++next;
        }
    }
    return found;
}

std::vector<Vec2> path_of(WirePass const& pass, bool upper)
{
    std::vector<Vec2> path;
    for (auto const& move : pass.moves) {
        if (move.tag != WireTag::thread && move.tag != WireTag::lead_out) {  // the lead-in ends on the path
            path.push_back(upper ? move.upper : move.lower);
        }
    }
    return path;
}

}  // namespace

std::string wire_tooth_script(WireProgram const& program, PictureFormat format)
{
    View const view = view_of(program);
    auto const moves = shown_moves(program, view);
    auto const& last = program.passes.back();
    Window const window = window_of(moves, view, last.offset);
    WireFigures const figures = measured(program);
    auto const radius = program.wire_diameter / 2;
    auto const wire = circles(moves, view, radius, false);
    Plot plot(window);
    for (auto const& disc : wire) {
        plot.add({disc}, "filledcurves closed", fmt::format("fillstyle solid noborder linecolor rgb '{}'", colour_wire), "");
    }
    Polylines earlier;
    for (std::size_t i = 0; i + 1 < program.passes.size(); ++i) {
        auto const pieces = cut(path_of(program.passes[i], false), view, window, false);
        earlier.insert(earlier.end(), pieces.begin(), pieces.end());
    }
    plot.add(earlier, line(colour_earlier, 0.8), "centre of the wire, lower face, earlier passes");
    // equal faces are drawn once
    bool const level = is_untilted(program);
    std::string const face = level ? "both faces" : "lower face";
    plot.add(cut(program.nominal.lower, view, window, true), line(colour_lower, 2.6), "contour of the part, " + face);
    if (!level) {
        plot.add(cut(program.nominal.upper, view, window, true), line(colour_upper, 2.2), "contour of the part, upper face");
    }
    plot.add(cut(path_of(last, false), view, window, false), line(colour_lower_wire, 1.7), "centre of the wire, " + face + ", last pass");
    if (!level) {
        plot.add(cut(path_of(last, true), view, window, false), line(colour_upper_wire, 1.6), "centre of the wire, upper face, last pass");
    }
    plot.add(wire, line(colour_lower_wire, 0.9), fmt::format("wire, {:g} mm, {}", program.wire_diameter, face));
    plot.add(circles(moves, view, radius + program.spark_gap, false), line(colour_lower_wire, 0.65, "(3,3)"),
             fmt::format("what it cuts there, gap {:g} mm", program.spark_gap));
    if (!level) {
        plot.add(circles(moves, view, radius, true), line(colour_upper_wire, 0.8), "wire, upper face, the same moves");
    }
    std::string const where = view.tooth < 0 ? "the whole part" : fmt::format("tooth space {}", view.tooth);
    picture::Words const words{program.name,
                               fmt::format("{};  face shift {:.4g} µm,  guide offset {:.4g} µm,  upper face {}", where,
                                           figures.face_shift * um_per_mm, figures.guide_shift * um_per_mm,
                                           upper_face_words(figures)),
                               view.tooth < 0 ? "x [mm]" : "x [mm], across the tooth space", view.tooth < 0 ? "y [mm]" : "y [mm], from the axis of the part"};
    return picture::terminal(format, window.height()) + picture::frame(window, words) + plot.text();
}

}  // namespace hdconj
