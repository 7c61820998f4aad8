// SPDX-License-Identifier: GPL-3.0-or-later
#include "section_point.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hdconj::elastic {

std::array<double, 8> shape_functions(double x, double y)
{
    return {(1 - x) * (1 - y) * (-x - y - 1) / 4,
            (1 + x) * (1 - y) * (x - y - 1) / 4,
            (1 + x) * (1 + y) * (x + y - 1) / 4,
            (1 - x) * (1 + y) * (-x + y - 1) / 4,
            (1 - x * x) * (1 - y) / 2,
            (1 + x) * (1 - y * y) / 2,
            (1 - x * x) * (1 + y) / 2,
            (1 - x) * (1 - y * y) / 2};
}

std::array<Vec2, 8> shape_slopes(double x, double y)
{
    return {Vec2((1 - y) * (2 * x + y) / 4, (1 - x) * (x + 2 * y) / 4),
            Vec2((1 - y) * (2 * x - y) / 4, (1 + x) * (2 * y - x) / 4),
            Vec2((1 + y) * (2 * x + y) / 4, (1 + x) * (x + 2 * y) / 4),
            Vec2((1 + y) * (2 * x - y) / 4, (1 - x) * (2 * y - x) / 4),
            Vec2(-x * (1 - y), -(1 - x * x) / 2),
            Vec2((1 - y * y) / 2, -y * (1 + x)),
            Vec2(-x * (1 + y), (1 - x * x) / 2),
            Vec2(-(1 - y * y) / 2, -y * (1 - x))};
}

Vec2 position(SectionMesh const& mesh, SectionPoint const& point)
{
    auto const n = shape_functions(point.xi, point.eta);
    QuadraticElement const& element = mesh.elements[point.element];
    Vec2 at = Vec2::Zero();
    for (std::size_t a = 0; a < n.size(); ++a)
        at += n[a] * mesh.nodes[static_cast<std::size_t>(element[a])];
    return at;
}

SectionPoint wall_point(SectionMesh const& mesh, double z, double depth)
{
    if (!(depth >= 0 && depth <= 1))
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", "place in the wall",
                             "its depth must be from 0 (inner surface) to 1 (outer surface)");
    auto const layers = static_cast<std::size_t>(mesh.layers);
    std::size_t const rows = mesh.wall_elements() / layers;
    auto const height = [&](std::size_t row, int corner) {
        return mesh.nodes[static_cast<std::size_t>(mesh.elements[row * layers][static_cast<std::size_t>(corner)])].y();
    };
    auto const first = static_cast<std::size_t>(mesh.straight);
    double const low = height(first, 0), high = height(rows - 1, 3);
    constexpr double rounding = 1e-12;  // of heights that were divided and added up again
    double const beyond = (high - low) * rounding;
    if (!(z >= low - beyond && z <= high + beyond))
        throw NumericalError(
            ErrorCode::unsuitable_body, "elastic cup", fmt::format("z = {:g} mm", z),
            fmt::format("is outside the straight wall, which reaches from {:g} mm to {:g} mm", low, high));
    std::size_t row = first;
    while (row + 1 < rows && z > height(row, 3))
        ++row;
    double const bottom = height(row, 0), top = height(row, 3);
    double const across = depth * static_cast<double>(layers);
    std::size_t const layer = std::min(layers - 1, static_cast<std::size_t>(across));
    return {row * layers + layer, 2 * (across - static_cast<double>(layer)) - 1,
            std::clamp(2 * (z - bottom) / (top - bottom) - 1, -1.0, 1.0)};
}

}  // namespace hdconj::elastic
