// SPDX-License-Identifier: GPL-3.0-or-later
#include "complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "complementarity_system.hpp"
#include "dense.hpp"

namespace hdconj::numeric {

using Eigen::Index;
using Eigen::VectorXd;

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
    return force.size() == 0 ? 0 : residual_of(problem, force, times(problem.compliance, force, threads), scalar);
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
