// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "hdconj/scene/schema.hpp"

namespace hdconj {

std::vector<Figure> geometry_figures(Solution const& solution)
{
    auto const& geometry = solution.geometry;
    return {{"ratio", geometry.ratio},
            {"r_m_mm", geometry.r_m},
            {"r_0_mm", geometry.r_0},
            {"r_0_less_r_m_um", (geometry.r_0 - geometry.r_m) * um_per_mm},
            {"w0_mm", geometry.w0},
            {"pitch_line_mm", geometry.pitch_line},
            {"addendum_mm", geometry.addendum},
            {"dedendum_mm", geometry.dedendum},
            {"flexspline_inner_radius_mm", geometry.flexspline_inner_radius},
            {"tip_radius_mm", geometry.circular_spline_inner_radius},
            {"space_depth_mm", geometry.space_depth},
            {"land_half_angle_deg", geometry.land_half_angle * degree_per_radian},
            {"land_width_mm", land_width(geometry)}};
}

std::vector<Figure> clearance_figures(Solution const& solution)
{
    if (!solution.check) {
        return {};
    }
    auto const& check = *solution.check;
    return {{"smallest_clearance_mm", check.smallest_clearance},
            {"clearance_error_mm", solution.error.clearance},
            {"clearance_x_mm", check.where.x()},
            {"clearance_y_mm", check.where.y()},
            {"clearance_phi_deg", check.at_phi * degree_per_radian},
            {"checked_points", static_cast<double>(check.points)},
            {"checked_positions", static_cast<double>(check.positions)}};
}

std::vector<Figure> error_figures(Solution const& solution)
{
    auto const& error = solution.error;
    return {{"error_chord_mm", error.chord},
            {"error_point_mm", error.point},
            {"error_largest_mm", error.largest()},
            {"error_cup_mm", error.cup},
            {"error_arc_length_relative", error.arc_length},
            {"error_r_0_mm", error.r_0},
            {"error_space_depth_mm", error.space_depth},
            {"error_land_width_mm", error.land},
            {"error_land_half_angle_deg", error.land / (2 * solution.geometry.circular_spline_inner_radius) * degree_per_radian},
            {"error_side_clearance_mm", error.side_clearance},
            {"error_zone_phi_deg", largest(solution.zones, &ConjugateZone::phi_error) * degree_per_radian},
            {"error_zone_t", largest(solution.zones, &ConjugateZone::t_error)}};
}

std::vector<Figure> figures(Solution const& solution)
{
    auto all = geometry_figures(solution);
    for (auto const& part : {clearance_figures(solution), error_figures(solution)}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

std::string given_member(Solution const& solution)
{
    return solution.scene.is_reverse() ? "circular spline" : "flexspline";
}

double total_seconds(Solution const& solution)
{
    double total = 0;
    for (auto const& entry : solution.timing) {
        total += entry.seconds;
    }
    return total;
}

double degrees_of(double angle)
{
    double const degrees = angle * degree_per_radian;
    if (!std::isfinite(degrees)) {
        return degrees;
    }
    for (int digits = 0; digits < std::numeric_limits<double>::digits10; ++digits) {
        std::string const text = fmt::format("{:.{}e}", degrees, digits);
        double given = 0;
        std::from_chars(text.data(), text.data() + text.size(), given);
        if (given * rad_per_deg == angle) {
            return given;
        }
    }
    return degrees;
}

double land_width(PairGeometry const& geometry)
{
    return 2 * geometry.land_half_angle * geometry.circular_spline_inner_radius;
}

double largest(std::vector<ConjugateZone> const& zones, double ConjugateZone::*error)
{
    double worst = 0;
    for (auto const& zone : zones) {
        worst = std::max(worst, zone.*error);
    }
    return worst;
}

std::size_t outline_points(Solution const& solution)
{
    auto const& slices = solution.circular_spline.outline;
    return slices.empty() ? 0 : slices.front().size();
}

}  // namespace hdconj
