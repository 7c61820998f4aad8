// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "picture_palette.hpp"
#include "picture_plot.hpp"

namespace hdconj {
namespace {

using picture::line;
using picture::Plot;
using picture::Polylines;
using picture::Window;

constexpr char const* colour_material = picture::paper;
constexpr char const* colour_family = picture::light_grey;
constexpr char const* colour_tooth = picture::dark_grey;
constexpr char const* colour_outline = picture::black;
constexpr char const* colour_regular = picture::blue;
constexpr char const* colour_regular_unused = picture::light_blue;
constexpr char const* colour_corner = picture::vermilion;
constexpr char const* colour_corner_unused = picture::light_vermilion;

constexpr double seen_pitches = 1.06;  // width of the drawing in pitches
constexpr double margin = 0.16;        // above and below, in depths of the tooth space
constexpr double finest_detail = 0.1;  // [px], what thinning may move a line

/// The slice nearest to z = 0; empty where nothing was assembled.
std::vector<Vec2> middle_outline(CircularSplineOutline const& spline)
{
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < std::min(spline.z.size(), spline.outline.size()); ++k) {
        if (std::abs(spline.z[k]) < std::abs(spline.z[nearest])) {
            nearest = k;
        }
    }
    return spline.outline.empty() ? std::vector<Vec2>{} : spline.outline[nearest];
}

Window window_of(Solution const& solution, std::vector<Vec2> const& outline)
{
    double const half_angle = std::numbers::pi / solution.scene.drive.circular_spline_teeth;
    double const tip = solution.geometry.circular_spline_inner_radius;
    double const half = seen_pitches * tip * std::sin(half_angle);
    double low = tip * std::cos(half_angle), high = tip + solution.geometry.space_depth;
    for (auto const& point : outline) {
        low = std::min(low, point.y());
        high = std::max(high, point.y());
    }
    double const air = margin * (high - low);
    return {-half, half, low - air, high + air};
}

Polylines thinned(Polylines const& lines, double tolerance)
{
    Polylines result;
    for (auto const& line : lines) {
        result.push_back(hdconj::thinned(line, tolerance));
    }
    return result;
}

Polylines branches(Solution const& solution, bool corner, bool on_boundary)
{
    Polylines found;
    for (auto const& branch : solution.branches) {
        if ((branch.kind == "corner") == corner && branch.on_boundary == on_boundary) {
            found.push_back(branch.point);
        }
    }
    return found;
}

/// The tooth at the major axis, see write_dxf.
std::vector<Vec2> tooth_at_major_axis(Solution const& solution)
{
    auto tooth = solution.flexspline_outline;
    for (auto& point : tooth) {
        point.y() += solution.geometry.r_0 + solution.geometry.w0 + solution.geometry.pitch_line;
    }
    return tooth;
}

std::vector<Vec2> tip_circle(Solution const& solution, Window const& window)
{
    constexpr int steps = 32;
    double const radius = solution.geometry.circular_spline_inner_radius;
    std::vector<Vec2> arc;
    for (int i = 0; i <= steps; ++i) {
        double const x = window.left + (window.right - window.left) * i / steps;
        arc.emplace_back(x, std::sqrt(std::max(0.0, radius * radius - x * x)));
    }
    return arc;
}

/// The material on one side of the outline, closed beyond the frame: at the height @p beyond.
std::vector<Vec2> material(std::vector<Vec2> outline, Window const& window, double beyond)
{
    if (!outline.empty()) {
        outline.insert(outline.begin(), {{2 * window.left, beyond}, {2 * window.left, outline.front().y()}});
        outline.insert(outline.end(), {{2 * window.right, outline.back().y()}, {2 * window.right, beyond}});
    }
    return outline;
}

void add_material(Plot& plot, std::vector<Vec2> const& body)
{
    plot.add({body}, "filledcurves closed", fmt::format("fillstyle solid noborder linecolor rgb '{}'", colour_material), "");
}

std::string numbers_of(Solution const& solution)
{
    auto const& drive = solution.scene.drive;
    return fmt::format("m {:g} mm,  z_f {},  z_c {},  w0 {:g} mm", drive.module, drive.flexspline_teeth,
                       drive.circular_spline_teeth, solution.geometry.w0);
}

void add_branches(Plot& plot, Solution const& solution, double tolerance, bool on_boundary)
{
    auto const thin = [&](Polylines const& lines) { return thinned(lines, tolerance); };
    if (on_boundary) {
        plot.add(thin(branches(solution, false, true)), line(colour_regular, 1.9), "envelope on the boundary");
        plot.add(thin(branches(solution, true, true)), line(colour_corner, 1.9, "(6,4)"),
                 "path of a tooth corner, on the boundary");
        plot.add(thin(branches(solution, true, false)), line(colour_corner_unused, 1.4, "(6,4)"),
                 "path of a tooth corner, not on the boundary");
    } else {
        plot.add(thin(branches(solution, false, false)), line(colour_regular_unused, 1.6),
                 "envelope, not on the boundary");
    }
}

/// The reverse problem, in the frame of the flexspline tooth, y from its pitch line.
std::string reverse_script(Solution const& solution, PictureFormat format)
{
    auto const& geometry = solution.geometry;
    auto const& outline = solution.flexspline_outline;
    auto given = middle_outline(solution.circular_spline);
    double const pitch_radius = geometry.r_0 + geometry.w0 + geometry.pitch_line;
    double high = geometry.addendum;
    for (auto& point : given) {
        point.y() -= pitch_radius;
        high = std::max(high, point.y());
    }
    double const half = seen_pitches * std::numbers::pi / solution.scene.drive.flexspline_teeth * pitch_radius;
    double const air = margin * (high + geometry.dedendum);
    Window const window{-half, half, -geometry.dedendum - air, high + air};
    double const tolerance = finest_detail / window.scale();
    Plot plot(window);
    add_material(plot, material(outline, window, 2 * window.low - window.high));
    plot.add(thinned(solution.tooth_family, tolerance), line(colour_family, 0.7),
             fmt::format("circular-spline teeth, {} positions", solution.tooth_family.size()));
    add_branches(plot, solution, tolerance, false);
    plot.add(thinned({given}, tolerance), line(colour_tooth, 1.4), "circular spline at the major axis, given");
    plot.add(thinned({outline}, tolerance), line(colour_outline, 4.2), "flexspline tooth, solved for");
    add_branches(plot, solution, tolerance, true);
    picture::Words const words{solution.scene.drive.name,
                               "flexspline tooth, left free by the circular spline's:  " + numbers_of(solution),
                               "x [mm], across the tooth", "y [mm], from the pitch line"};
    return picture::terminal(format, window.height()) + picture::frame(window, words) + plot.text();
}

}  // namespace

