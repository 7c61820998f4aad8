// SPDX-License-Identifier: GPL-3.0-or-later
#include "chord_moved.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hdconj::conjugate {

double chord_moved_radially(std::vector<Vec2> const& points, double chord, double distance)
{
    double least = std::numeric_limits<double>::infinity(), bend = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double const here = points[i].norm();
        if (i > 0) {
            Vec2 const along = points[i] - points[i - 1];
            double const nearest = std::min(here, points[i - 1].norm());
            double const across = std::abs(cross(points[i], along)),
                         up = std::max(std::abs(points[i].dot(along)), std::abs(points[i - 1].dot(along)));
            bend = std::max(bend, across * std::hypot(2 * up, across) / std::pow(nearest, 4));
        }
        least = std::min(least, here);
    }
    return chord * (1 + std::max(0.0, distance) / least) + std::abs(distance) * bend / 8;
}

double largest_radial_shift(Scene const& scene)
{
    if (!scene.tilt || scene.tilt->kind != TiltKind::radial || !scene.slices || scene.slices->count < 2)
        return 0;
    return 0.5 * scene.circular_spline.width.value_or(0) * std::tan(std::abs(scene.tilt->angle));
}

}  // namespace hdconj::conjugate
