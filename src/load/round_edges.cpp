// SPDX-License-Identifier: GPL-3.0-or-later
#include "round_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/segments.hpp"
#include "base/text.hpp"
#include "hdconj/error.hpp"

namespace hdconj::load {
namespace {

struct Edge
{
    Vec2 centre;
    std::size_t next;  ///< first point whose own circle touches neither the land nor the middle of the tooth
};

/// Where a circle of this radius leaves the flank: onto the land, or onto the neighbouring flank.
std::optional<Edge> edge_of(std::vector<Vec2> const& point, std::vector<Vec2> const& normal, double radius,
                            double half_pitch)
{
    double const land = point.front().norm() + radius;
    Vec2 const middle = point.front().x() < 0 ? Vec2(-std::sin(half_pitch), std::cos(half_pitch))
                                              : Vec2(std::sin(half_pitch), std::cos(half_pitch));
    auto const centre = [&](std::size_t i) { return Vec2(point[i] + radius * normal[i]); };
    // both are positive where the circle is free
    auto const below_land = [&](Vec2 const& c) { return c.norm() - land; };
    auto const beside_middle = [&](Vec2 const& c) { return middle.x() < 0 ? -cross(middle, c) : cross(middle, c); };
    std::size_t next = point.size();
    while (next > 0 && below_land(centre(next - 1)) >= 0 && beside_middle(centre(next - 1)) >= 0)
        --next;
    if (next == point.size())
        return std::nullopt;
    if (next == 0)
        return Edge{centre(0), 0};
    auto const share = [&](auto const& room) {
        double const before = room(centre(next - 1)), after = room(centre(next));
        return before < 0 ? before / (before - after) : 0.0;
    };
    return Edge{
        centre(next - 1) + std::max(share(below_land), share(beside_middle)) * (centre(next) - centre(next - 1)), next};
}

/// Loops that centres make behind a convex edge of the flank: all their points go to where the loop closes.
void close_loops(std::vector<Vec2>& centre, double radius)
{
    for (std::size_t i = 0; i + 3 < centre.size(); ++i)
        for (std::size_t j = i + 2; j + 1 < centre.size(); ++j) {
            // a loop is no wider than the circle
            if ((centre[j] - centre[i]).norm() > 4 * radius)
                break;
            if (centre[i] == centre[i + 1] || centre[j] == centre[j + 1])
                continue;
            if (auto const at = crossing_of_segments(centre[i], centre[i + 1], centre[j], centre[j + 1]))
                std::fill(centre.begin() + static_cast<std::ptrdiff_t>(i + 1),
                          centre.begin() + static_cast<std::ptrdiff_t>(j + 1), *at);
        }
}

}  // namespace

contact::FlankGrid with_round_edges(contact::FlankGrid grid, double radius, double half_pitch)
{
    for (std::size_t f = 0; f < 2; ++f) {
        grid.radius[f].resize(grid.slices());
        // the flank between its points is now the path of the centres
        grid.line[f].clear();
        grid.line_normal[f].clear();
        grid.index[f].clear();
        for (std::size_t k = 0; k < grid.slices(); ++k) {
            std::vector<Vec2>& point = grid.point[f][k];
            std::vector<Vec2> const& normal = grid.normal[f][k];
            auto const edge = edge_of(point, normal, radius, half_pitch);
            if (!edge)
                throw NumericalError(
                    ErrorCode::no_solution, "load", "edge of a land at z = " + short_number(grid.z[k]) + " mm",
                    "no circle of the radius " + short_number(radius) +
                        " mm fits into a tooth of the circular spline: write a smaller load.edge_radius");
            for (std::size_t i = 0; i < point.size(); ++i)
                point[i] = i < edge->next ? edge->centre : Vec2(point[i] + radius * normal[i]);
            close_loops(point, radius);
            grid.radius[f][k] = radius;
        }
    }
    return grid;
}

}  // namespace hdconj::load
