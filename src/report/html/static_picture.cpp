// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_picture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::report {
namespace {

constexpr int teeth_beside = 7;      // shown on either side of the major axis
constexpr double least_turn = 0.05;  // [rad] between points that are kept: the picture is small

/// Adds @p points, y upward, turned clockwise by @p angle, to the data of a path: where the outline has turned by some
/// degrees, and its corners.
void add_points(std::string& path, std::vector<Vec2> const& points, double angle, Vec2 const& from)
{
    Vec2 last = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool const is_end = i == 0 || i + 1 == points.size();
        Vec2 const ahead = is_end ? Vec2(1, 0) : Vec2(points[i + 1] - points[i]), behind = points[i] - last;
        double const turn = ahead.x() * behind.y() - ahead.y() * behind.x();
        if (!is_end && std::abs(turn) < least_turn * ahead.norm() * behind.norm())
            continue;
        last = points[i];
        Vec2 const p = turned_clockwise(points[i], angle) - from;
        fmt::format_to(std::back_inserter(path), "{}{:.3f} {:.3f}", path.empty() ? 'M' : 'L', p.x(), -p.y());
    }
}

}  // namespace

std::string static_picture(ReportedDrive const& drive)
{
    if (!drive.teeth)
        return "";
    TurningTeeth const& teeth = *drive.teeth;
    Drive const& numbers = drive.solution.scene.drive;
    std::size_t const plane = teeth.z.size() / 2;
    double const pitch_f = 2 * std::numbers::pi / numbers.flexspline_teeth;
    double const pitch_c = 2 * std::numbers::pi / numbers.circular_spline_teeth;
    Vec2 const middle{0, drive.solution.geometry.circular_spline_inner_radius};
    std::string spline, flexspline;
    for (int i = -teeth_beside; i <= teeth_beside; ++i) {
        add_points(spline, drive.outline().outline[plane], i * pitch_c, middle);
        double const phi = i * pitch_f;
        double const place = std::remainder(phi, teeth.period) * teeth.steps / teeth.period;
        auto const j =
            plane * static_cast<std::size_t>(teeth.steps) +
            static_cast<std::size_t>(std::lround(place) + teeth.steps) % static_cast<std::size_t>(teeth.steps);
        double const lean = phi + teeth.lean[j], polar = phi + teeth.advance[j];
        Vec2 const origin = turned_clockwise({0, teeth.radius[j]}, polar);
        add_points(flexspline, teeth.tooth, lean, middle - origin);
    }
    double const height = 6 * numbers.module, width = 2 * teeth_beside * pitch_c * middle.y();
    return fmt::format(
        "<svg class=\"static\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"{:.2f} {:.2f} "
        "{:.2f} {:.2f}\"><title>Teeth at the major axis</title><path class=\"spline\" d=\"{}\"/>"
        "<path class=\"flexspline\" d=\"{}\"/></svg>",
        -width / 2, -height / 2, width, height, spline, flexspline);
}

}  // namespace hdconj::report
