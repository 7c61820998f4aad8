// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
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

/// Compliance of the flank contacts, with each other and with those of the bearing. A force on a tooth opens gaps of
/// flanks, a force of the bearing closes them.
class FlankCompliance
{
  public:
    FlankCompliance(ElasticDrive const& drive, LinearGaps const& gaps, std::size_t flanks,
                    std::vector<BearingNode> nodes)
        : response_(*drive.response), own_(gaps.compliance.own), couplings_(flanks), nodes_(std::move(nodes))
    {
        for (std::size_t i = 0; i < flanks; ++i)
            feet_.push_back(footing(drive, gaps.contacts[i]));
        for (LocalCompliance::Coupling const& c : gaps.compliance.couplings) {
            couplings_[c.first].emplace_back(c.second, c.compliance);
            couplings_[c.second].emplace_back(c.first, c.compliance);
        }
    }

    [[nodiscard]] VectorXd diagonal() const
    {
        VectorXd result(static_cast<Index>(feet_.size()));
        for (std::size_t i = 0; i < feet_.size(); ++i)
            result[static_cast<Index>(i)] = between(response_, feet_[i], feet_[i]) + own_[i];
        return result;
    }

    /// ColumnsOnDemand::Fill
    void operator()(Index column, VectorXd& values) const
    {
        auto const j = static_cast<std::size_t>(column);
        if (j >= feet_.size()) {
            for (std::size_t i = 0; i < feet_.size(); ++i)
                values[static_cast<Index>(i)] = with_bearing(feet_[i], nodes_[j - feet_.size()]);
            return;
        }
        // The matrix is symmetric to the last bit.
        for (std::size_t i = 0; i < feet_.size(); ++i)
            values[static_cast<Index>(i)] = between(response_, feet_[std::max(i, j)], feet_[std::min(i, j)]);
        values[column] += own_[j];
        for (auto const& [other, compliance] : couplings_[j])
            values[static_cast<Index>(other)] += compliance;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            values[static_cast<Index>(feet_.size() + i)] = with_bearing(feet_[j], nodes_[i]);
    }

  private:
    PointResponse const& response_;
    std::vector<double> const& own_;
    std::vector<std::vector<std::pair<std::size_t, double>>> couplings_;  ///< of each flank contact
    std::vector<Footing> feet_;
    std::vector<BearingNode> nodes_;

    [[nodiscard]] double with_bearing(Footing const& foot, BearingNode const& node) const
    {
        double value = 0;
        std::size_t const place = response_.place(node.at - foot.at);
        for (std::size_t i = 0; i < 3; ++i)
            value -= foot.share[i] * response_.at(node.height, foot.station[i], place);
        return value;
    }
};

/// The complementarity problem of the contacts: those of the first @p flanks flank contacts, then those of the bearing
/// in the order of bearing_nodes(). A torque adds its equation as border and total.
/// @throws NumericalError when no flank can carry the torque
numeric::Complementarity contact_problem(ElasticDrive const& drive, LinearGaps const& gaps, std::size_t flanks,
                                         std::optional<double> torque)
{
    std::vector<BearingNode> const nodes = bearing_nodes(drive);
    if (!drive.bearing_compliance || drive.bearing_compliance->rows() != static_cast<Index>(nodes.size()))
        throw std::logic_error("a drive without the compliance of its bearing's contacts");
    auto const count = static_cast<Index>(flanks + nodes.size());
    numeric::Complementarity problem;
    // No torque changes the block of the bearing; of the flank contacts, few carry a force.
    problem.shared = drive.bearing_compliance;
    if (flanks > 0) {
        FlankCompliance compliance(drive, gaps, flanks, nodes);
        VectorXd diagonal = compliance.diagonal();
        problem.leading = std::make_shared<numeric::ColumnsOnDemand>(
            std::move(diagonal), static_cast<Index>(nodes.size()), std::move(compliance));
    }
    problem.approach.resize(count);
    VectorXd lever = VectorXd::Zero(count);
    for (std::size_t i = 0; i < flanks; ++i) {
        FlankContact const& c = gaps.contacts[i];
        problem.approach(static_cast<Index>(i)) =
            -(c.gap + gaps.displacement[i] + gaps.compliance.offset[i] + c.lever * gaps.turn);
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
        problem.total = *torque / drive.response->sectors();
    }
    return problem;
}

}  // namespace

Equilibrium equilibrium(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque,
                        Equilibrium const* guess, int threads)
{
    std::size_t const flanks = torque ? gaps.contacts.size() : 0;  // without torque none is in the problem
    numeric::Complementarity problem = contact_problem(drive, gaps, flanks, torque);
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
    result.stiffness = torque ? drive.response->sectors() * solved.slope : 0;
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
    MatrixXd force = MatrixXd::Zero(static_cast<Index>(drive.stations.count()), drive.response->grid());
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
