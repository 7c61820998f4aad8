// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline_surface.hpp"

#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/segments.hpp"
#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/error.hpp"

namespace hdconj::io {
namespace {

Surface::Part part_at(std::vector<int> const& landmarks, std::size_t index)
{
    if (landmarks.size() != landmark_count)
        return Surface::land;
    auto const after = [&](std::size_t mark) { return index >= static_cast<std::size_t>(landmarks[mark]); };
    return after(4) || !after(0) ? Surface::land
           : !after(1)           ? Surface::left_flank
           : !after(3)           ? Surface::root
                                 : Surface::right_flank;
}

/// The slices; of a single one its two ends.
CircularSplineOutline with_width(Solution const& solution)
{
    if (!has_surface(solution)) {
        throw InputError(Fault{"circular_spline.width", 0, "",
                               "one slice has no surface unless the width of the circular spline is known",
                               "write its width in mm, or [slices] count = 9"});
    }
    CircularSplineOutline spline = solution.circular_spline;
    if (spline.outline.size() == 1) {
        double const half = *solution.scene.circular_spline.width / 2;
        spline.z = {-half, half};
        spline.outline.push_back(spline.outline.front());
    }
    for (auto const& slice : spline.outline)
        if (slice.size() != spline.outline.front().size() || spline.z.size() != spline.outline.size())
            throw std::logic_error("slices of the circular spline do not match each other or z");
    return spline;
}

/// @param spaces  1: open at both ends; more: all of them, the last point of a space and the first of the next joined
/// half way between them, which is where both are but for rounding when a slice ends in the middle of the land
Surface mesh(CircularSplineOutline const& spline, std::vector<std::size_t> const& kept, std::size_t spaces)
{
    bool const ring = spaces > 1;
    std::size_t const steps = kept.size() - 1;
    double const pitch = 2 * std::numbers::pi / static_cast<double>(spaces);
    std::size_t const across = ring ? spaces * steps : kept.size();
    if (across * spline.outline.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw std::length_error("a surface of more than 2^31 points");
    Surface surface;
    for (std::size_t k = 0; k < spline.outline.size(); ++k) {
        for (std::size_t i = 0; i < across; ++i) {
            Surface::Origin const origin{i / (ring ? steps : across), k, kept[ring ? i % steps : i]};
            auto const& outline = spline.outline[k];
            Vec2 point = outline[origin.index];
            if (ring && origin.index == 0)
                point = (point + turned_clockwise(outline.back(), -pitch)) / 2;
            point = turned_clockwise(point, pitch * static_cast<double>(origin.space));
            surface.points.push_back({point.x(), point.y(), spline.z[k]});
            surface.origin.push_back(origin);
        }
    }
    std::size_t const columns = ring ? across : steps;
    for (std::size_t k = 0; k + 1 < spline.outline.size(); ++k) {
        for (std::size_t i = 0; i < columns; ++i) {
            auto const point = [&](std::size_t slice, std::size_t place) {
                return static_cast<int>(slice * across + place % across);
            };
            surface.quads.push_back({point(k, i), point(k, i + 1), point(k + 1, i + 1), point(k + 1, i)});
            surface.part.push_back(part_at(spline.landmarks, kept[i % steps]));
        }
    }
    return surface;
}

}  // namespace

bool has_surface(Solution const& solution)
{
    auto const& slices = solution.circular_spline.outline;
    return !slices.empty() && slices.front().size() > 1 &&
           (slices.size() > 1 || solution.scene.circular_spline.width.has_value());
}

std::vector<std::size_t> kept_points(CircularSplineOutline const& spline, double tolerance)
{
    std::size_t const points = spline.outline.front().size();
    if (tolerance <= 0) {
        std::vector<std::size_t> all(points);
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    }
    std::vector<std::size_t> corners = {0}, kept = {0};
    corners.insert(corners.end(), spline.landmarks.begin(), spline.landmarks.end());
    corners.push_back(points - 1);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        if (corners[i] < corners[i + 1]) {
            keep_between(spline.outline, corners[i], corners[i + 1], tolerance, kept);
            kept.push_back(corners[i + 1]);
        }
    }
    return kept;
}

Surface tooth_surface(Solution const& solution)
{
    return spline_surface(solution, {.ring = false, .tolerance = 0});
}

Surface spline_surface(Solution const& solution, SurfaceOptions const& options)
{
    auto const spline = with_width(solution);
    auto const spaces = options.ring ? static_cast<std::size_t>(solution.scene.drive.circular_spline_teeth) : 1;
    return mesh(spline, kept_points(spline, options.tolerance), spaces);
}

}  // namespace hdconj::io
