// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plot_window.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

/// The slice nearest to z = 0; empty where nothing was assembled.
std::vector<Vec2> middle_outline(CircularSplineOutline const& spline)
{
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < std::min(spline.z.size(), spline.outline.size()); ++k)
        if (std::abs(spline.z[k]) < std::abs(spline.z[nearest]))
            nearest = k;
    return spline.outline.empty() ? std::vector<Vec2>{} : spline.outline[nearest];
}

/// One tooth is given, the other solved for.
struct ToothDrawing
{
    std::vector<Vec2> outline;     ///< solved for
    std::vector<Vec2> tooth;       ///< the given one at the major axis
    std::vector<Vec2> tip_circle;  ///< empty: not drawn
    PlotWindow window;
};

/// Sets the window's width in pitches, and its height with some air.
void fit_window(PlotWindow& window, double half_pitch)
{
    constexpr double seen_pitches = 1.06, air = 0.16;  // in depths of the tooth space
    window.widen(seen_pitches * half_pitch - window.width() / 2, air * window.height());
}

/// In the frame of the circular spline.
ToothDrawing forward_drawing(Solution const& solution)
{
    auto const& geometry = solution.geometry;
    ToothDrawing drawing{middle_outline(solution.circular_spline), solution.flexspline_outline, {}, {}};
    double const half_angle = std::numbers::pi / solution.scene.drive.circular_spline_teeth;
    double const tip = geometry.circular_spline_inner_radius;
    drawing.window.take({0, tip * std::cos(half_angle)});
    drawing.window.take({0, tip + geometry.space_depth});
    for (auto const& point : drawing.outline)
        drawing.window.take({0, point.y()});
    fit_window(drawing.window, tip * std::sin(half_angle));
    for (auto& point : drawing.tooth)
        point.y() += geometry.r_0 + geometry.w0 + geometry.pitch_line;
    constexpr int steps = 32;
    for (int i = 0; i <= steps; ++i) {
        double const x = drawing.window.low().x() + drawing.window.width() * i / steps;
        drawing.tip_circle.emplace_back(x, std::sqrt(std::max(0.0, tip * tip - x * x)));
    }
    return drawing;
}

/// In the frame of the flexspline tooth, y from its pitch line.
ToothDrawing reverse_drawing(Solution const& solution)
{
    auto const& geometry = solution.geometry;
    ToothDrawing drawing{solution.flexspline_outline, middle_outline(solution.circular_spline), {}, {}};
    double const pitch_radius = geometry.r_0 + geometry.w0 + geometry.pitch_line;
    drawing.window.take({0, -geometry.dedendum});
    drawing.window.take({0, geometry.addendum});
    for (auto& point : drawing.tooth) {
        point.y() -= pitch_radius;
        drawing.window.take({0, std::max(point.y(), -geometry.dedendum)});
    }
    fit_window(drawing.window, std::numbers::pi / solution.scene.drive.flexspline_teeth * pitch_radius);
    return drawing;
}

/// The material on one side of the outline, closed beyond the frame.
std::vector<Vec2> material_of(ToothDrawing const& drawing, bool above)
{
    auto const& window = drawing.window;
    double const beyond = above ? window.high().y() + window.height() : window.low().y() - window.height();
    double const left = 2 * window.low().x(), right = 2 * window.high().x();
    auto body = drawing.outline;
    if (!body.empty()) {
        body.insert(body.begin(), {{left, beyond}, {left, body.front().y()}});
        body.insert(body.end(), {{right, body.back().y()}, {right, beyond}});
    }
    return body;
}

Polylines branch_lines(Solution const& solution, bool corner, bool on_boundary)
{
    Polylines found;
    for (auto const& branch : solution.branches)
        if ((branch.kind == "corner") == corner && branch.on_boundary == on_boundary)
            found.push_back(branch.point);
    return found;
}

}  // namespace

std::string tooth_space_script(Solution const& solution)
{
    bool const reverse = solution.scene.is_reverse();
    auto const& drive = solution.scene.drive;
    ToothDrawing const drawing = reverse ? reverse_drawing(solution) : forward_drawing(solution);
    PlotData data(drive.name);
    data.set("reverse", reverse);
    data.set("module", drive.module);
    data.set("z_f", drive.flexspline_teeth);
    data.set("z_c", drive.circular_spline_teeth);
    data.set("w0", solution.geometry.w0);
    data.set("positions", static_cast<double>(solution.tooth_family.size()));
    drawing.window.set_in(data);
    data.set("material", PlotColumns({material_of(drawing, !reverse)}));
    auto const set_lines = [&](char const* name, Polylines const& lines) {
        constexpr double finest_detail = 0.1;  // [px], what thinning may move a line
        data.set(name, PlotColumns(thinned(lines, finest_detail * drawing.window.pixel())));
    };
    set_lines("family", solution.tooth_family);
    set_lines("branch", branch_lines(solution, false, false));
    set_lines("tip_circle", {drawing.tip_circle});
    set_lines("tooth", {drawing.tooth});
    set_lines("outline", {drawing.outline});
    set_lines("boundary", branch_lines(solution, false, true));
    set_lines("boundary_corner", branch_lines(solution, true, true));
    set_lines("corner", branch_lines(solution, true, false));
    return plot_script("tooth_space", data);
}

}  // namespace hdconj::report
