// SPDX-License-Identifier: GPL-3.0-or-later
#include "faces.hpp"

#include <numbers>

#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::wedm {

Vec2 turned_to(Vec2 const& point, int space, int teeth)
{
    return space == 0 ? point : turned_clockwise(point, 2 * std::numbers::pi * space / teeth);
}

std::vector<Vec2> turned_to(std::vector<Vec2> const& points, int space, int teeth)
{
    std::vector<Vec2> turned;
    turned.reserve(points.size());
    for (Vec2 const& p : points)
        turned.push_back(turned_to(p, space, teeth));
    return turned;
}

std::vector<Vec2> with_neighbours(std::vector<Vec2> const& points, WireFaces const& faces, std::size_t more)
{
    std::vector<Vec2> line;
    // the last point of the pitch before is this one's first
    for (std::size_t i = points.size() - 1 - more; i + 1 < points.size(); ++i)
        line.push_back(turned_to(points[i], -faces.next(), faces.teeth));
    line.insert(line.end(), points.begin(), points.end());
    for (std::size_t i = 1; i <= more; ++i)
        line.push_back(turned_to(points[i], faces.next(), faces.teeth));
    return line;
}

}  // namespace hdconj::wedm
