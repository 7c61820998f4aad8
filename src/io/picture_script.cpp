// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "picture_lines.hpp"

namespace hdconj {
namespace {

using Polylines = std::vector<std::vector<Vec2>>;

// Colours that stay apart for colour-blind eyes and in grey print.
constexpr char const* colour_material = "#f1efe9";
constexpr char const* colour_family = "#c4c4c4";
constexpr char const* colour_tooth = "#5f5f5f";
constexpr char const* colour_outline = "#000000";
constexpr char const* colour_regular = "#0072b2";
constexpr char const* colour_regular_unused = "#9ccbe6";
constexpr char const* colour_corner = "#d55e00";
constexpr char const* colour_corner_unused = "#efb790";

constexpr double picture_width = 1000;  // [px]
constexpr double frame_sides = 130;     // [px], what axes and labels need beside the drawing
constexpr double frame_ends = 230;      // [px], above and below: title, labels, legend
constexpr double seen_pitches = 1.06;   // width of the drawing in pitches
constexpr double margin = 0.16;         // above and below, in depths of the tooth space
constexpr double finest_detail = 0.1;   // [px], what thinning may move a line

/// What is seen, in the circular-spline frame [mm].
struct Window
{
    double left = 0, right = 0, low = 0, high = 0;
    [[nodiscard]] double scale() const { return (picture_width - frame_sides) / (right - left); }    // [px/mm]
    [[nodiscard]] double height() const { return std::round((high - low) * scale() + frame_ends); }  // [px]
};

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

/// The material outside the outline, closed beyond the frame.
std::vector<Vec2> material(std::vector<Vec2> outline, Window const& window)
{
    if (!outline.empty()) {
        double const beyond = 2 * window.high - window.low;
        outline.insert(outline.begin(), {{2 * window.left, beyond}, {2 * window.left, outline.front().y()}});
        outline.insert(outline.end(), {{2 * window.right, outline.back().y()}, {2 * window.right, beyond}});
    }
    return outline;
}

/// Collects data blocks and the plot command; leaves out what is empty.
class Plot
{
  public:
    void add(Polylines const& lines, std::string const& look, std::string const& legend)
    {
        std::string block;
        for (auto const& line : lines) {
            for (auto const& point : line) {
                fmt::format_to(std::back_inserter(block), "{:.6f} {:.6f}\n", point.x(), point.y());
            }
            block += line.empty() ? "" : "\n";
        }
        if (block.empty()) {
            return;
        }
        ++count_;
        data_ += fmt::format("$data{} << END\n{}END\n", count_, block);
        command_ += fmt::format("{} $data{} using 1:2 with {} {}", command_.empty() ? "plot" : ", \\\n    ", count_,
                                look, legend.empty() ? "notitle" : "title " + gnuplot_quoted(legend));
    }
    [[nodiscard]] std::string text() const { return data_ + command_ + '\n'; }

  private:
    std::string data_, command_;
    int count_ = 0;
};

std::string line(char const* colour, double width, char const* dash = "solid")
{
    return fmt::format("lines linecolor rgb '{}' linewidth {} dashtype {}", colour, width, dash);
}

std::string terminal(PictureFormat format, Window const& window)
{
    constexpr int font_size = 15;
    if (format == PictureFormat::svg) {
        return fmt::format(
            "set terminal svg size {},{} fixed font 'DejaVu Sans,{}' background rgb 'white' linewidth 1 dashlength 1\n",
            picture_width, window.height(), font_size);
    }
    constexpr int finer = 2;  // for screens with many pixels
    return fmt::format("set terminal pngcairo size {},{} font 'DejaVu Sans,{}' fontscale 1 linewidth {} dashlength 1\n",
                       finer * picture_width, finer * window.height(), 0.75 * finer * font_size, finer);
}

std::string frame(Solution const& solution, Window const& window)
{
    auto const& drive = solution.scene.drive;
    auto const title = fmt::format(
        "{}: circular spline that meshes with the flexspline (z_f {}, z_c {}, m {:g} mm, w0 {:g} mm)", drive.name,
        drive.flexspline_teeth, drive.circular_spline_teeth, drive.module, solution.geometry.w0);
    return fmt::format(
        "set encoding utf8\n"
        "set title {} noenhanced offset 0,0.3\n"
        "set xlabel 'x [mm], across the tooth space' noenhanced offset 0,0.4\n"
        "set ylabel 'y [mm], from the axis of the drive' noenhanced offset -0.5,0\n"
        "set xrange [{:.6f}:{:.6f}]\nset yrange [{:.6f}:{:.6f}]\n"
        "set size ratio -1\n"
        "set border 3 linecolor rgb '#808080' linewidth 0.8\n"
        "set tics nomirror out scale 0.6 textcolor rgb '#303030'\n"
        "set format '%.1f'\nset xtics 0.1\nset ytics 0.1\n"
        "set key noenhanced outside bottom center horizontal Left reverse maxcols 2 samplen 2.6 spacing 1.25 width 2\n",
        gnuplot_quoted(title), window.left, window.right, window.low, window.high);
}

}  // namespace

std::string picture_script(Solution const& solution, PictureFormat format)
{
    auto const outline = middle_outline(solution.circular_spline);
    Window const window = window_of(solution, outline);
    double const tolerance = finest_detail / window.scale();
    auto const thin = [&](Polylines const& lines) { return thinned(lines, tolerance); };
    Plot plot;
    plot.add({material(outline, window)},
             fmt::format("filledcurves closed fillstyle solid noborder linecolor rgb '{}'", colour_material), "");
    plot.add(thin(solution.tooth_family), line(colour_family, 0.7),
             fmt::format("flexspline tooth, {} positions", solution.tooth_family.size()));
    plot.add(thin(branches(solution, false, false)), line(colour_regular_unused, 1.6), "envelope, not on the boundary");
    plot.add(thin(branches(solution, true, false)), line(colour_corner_unused, 1.4, "(6,4)"),
             "path of a tooth corner, not on the boundary");
    plot.add({tip_circle(solution, window)}, line(colour_tooth, 0.9, "(12,4,2,4)"),
             "tip circle of the circular spline");
    plot.add(thin({tooth_at_major_axis(solution)}), line(colour_tooth, 1.4), "flexspline tooth at the major axis");
    plot.add(thin({outline}), line(colour_outline, 4.2), "circular spline");
    plot.add(thin(branches(solution, false, true)), line(colour_regular, 1.9), "envelope on the boundary");
    plot.add(thin(branches(solution, true, true)), line(colour_corner, 1.9, "(6,4)"),
             "path of a tooth corner on the boundary");
    return terminal(format, window) + frame(solution, window) + plot.text();
}

}  // namespace hdconj
