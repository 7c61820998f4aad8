// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hdconj::load {

BallPeak ball_peak(ElasticDrive const& drive, Equilibrium const& state)
{
    BallPeak peak;
    for (std::size_t b = 0; b < state.balls.size(); ++b) {
        double const force = drive.ball_arc > 0 ? state.balls[b] / drive.ball_arc : state.balls[b];
        if (drive.ball_arc <= 0 && force > 0)
            peak.carrying += drive.response->sectors();
        if (force > peak.force) {
            peak.force = force;
            peak.phi = drive.balls->phi[b];
        }
    }
    return peak;
}

BearingMap bearing_map(ElasticDrive const& drive, Equilibrium const& state)
{
    BearingMap map;
    map.z = drive.bearing_z;
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w) {
        map.angle.push_back(drive.phase + drive.response->step() * drive.bearing_steps[w]);
        for (Eigen::Index j = 0; j < state.bearing.rows(); ++j)
            map.force.push_back(state.bearing(j, static_cast<Eigen::Index>(w)));
    }
    if (drive.balls)
        map.ball_angle = drive.balls->phi;
    for (double const force : state.balls)
        map.ball_force.push_back(drive.ball_arc > 0 ? force / drive.ball_arc : force);
    return map;
}

LobeReaction lobe_reaction(BearingMap const& bearing, int sectors, int waves)
{
    constexpr double rounding = 1e-9;  // of the angle of a border between two lobes, and of heights
    LobeReaction lobe;
    double const part = 2 * std::numbers::pi / sectors, half = std::numbers::pi / waves;
    double moment = 0;
    // A sector may hold several lobes, and its angles begin anywhere.
    for (std::size_t i = 0; i < bearing.angle.size(); ++i) {
        double const phi = std::remainder(bearing.angle[i], part);
        if (std::abs(phi) > half + rounding)
            continue;
        // Half of a force on the border belongs to this lobe. Where a sector is one lobe, the force on one border
        // stands for that on the other border, whose half is added.
        bool const border = std::abs(std::abs(phi) - half) <= rounding,
                   both_ends = border && part <= 2 * half + rounding;
        double const ends = border && !both_ends ? 0.5 : 1;
        for (std::size_t j = 0; j < bearing.z.size(); ++j) {
            double const f = ends * bearing.force[i * bearing.z.size() + j];
            lobe.along += f * std::cos(phi);
            lobe.across += both_ends ? 0 : f * std::sin(phi);
            moment += f * std::cos(phi) * bearing.z[j];
        }
    }
    double const z = moment / lobe.along, slack = rounding * (std::abs(bearing.z.front()) + std::abs(bearing.z.back()));
    bool const on_bearing = z >= bearing.z.front() - slack && z <= bearing.z.back() + slack;
    if (lobe.along > 0 && on_bearing)
        lobe.z = z;
    return lobe;
}

double ball_force_at(BearingMap const& map, double angle, int sectors)
{
    std::size_t const count = map.ball_angle.size();
    double const place =
        (angle - map.ball_angle.front()) * sectors / (2 * std::numbers::pi) * static_cast<double>(count);
    double const share = place - std::floor(place);
    auto const at = static_cast<std::size_t>(std::floor(place)) % count;
    return (1 - share) * map.ball_force[at] + share * map.ball_force[(at + 1) % count];
}

double ball_distance(BearingMap const& fine, BearingMap const& coarse, int sectors)
{
    double worst = 0;
    for (std::size_t b = 0; !fine.ball_angle.empty() && b < coarse.ball_angle.size(); ++b)
        worst = std::max(worst, std::abs(ball_force_at(fine, coarse.ball_angle[b], sectors) - coarse.ball_force[b]));
    return worst;
}

}  // namespace hdconj::load
