// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium.hpp"

#include <utility>

#include "contact_places.hpp"
#include "contact_problem.hpp"
#include "equilibrium_start.hpp"

namespace hdconj::load {

using Eigen::Index;
using Eigen::MatrixXd;

Equilibrium equilibrium(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque,
                        Equilibrium const* guess, int threads)
{
    std::size_t const flanks = flanks_of(gaps, torque);
    numeric::Complementarity problem = contact_problem(drive, gaps, torque, threads);
    Start start = equilibrium_start(drive, gaps, problem, flanks, guess, threads);
    numeric::ComplementarityOptions options;
    options.scalar = gaps.turn;
    options.threads = threads;
    options.start = std::move(start.contacts);
    Equilibrium result;
    numeric::ComplementaritySolution solved;
    if (drive.balls) {
        elastic::BallContact balls =
            elastic::solve_on_balls(problem, static_cast<Index>(flanks), *drive.balls, options, start.off);
        result.balls.assign(balls.force.begin(), balls.force.end());
        solved = std::move(balls.contacts);
    } else
        solved = numeric::solve_complementarity(problem, options);

    result.turn = torque ? solved.scalar : gaps.turn;
    result.steps = solved.iterations;
    result.complementarity = solved.residual;
    result.stiffness = torque ? drive.response.sectors() * solved.slope : 0;
    for (std::size_t i = 0; i < gaps.contacts.size(); ++i)
        result.flank.push_back(i < flanks ? solved.force(static_cast<Index>(i)) : 0.0);
    result.bearing =
        MatrixXd::Zero(static_cast<Index>(drive.stations.bearing), static_cast<Index>(drive.bearing_steps.size()));
    Index row = static_cast<Index>(flanks);
    for (BearingNode const& node : bearing_nodes(drive))
        result.bearing(static_cast<Index>(node.height), static_cast<Index>(node.angle)) = solved.force(row++);
    return result;
}

MatrixXd forces_on_cup(ElasticDrive const& drive, std::vector<FlankContact> const& contacts, Equilibrium const& state)
{
    MatrixXd force = MatrixXd::Zero(static_cast<Index>(drive.stations.count()), drive.response.grid());
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w)
        for (std::size_t j = 0; j < drive.stations.bearing; ++j)
            force(static_cast<Index>(j), drive.bearing_steps[w]) +=
                state.bearing(static_cast<Index>(j), static_cast<Index>(w));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Footing const foot = footing(drive, contacts[i]);
        for (std::size_t j = 0; j < 3; ++j)
            force(static_cast<Index>(foot.station[j]), foot.at) -= foot.share[j] * state.flank[i];
    }
    return force;
}

}  // namespace hdconj::load
