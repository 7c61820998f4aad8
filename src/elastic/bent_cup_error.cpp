// SPDX-License-Identifier: GPL-3.0-or-later
#include "bent_cup_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hdconj/wavegen/material_displacement.hpp"

namespace hdconj::elastic {
namespace {

/// Even angles of a lobe.
std::vector<double> angles_of(int waves)
{
    constexpr int count = 128;
    std::vector<double> phi;
    for (int i = 0; i < count; ++i)
        phi.push_back(2 * std::numbers::pi * i / (count * waves));
    return phi;
}

}  // namespace

BentCupError distance_between(BentCup const& cup, BentCup const& other, std::vector<double> const& z, double radius)
{
    BentCupError distance;
    for (double const height : z) {
        wavegen::MaterialDisplacement const a = cup.displacement(height, radius),
                                            b = other.displacement(height, radius);
        for (double const phi : angles_of(a.waves)) {
            wavegen::PointDisplacement const p = wavegen::displacement_at(a, phi), q = wavegen::displacement_at(b, phi);
            distance.displacement = std::max(distance.displacement, std::hypot(p.w[0] - q.w[0], p.v[0] - q.v[0]));
        }
    }
    distance.coning_major = std::abs(cup.coning(0) - other.coning(0));
    distance.force = std::abs(cup.contact().total_force - other.contact().total_force);
    return distance;
}

BentCupError bent_cup_error(BentCup const& cup, BentCup const& other, std::vector<double> const& z, double radius)
{
    // the pressure at a bearing's edge is singular, and what it adds up to is of order one half in the grid: of two
    // grids the finer one is off by 1/(sqrt 2 - 1) times their distance
    double const safety = 3 / (std::numbers::sqrt2 - 1);
    BentCupError const distance = distance_between(cup, other, z, radius);
    double moved = 0;
    for (double const height : z) {
        wavegen::MaterialDisplacement const a = cup.displacement(height, radius);
        for (double const phi : angles_of(a.waves))
            moved = std::max(moved,
                             std::hypot(wavegen::displacement_at(a, phi).w[0], wavegen::displacement_at(a, phi).v[0]));
    }
    double const coning = std::abs(cup.coning(0)), force = cup.contact().total_force;
    // two grids may agree in one figure by chance: none is known better than the middle one, relative to its size
    auto const relative = [](double off, double size) { return size > 0 ? off / size : 0; };
    std::array<double, 3> shares = {relative(distance.displacement, moved), relative(distance.coning_major, coning),
                                    relative(distance.force, force)};
    std::sort(shares.begin(), shares.end());
    double const least = shares[1];
    return {safety * std::max(distance.displacement, least * moved),
            safety * std::max(distance.coning_major, least * coning), safety * std::max(distance.force, least * force)};
}

BentCupGrid discretised_otherwise(BentCupGrid const& grid)
{
    constexpr int fewest_angles = 8, fewest_circles = 2;
    return {std::max(std::min(grid.angles, fewest_angles), grid.angles / 4 * 2),
            std::max(std::min(grid.circles, fewest_circles), (grid.circles + 1) / 2), 2 * grid.layers};
}

}  // namespace hdconj::elastic
