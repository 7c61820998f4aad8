// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "equilibrium_start.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"

namespace hdconj::load {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double between(PointResponse const& response, Footing const& a, Footing const& b)
{
    double sum = 0;
    std::size_t const place = response.place(a.at - b.at);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            sum += a.share[i] * b.share[j] * response.at(a.station[i], b.station[j], place);
    return sum;
}

/// Copies the rows above @p above of the columns [@p begin, @p begin + @p width) from the lower triangle, tile by tile
/// so that they stay in the cache.
void mirror_tiles(MatrixXd& a, Index begin, Index width, Index above, Index tile)
{
    for (Index i = 0; i < above; i += tile) {
        Index const height = std::min(tile, above - i);
        a.block(i, begin, height, width) = a.block(begin, i, width, height).transpose();
    }
}

/// Compliance between all contacts. The block of the bearing is that of the drive.
MatrixXd compliance_of(ElasticDrive const& drive, LinearGaps const& gaps, std::size_t flanks,
                       std::vector<BearingNode> const& nodes, int threads)
{
    std::size_t const count = flanks + nodes.size();
    std::vector<Footing> feet;
    for (std::size_t i = 0; i < flanks; ++i)
        feet.push_back(footing(drive, gaps.contacts[i]));
    MatrixXd a(static_cast<Index>(count), static_cast<Index>(count));
    auto const first = static_cast<Index>(flanks), bearing = static_cast<Index>(nodes.size());
    constexpr std::size_t grain = 16;
    // Columns of flanks from the diagonal down. A force on a tooth opens gaps of flanks, a force of the bearing closes
    // them.
    parallel_for(flanks, threads, grain, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        for (std::size_t row = col; row < flanks; ++row)
            a(static_cast<Index>(row), j) = between(drive.response, feet[row], feet[col]);
        for (std::size_t row = 0; row < nodes.size(); ++row) {
            double& value = a(first + static_cast<Index>(row), j);
            value = 0;
            std::size_t const place = drive.response.place(nodes[row].at - feet[col].at);
            for (std::size_t i = 0; i < 3; ++i)
                value -= feet[col].share[i] * drive.response.at(nodes[row].height, feet[col].station[i], place);
        }
        a(j, j) += gaps.compliance.own[col];
    });
    if (flanks > 0)
        for (LocalCompliance::Coupling const& c : gaps.compliance.couplings)
            a(static_cast<Index>(c.second), static_cast<Index>(c.first)) += c.compliance;
    // The upper triangle, and the block of the bearing, which no torque changes.
    constexpr Index tile = 32;
    constexpr std::size_t tiles_worth_a_thread = 2;
    parallel_for((count + tile - 1) / tile, threads, tiles_worth_a_thread, [&](std::size_t t) {
        Index const begin = static_cast<Index>(t) * tile, width = std::min(tile, a.cols() - begin);
        mirror_tiles(a, begin, width, std::min(begin, first), tile);
        for (Index j = begin; j < begin + width; ++j) {
            for (Index i = begin; i < std::min(j, first); ++i)
                a(i, j) = a(j, i);
            if (j >= first)
                a.col(j).tail(bearing) = drive.bearing_compliance.col(j - first);
        }
    });
    return a;
}

/// The complementarity problem of the contacts: those of the first @p flanks flank contacts, then those of the bearing
/// in the order of bearing_nodes(). A torque adds its equation as border and total.
/// @throws NumericalError when no flank can carry the torque
numeric::Complementarity contact_problem(ElasticDrive const& drive, LinearGaps const& gaps, std::size_t flanks,
                                         std::optional<double> torque, int threads)
{
    std::vector<BearingNode> const nodes = bearing_nodes(drive);
    if (drive.bearing_compliance.rows() != static_cast<Index>(nodes.size()))
        throw std::logic_error("a drive without the compliance of its bearing's contacts");
    auto const count = static_cast<Index>(flanks + nodes.size());
    numeric::Complementarity problem;
    problem.compliance = compliance_of(drive, gaps, flanks, nodes, threads);
    problem.approach.resize(count);
    VectorXd lever = VectorXd::Zero(count);
    for (std::size_t i = 0; i < flanks; ++i) {
        FlankContact const& c = gaps.contacts[i];
        problem.approach(static_cast<Index>(i)) = -(c.gap + gaps.displacement[i] + c.lever * gaps.turn);
        lever(static_cast<Index>(i)) = c.lever;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
        problem.approach(static_cast<Index>(flanks + i)) =
            drive.needed(static_cast<Index>(nodes[i].height), static_cast<Index>(nodes[i].angle));
    if (torque) {
        if (*torque != 0 && !((lever * *torque).maxCoeff() > 0))
            throw NumericalError(
                ErrorCode::overload, "load", "torque of " + short_number(*torque / newton_metre) + " N m",
                "no flank on the loaded side can carry it: the teeth slip over each other", "write a smaller torque");
        problem.border = lever;
        problem.total = *torque / drive.response.sectors();
    }
    return problem;
}

}  // namespace

Equilibrium equilibrium(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque,
                        Equilibrium const* guess, int threads)
{
    std::size_t const flanks = torque ? gaps.contacts.size() : 0;  // without torque none is in the problem
    numeric::Complementarity problem = contact_problem(drive, gaps, flanks, torque, threads);
    Start start = equilibrium_start(drive, gaps, problem, flanks, guess, threads);
    numeric::ComplementarityOptions const options{
        .start = std::move(start.contacts), .scalar = gaps.turn, .threads = threads};
    Equilibrium result;
    numeric::ComplementaritySolution solved;
    if (drive.balls) {
        elastic::BallContact balls =
            elastic::solve_on_balls(problem, static_cast<Index>(flanks), *drive.balls, options, start.balls);
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
