// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The second path to the forces of balls: a ring that lies on nothing but its balls, which are contacts like those between ring and wall.
#pragma once

#include <vector>

#include "hdconj/elastic/bearing.hpp"
#include "hdconj/elastic/complementarity.hpp"
#include "hdconj/elastic/influence.hpp"
#include "support/catch.hpp"

namespace hdconj::test {

/// Cup and free ring of that @p bearing in contact at the @p wall, points of stations @p z, and the ring on balls at @p ball_phi: the unknowns are the forces of the
/// wall, in that order, and then those of the balls. The approach is zero and left to the test.
/// @param along  size of the ring's elements along z [mm]
inline Complementarity free_ring(FourierSolid const& cup, Bearing const& bearing, double inner_radius, double along, std::vector<double> const& z, std::vector<InfluencePoint> const& wall,
                                 std::vector<double> const& ball_phi, std::vector<int> const& harmonics, Repetition const& repetition)
{
    double const r = inner_radius - bearing.ring->thickness, low = bearing.middle - bearing.width / 2;
    FourierSolid const body(ring_mesh({r, low}, {inner_radius, low + bearing.width}, bearing.ring->material, {along, 1.0}));
    int node = -1;
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
        if ((body.mesh().nodes[i] - Vec2(r, bearing.middle)).norm() < 1e-9)
            node = static_cast<int>(i);
    REQUIRE(node >= 0);
    std::vector<Station> on_ring, on_cup;
    for (double const at : z)
    {
        on_ring.push_back(wall_station(body.mesh(), at, 1, Direction::radial));
        on_cup.push_back(wall_station(cup.mesh(), at, 0, Direction::radial));
    }
    on_ring.push_back(wall_station(body.mesh(), bearing.middle, 0, Direction::radial));
    std::vector<InfluencePoint> balls;
    for (double const phi : ball_phi)
        balls.push_back({z.size(), phi});
    Influence const ring = influence(body, {{node, Direction::axial}, {node, Direction::tangential, -1, 0}}, on_ring, harmonics);
    auto const rows = static_cast<Eigen::Index>(wall.size()), points = static_cast<Eigen::Index>(balls.size());
    Complementarity both;
    both.compliance.resize(rows + points, rows + points);
    both.compliance << influence(cup, {}, on_cup, harmonics).matrix(wall, repetition) + ring.matrix(wall, repetition), -ring.matrix(wall, balls, repetition),
        -ring.matrix(balls, wall, repetition), ring.matrix(balls, repetition);
    both.approach = Eigen::VectorXd::Zero(rows + points);
    return both;
}

}  // namespace hdconj::test
