// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_line.hpp"

#include <Eigen/Cholesky>

#include <cstddef>
#include <numbers>
#include <set>
#include <string>

#include "bearing.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"

namespace hdconj::elastic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double ball_rounding = 1e-12;  // of forces and gaps, against the largest

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
        "has too few balls where the cam pushes");
}

/// The block of a problem that belongs to the contacts of a ring.
struct RingBlock
{
    Index first, rows;
    MatrixXd compliance;  ///< with the ring held on the cam; empty: not yet changed
    VectorXd approach;    ///< likewise
};

/// Holds the ring on the cam at all points.
void hold(numeric::Complementarity& problem, RingBlock const& block)
{
    if (block.compliance.size() == 0)
        return;
    problem.compliance.block(block.first, block.first, block.rows, block.rows) = block.compliance;
    problem.approach.segment(block.first, block.rows) = block.approach;
}

/// Frees the ring, held until now, at the points @p free. @param ring  stiffness between them, factorised
void release(numeric::Complementarity& problem, RingBlock& block, BallLine const& line, std::vector<int> const& free,
             Eigen::LLT<MatrixXd> const& ring)
{
    Index const first = block.first, rows = block.rows;
    if (block.compliance.size() == 0) {
        block.compliance = problem.compliance.block(first, first, rows, rows);
        block.approach = problem.approach.segment(first, rows);
    }
    MatrixXd const lift = line.lift(Eigen::all, free);
    MatrixXd const eased = ring.matrixL().solve(lift.transpose());
    problem.compliance.block(first, first, rows, rows) += eased.transpose() * eased;
    problem.approach.segment(first, rows) -= lift * ring.solve(VectorXd(line.held(free)));
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

}  // namespace

BallLine ball_line(BearingSurface const& surface, int waves, BearingContacts const& contacts, int points, bool mirrored,
                   int threads)
{
    if (!surface.compliance)
        refuse_bearing("balls", "a rigid bearing has no balls");
    if (points < 2 || points % 2 != 0 || points / 2 >= static_cast<int>(surface.cosine.cols()))
        refuse_bearing("balls",
                       "its points must be an even number, and no more than the harmonics of the ring can tell apart");
    int const terms = points / 2 + 1;
    auto const count = static_cast<Index>(mirrored ? terms : points), rows = static_cast<Index>(contacts.phi.size());
    double const arc = 2 * std::numbers::pi / (waves * points);
    BallLine line;
    for (Index m = 0; m < count; ++m)
        line.phi.push_back(arc * static_cast<double>(m));
    line.held = VectorXd::Zero(count);
    line.stiffness = MatrixXd::Zero(count, count);
    line.lift = MatrixXd::Zero(rows, count);
    // values at the points <-> coefficients; a mirrored point stands for two, one on a mirror plane for itself
    VectorXd share = VectorXd::Ones(count);
    if (mirrored)
        share[0] = share[count - 1] = 0.5;
    MatrixXd cosine = MatrixXd::Zero(count, terms), sine = MatrixXd::Zero(count, terms);
    VectorXd rise(terms), mean(terms);
    for (int k = 0; k < terms; ++k) {
        auto const column = static_cast<Index>(k);
        bool const alternating = 2 * k == points;
        double const n = static_cast<double>(k) * waves;
        double const coefficient = (mirrored ? 2.0 : 1.0) * (k == 0 || alternating ? 1.0 : 2.0) / points;
        // of an amplitude at a point: the work of +-1 at the points is twice that of the cosine through them
        double const felt = alternating ? 0.5 : 1.0;
        for (Index m = 0; m < count; ++m) {
            double const angle = n * line.phi[static_cast<std::size_t>(m)];
            cosine(m, column) = share[m] * std::cos(angle);
            sine(m, column) = mirrored || alternating ? 0 : share[m] * std::sin(angle);
        }
        line.held +=
            arc * felt *
            (surface.reaction_cosine[column] * cosine.col(column) + surface.reaction_sine[column] * sine.col(column));
        rise[column] = arc * felt * coefficient * surface.reaction_to_lift[column];
        mean[column] = coefficient * mean_of_cosine(n, contacts.spread);
    }
    constexpr std::size_t points_worth_a_thread = 16, rows_worth_a_thread = 64;
    parallel_for(static_cast<std::size_t>(count), threads, points_worth_a_thread, [&](std::size_t point) {
        auto const m = static_cast<Index>(point);
        for (Index k = 0; k < terms; ++k)
            line.stiffness.col(m) += rise[k] * (cosine(m, k) * cosine.col(k) + sine(m, k) * sine.col(k));
    });
    parallel_for(static_cast<std::size_t>(rows), threads, rows_worth_a_thread, [&](std::size_t row) {
        VectorXd lift = VectorXd::Zero(count);
        for (Index k = 0; k < terms; ++k) {
            double const angle = static_cast<double>(k) * waves * contacts.phi[row];
            // Betti: the surface rises by as much as a force on it unloads the balls
            double const risen = -mean[k] * surface.reaction_to_load(k, contacts.z[row]);
            lift += risen * (std::cos(angle) * cosine.col(k) + std::sin(angle) * sine.col(k));
        }
        line.lift.row(static_cast<Index>(row)) = lift.transpose();
    });
    return line;
}

BallContact solve_on_balls(numeric::Complementarity& problem, Index first, BallLine const& line,
                           numeric::ComplementarityOptions options, std::vector<bool> const& start)
{
    Index const rows = line.lift.rows(), count = line.held.size();
    int const most_rounds = 50 + 4 * static_cast<int>(count);
    BallContact found;
    std::vector<bool> const none(static_cast<std::size_t>(count), false);
    std::vector<bool> off = start.size() == none.size() ? start : none;
    std::set<std::vector<bool>> seen;
    std::vector<bool> before = off;
    bool one_by_one = false;
    RingBlock block{first, rows, {}, {}};
    while (found.rounds < most_rounds) {
        ++found.rounds;
        // Sets that return hand over to the rule of Murty (1974): of all wrong points only the first in a fixed order
        // changes. With h >= 0 alone, f its answer, P is the slope of a convex function of h, so (h - k) . (P(h) -
        // P(k)) > 0 for h and k that are answers with different sets. Then the last point in the order changes at most
        // once: between, the others are answers of the same problem with one point less; if it is released since it
        // would pull, it is the one product that can be above 0, and stands off. By induction no set returns, and there
        // are finitely many.
        one_by_one = one_by_one || !seen.insert(off).second;
        std::vector<int> const free = released(off);
        Eigen::LLT<MatrixXd> ring;
        hold(problem, block);
        if (!free.empty()) {
            ring.compute(line.stiffness(free, free));
            // A ring that no ball holds has a harmonic without stiffness, to rounding.
            if (ring.info() != Eigen::Success || !(ring.rcond() > ball_rounding)) {
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
            release(problem, block, line, free, ring);
        }
        found.contacts = numeric::solve_complementarity(problem, options);
        options.start = found.contacts.contacts;
        options.scalar = found.contacts.scalar;
        VectorXd const bare = line.held + line.lift.transpose() * found.contacts.force.segment(first, rows);
        found.gap = VectorXd::Zero(count);
        if (!free.empty())
            found.gap(free) = -ring.solve(VectorXd(bare(free)));
        found.force = bare + line.stiffness * found.gap;
        before = off;
        if (!change_wrong_points(found, one_by_one, off)) {
            for (int const point : free)
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

}  // namespace hdconj::elastic