std::string picture_script(Solution const& solution, PictureFormat format)
{
    if (solution.scene.is_reverse()) {
        return reverse_script(solution, format);
    }
    auto const outline = middle_outline(solution.circular_spline);
    Window const window = window_of(solution, outline);
    double const tolerance = finest_detail / window.scale();
    auto const thin = [&](Polylines const& lines) { return thinned(lines, tolerance); };
    Plot plot(window);
    add_material(plot, material(outline, window, 2 * window.high - window.low));
    plot.add(thin(solution.tooth_family), line(colour_family, 0.7),
             fmt::format("flexspline tooth, {} positions", solution.tooth_family.size()));
    add_branches(plot, solution, tolerance, false);
    plot.add({tip_circle(solution, window)}, line(colour_tooth, 0.9, "(12,4,2,4)"),
             "tip circle of the circular spline");
    plot.add(thin({tooth_at_major_axis(solution)}), line(colour_tooth, 1.4), "flexspline tooth at the major axis");
    plot.add(thin({outline}), line(colour_outline, 4.2), "circular spline");
    add_branches(plot, solution, tolerance, true);
    picture::Words const words{solution.scene.drive.name,
                               "tooth space of the circular spline, swept by the flexspline:  " + numbers_of(solution),
                               "x [mm], across the tooth space", "y [mm], from the axis of the drive"};
    return picture::terminal(format, window.height()) + picture::frame(window, words) + plot.text();
}

}  // namespace hdconj
