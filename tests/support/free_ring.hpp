// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The second path to the forces of balls: a ring that lies on nothing but its balls, which are contacts like those
/// between ring and wall.
#pragma once

#include <vector>

#include "catch.hpp"
#include "elastic/bearing.hpp"
#include "elastic/influence.hpp"
#include "numeric/complementarity.hpp"

namespace hdconj::test {

inline constexpr double inner_radius = 24;  ///< of the cups that bearings are set into [mm]

/// Cup and free ring of that @p bearing in contact at the @p wall, points of stations @p z, and the ring on balls at @p
/// ball_phi: the unknowns are the forces of the wall, in that order, and then those of the balls. The approach is zero
/// and left to the test.
/// @param along  size of the ring's elements along z [mm]
inline numeric::Complementarity free_ring(elastic::FourierSolid const& cup, elastic::Bearing const& bearing,
                                          double radius, double along, std::vector<double> const& z,
                                          std::vector<elastic::InfluencePoint> const& wall,
                                          std::vector<double> const& ball_phi, std::vector<int> const& harmonics,
                                          elastic::Repetition const& repetition)
{
    double const r = radius - bearing.ring->thickness, low = bearing.middle - bearing.width / 2;
    elastic::FourierSolid const body(
        elastic::ring_mesh({r, low}, {radius, low + bearing.width}, bearing.ring->material, {along, 1.0}));
    int node = -1;
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
        if ((body.mesh().nodes[i] - Vec2(r, bearing.middle)).norm() < 1e-9)
            node = static_cast<int>(i);
    REQUIRE(node >= 0);
    std::vector<elastic::Station> on_ring, on_cup;
    for (double const at : z) {
        on_ring.push_back(elastic::wall_station(body.mesh(), at, 1, elastic::Direction::radial));
        on_cup.push_back(elastic::wall_station(cup.mesh(), at, 0, elastic::Direction::radial));
    }
    on_ring.push_back(elastic::wall_station(body.mesh(), bearing.middle, 0, elastic::Direction::radial));
    std::vector<elastic::InfluencePoint> balls;
    for (double const phi : ball_phi)
        balls.push_back({z.size(), phi});
    elastic::Influence const ring = elastic::influence(
        body, {{node, elastic::Direction::axial}, {node, elastic::Direction::tangential, -1, 0}}, on_ring, harmonics);
    auto const rows = static_cast<Eigen::Index>(wall.size()), points = static_cast<Eigen::Index>(balls.size());
    numeric::Complementarity both;
    both.compliance.resize(rows + points, rows + points);
    both.compliance << elastic::influence(cup, {}, on_cup, harmonics).matrix(wall, repetition) +
                           ring.matrix(wall, repetition),
        -ring.matrix(wall, balls, repetition), -ring.matrix(balls, wall, repetition), ring.matrix(balls, repetition);
    both.approach = Eigen::VectorXd::Zero(rows + points);
    return both;
}

}  // namespace hdconj::test
