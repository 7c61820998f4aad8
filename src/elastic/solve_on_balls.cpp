// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

#include "ball_line.hpp"
#include "bearing.hpp"
#include "hdconj/error.hpp"

namespace hdconj::elastic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double ball_rounding = 1e-12;  // of forces and gaps, against the largest
constexpr double law_accuracy = 1e-7;    // of approaches by Hertz, against the largest: picometres

std::vector<int> released(std::vector<bool> const& off)
{
    std::vector<int> points;
    for (std::size_t m = 0; m < off.size(); ++m)
        if (off[m])
            points.push_back(static_cast<int>(m));
    return points;
}

[[noreturn]] void refuse_free_ring()
{
    refuse_bearing(
        "balls",
        "the balls that touch do not hold the outer ring, or hold it from one side only: the bearing is too loose, or "
        "has too few balls where the cam pushes",
        "write more bearing.balls, or a smaller bearing.clearance");
}

/// The contacts of a ring among those of a problem: the last ones.
struct RingBlock
{
    Index first, rows;
    VectorXd approach;  ///< with the ring held on the cam
};

/// Holds the ring on the cam at all points.
void hold(numeric::Complementarity& problem, RingBlock const& block)
{
    problem.yielding.resize(0, 0);
    problem.approach.segment(block.first, block.rows) = block.approach;
}

/// The ring where it may move against the cam.
struct FreeRing
{
    std::vector<int> points;           ///< where it may
    VectorXd scale;                    ///< of their movements
    Eigen::LLT<MatrixXd> stiffness{};  ///< of ring and balls between the scaled movements

    /// Movements under forces that the ring, held on the cam, leaves to the balls.
    [[nodiscard]] VectorXd moved(VectorXd const& force) const
    {
        return -scale.cwiseProduct(stiffness.solve(VectorXd(scale.cwiseProduct(VectorXd(force(points))))));
    }
};

/// Rigid balls (@p give is empty) leave the ring free where it is @p off them, and balls with the compliance @p give
/// [mm/N] everywhere. Movements are scaled so that every spring counts as 1: it may be as stiff as it likes.
FreeRing free_ring(BallLine const& line, VectorXd const& give, std::vector<bool> const& off)
{
    std::vector<bool> const all(off.size(), true);
    FreeRing ring{released(give.size() == 0 ? off : all), {}};
    auto const count = static_cast<Index>(ring.points.size());
    ring.scale = VectorXd::Ones(count);
    VectorXd spring = VectorXd::Zero(count);
    for (Index i = 0; i < give.size(); ++i) {
        bool const touches = !off[static_cast<std::size_t>(i)];
        ring.scale[i] = std::sqrt(touches ? give[i] : 1 / line.stiffness(i, i));
        spring[i] = touches ? 1 : 0;
    }
    MatrixXd stiffness = ring.scale.asDiagonal() * line.stiffness(ring.points, ring.points) * ring.scale.asDiagonal();
    stiffness.diagonal() += spring;
    ring.stiffness.compute(stiffness);
    return ring;
}

/// Frees the ring, held until now.
void release(numeric::Complementarity& problem, RingBlock const& block, BallLine const& line, FreeRing const& ring)
{
    MatrixXd const lift = line.lift(Eigen::all, ring.points);
    problem.yielding = ring.stiffness.matrixL().solve((lift * ring.scale.asDiagonal()).transpose());
    problem.approach.segment(block.first, block.rows) += lift * ring.moved(line.held);
}

/// Changes the points whose balls would pull and those released that the ring would enter; @p first_only: the first of
/// them in a fixed order. @returns whether there are any
bool change_wrong_points(BallContact const& found, bool first_only, std::vector<bool>& off)
{
    double const push = ball_rounding * found.force.cwiseAbs().maxCoeff(),
                 width = ball_rounding * found.gap.cwiseAbs().maxCoeff();
    bool changed = false;
    for (Index m = found.force.size(); m-- > 0;) {
        auto const point = static_cast<std::size_t>(m);
        bool const wrong = off[point] ? found.gap[m] < -width : found.force[m] < -push;
        if (!wrong || (first_only && changed))
            continue;
        changed = true;
        off[point] = !off[point];
    }
    return changed;
}

/// Forces and gaps of the balls in a solution.
void enter_balls(BallLine const& line, FreeRing const& ring, VectorXd const& give, std::vector<bool> const& off,
                 RingBlock const& block, BallContact& found)
{
    VectorXd const bare = line.held + line.lift.transpose() * found.contacts.force.segment(block.first, block.rows);
    found.gap = VectorXd::Zero(line.held.size());
    if (!ring.points.empty())
        found.gap(ring.points) = ring.moved(bare);
    found.force = bare + line.stiffness * found.gap;
    for (Index m = 0; m < found.gap.size(); ++m) {
        if (off[static_cast<std::size_t>(m)])
            continue;
        if (give.size() > 0)
            found.force[m] = -found.gap[m] / give[m];
        found.gap[m] = 0;
    }
}

