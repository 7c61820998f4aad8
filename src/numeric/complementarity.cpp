// SPDX-License-Identifier: GPL-3.0-or-later
#include "complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "complementarity_system.hpp"
#include "compliance.hpp"

namespace hdconj::numeric {

using Eigen::Index;
using Eigen::VectorXd;

std::optional<ComplementaritySolution> active_set(ComplementaritySystem& system, std::vector<int> contacts,
                                                  double tolerance)
{
    Complementarity const& problem = system.problem();
    constexpr int patience = 40;        // steps without a lower energy: twice as many as whole solutions take
    constexpr double rounding = 1e-14;  // of forces and gaps, against the largest: less is neither push nor overlap
    double const largest_diagonal = diagonal_of(problem).maxCoeff();
    std::set<std::vector<int>> seen;
    double least = std::numeric_limits<double>::infinity();
    int waited = 0;
    while (waited < patience && seen.insert(contacts).second) {
        if (system.has_border() && problem.total != 0 && !system.on_border(contacts)) {
            VectorXd const f = system.close(contacts, true);
            int contact = -1;
            system.s = system.nearest_contact(system.gaps(f), problem.total < 0 ? -1 : 1, contact);
            contacts.insert(std::lower_bound(contacts.begin(), contacts.end(), contact), contact);
        }
        VectorXd const f = system.close(contacts, false);
        VectorXd const g = system.gaps(f);
        double const length = (problem.approach.cwiseAbs() + system.closed_by_s().cwiseAbs()).maxCoeff() * rounding;
        double const force = f.cwiseAbs().maxCoeff() * rounding + length / largest_diagonal;
        std::vector<bool> was(static_cast<std::size_t>(system.count()), false);
        for (int i : contacts)
            was[static_cast<std::size_t>(i)] = true;
        std::vector<int> next;
        bool settled = true;
        for (Index i = 0; i < system.count(); ++i) {
            bool const in = was[static_cast<std::size_t>(i)];
            bool const stays = in ? f[i] >= -force : g[i] < -length;
            settled = settled && stays == in;
            if (stays && (!in || f[i] > 0))
                next.push_back(static_cast<int>(i));
        }
        if (settled) {
            auto result = system.solution(f, ContactMethod::active_set);
            if (result.residual <= tolerance)
                return result;
            return std::nullopt;
        }
        contacts = std::move(next);
        VectorXd const pushing = f.cwiseMax(0.0);
        double const energy = system.energy_at_s(pushing);
        waited = energy < least ? 0 : waited + 1;
        least = std::min(least, energy);
    }
    return std::nullopt;
}

double residual_of(Complementarity const& problem, VectorXd const& force, VectorXd const& elastic, double scalar)
{
    bool const bordered = problem.border.size() > 0;
    VectorXd rigid = problem.approach;
    if (bordered)
        rigid += problem.border * scalar;
    VectorXd const gap = elastic - rigid;
    double largest_force = force.cwiseAbs().maxCoeff();
    double largest_gap =
        std::max({problem.approach.cwiseAbs().maxCoeff(), rigid.cwiseAbs().maxCoeff(), elastic.cwiseAbs().maxCoeff()});
    if (bordered)
        largest_force = std::max(largest_force, std::abs(problem.total) / problem.border.norm());
    largest_force = largest_force > 0 ? largest_force : 1;
    largest_gap = largest_gap > 0 ? largest_gap : 1;
    double residual = 0;
    for (Index i = 0; i < force.size(); ++i) {
        double const f = force[i] / largest_force, g = gap[i] / largest_gap;
        residual = std::max(residual, std::abs(std::min(f, g)));
    }
    if (bordered)
        residual = std::max(
            residual, std::abs(problem.border.dot(force) - problem.total) / (problem.border.norm() * largest_force));
    return residual;
}

double complementarity_residual(Complementarity const& problem, VectorXd const& force, double scalar, int threads)
{
    return force.size() == 0 ? 0 : residual_of(problem, force, times(problem, force, threads), scalar);
}

ComplementaritySolution solve_complementarity(Complementarity const& problem, ComplementarityOptions const& options)
{
    ComplementaritySystem system(problem, options.scalar, options.threads);
    if (system.count() == 0)
        return {};
    if (options.first == ContactMethod::active_set)
        if (auto found =
                active_set(system, options.start.empty() ? system.overlapping() : options.start, options.tolerance))
            return *std::move(found);
    return projected(system, options.tolerance);
}

}  // namespace hdconj::numeric