/// Solves with balls of the compliance @p give [mm/N]; empty: rigid ones.
/// @param off  points to begin with as released; on return those that stand off
BallContact solve_with(numeric::Complementarity& problem, RingBlock const& block, BallLine const& line,
                       VectorXd const& give, numeric::ComplementarityOptions& options, std::vector<bool>& off)
{
    Index const count = line.held.size();
    int const most_rounds = 50 + 4 * static_cast<int>(count);
    BallContact found;
    std::vector<bool> const none(off.size(), false);
    std::set<std::vector<bool>> seen;
    std::vector<bool> before = off;
    bool one_by_one = false;
    while (found.rounds < most_rounds) {
        ++found.rounds;
        // Sets that return hand over to the rule of Murty (1974): of all wrong points only the first in a fixed order
        // changes. With h >= 0 alone, f its answer, P is the slope of a convex function of h, so (h - k) . (P(h) -
        // P(k)) > 0 for h and k that are answers with different sets. Then the last point in the order changes at most
        // once: between, the others are answers of the same problem with one point less; if it is released since it
        // would pull, it is the one product that can be above 0, and stands off. By induction no set returns, and there
        // are finitely many. Springs under the points leave the function convex.
        one_by_one = one_by_one || !seen.insert(off).second;
        hold(problem, block);
        FreeRing const ring = free_ring(line, give, off);
        if (!ring.points.empty()) {
            // A ring that no ball holds has a harmonic without stiffness, to rounding.
            if (ring.stiffness.info() != Eigen::Success || !(ring.stiffness.rcond() > ball_rounding)) {
                if (found.rounds == 1) {
                    off = before = none;  // the start was no help
                    continue;
                }
                if (one_by_one)
                    refuse_free_ring();
                one_by_one = true;
                off = before;
                continue;
            }
            release(problem, block, line, ring);
        }
        found.contacts = numeric::solve_complementarity(problem, options);
        options.start = found.contacts.contacts;
        options.scalar = found.contacts.scalar;
        enter_balls(line, ring, give, off, block, found);
        before = off;
        if (!change_wrong_points(found, one_by_one, off)) {
            for (int const point : released(off))
                found.force[point] = 0;
            found.force = found.force.cwiseMax(0.0);
            found.gap = found.gap.cwiseMax(0.0);
            return found;
        }
    }
    throw NumericalError(
        ErrorCode::not_converged, "bearing", "balls",
        "in " + std::to_string(most_rounds) + " iterations no set of balls was found that all press on the ring");
}

/// Compliance of balls by Hertz as secants at the forces @p force [mm/N]. Where a force is too small for its approach
/// to matter it counts as the least that does.
VectorXd secants(double hertz, VectorXd const& force)
{
    double const largest = force.maxCoeff(), least = std::pow(law_accuracy, 1.5) * (largest > 0 ? largest : 1);
    return force.unaryExpr([&](double each) { return 1 / std::cbrt(hertz * hertz * std::max(each, least)); });
}

}  // namespace

BallContact solve_on_balls(numeric::Complementarity& problem, Index first, BallLine const& line,
                           numeric::ComplementarityOptions options, std::vector<double> const& start)
{
    constexpr int most_secants = 60;  // each brings the law three times closer, or more
    auto const count = static_cast<std::size_t>(line.held.size());
    RingBlock const block{first, line.lift.rows(), problem.approach.segment(first, line.lift.rows())};
    std::vector<bool> off(count, false);
    for (std::size_t m = 0; m < start.size() && start.size() == count; ++m)
        off[m] = !(start[m] > 0);
    if (!line.hertz)
        return solve_with(problem, block, line, {}, options, off);
    VectorXd force = line.held.cwiseAbs();
    if (start.size() == count)
        force = Eigen::Map<VectorXd const>(start.data(), line.held.size());
    int rounds = 0;
    for (int i = 0; i < most_secants; ++i) {
        VectorXd const give = secants(*line.hertz, force);
        BallContact found = solve_with(problem, block, line, give, options, off);
        found.rounds = rounds += found.rounds;
        force = found.force;
        VectorXd const law = (force.array() / *line.hertz).pow(2.0 / 3);
        if ((force.cwiseProduct(give) - law).cwiseAbs().maxCoeff() <= law_accuracy * law.maxCoeff())
            return found;
    }
    throw NumericalError(ErrorCode::not_converged, "bearing", "balls",
                         "in " + std::to_string(most_secants) +
                             " iterations forces and approaches of the balls did not come to Hertz' law");
}

}  // namespace hdconj::elastic
