// SPDX-License-Identifier: GPL-3.0-or-later
#include "complementarity_system.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "compliance.hpp"
#include "dense.hpp"
#include "hdconj/error.hpp"

namespace hdconj::numeric {

using Eigen::Index;
using Eigen::VectorXd;

void fail_complementarity(std::string const& cause)
{
    throw NumericalError(ErrorCode::not_converged, "contact of elastic bodies", "complementarity problem", cause);
}

ComplementaritySystem::ComplementaritySystem(Complementarity const& problem, double scalar, int threads)
    : s(problem.border.size() > 0 ? scalar : 0), problem_(problem), count_(problem.approach.size()), threads_(threads)
{
    if (!all_finite(problem.compliance, threads) || !problem.yielding.allFinite() || !problem.approach.allFinite() ||
        !problem.border.allFinite() || !std::isfinite(problem.total))
        fail_complementarity("a compliance, an approach or the load is not a number");
    double const load = problem.total;
    if (has_border() && load != 0 && (problem.border * load).maxCoeff() <= 0)
        fail_complementarity(fmt::format("no contact can carry the load of {:.3g}: none acts in its direction", load));
    if (!has_border() && load != 0)
        fail_complementarity("a load without a border that carries it");
}

bool ComplementaritySystem::on_border(std::vector<int> const& contacts) const
{
    return std::any_of(contacts.begin(), contacts.end(), [this](int i) { return problem_.border[i] != 0; });
}

VectorXd ComplementaritySystem::gaps(VectorXd const& f) const
{
    return times(problem_, f, threads_) - problem_.approach - closed_by_s();
}

double ComplementaritySystem::energy_at_s(VectorXd const& f) const
{
    return work_of(problem_, f, threads_) / 2 - f.dot(problem_.approach + closed_by_s());
}

std::vector<int> ComplementaritySystem::overlapping() const
{
    std::vector<int> contacts;
    VectorXd const overlap = problem_.approach + closed_by_s();
    for (Index i = 0; i < count_; ++i)
        if (overlap[i] > 0)
            contacts.push_back(static_cast<int>(i));
    return contacts;
}

double ComplementaritySystem::nearest_contact(VectorXd const& gap, double direction, int& contact) const
{
    double best = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < count_; ++i)
        if (problem_.border[i] * direction > 0) {
            double const step = gap[i] / (problem_.border[i] * direction);
            if (step < best)
                best = step, contact = static_cast<int>(i);
        }
    return s + direction * best;
}

VectorXd ComplementaritySystem::close(std::vector<int> const& contacts, bool keep_s)
{
    ++iterations_;
    VectorXd f = VectorXd::Zero(count_);
    if (contacts.empty())
        return f;
    Cholesky const factor(lower_principal_part(problem_, contacts, threads_), threads_);
    if (!factor.found())
        fail_complementarity("the compliance matrix is not positive definite");
    VectorXd const x = factor.solve(problem_.approach(contacts));
    if (!has_border()) {
        f(contacts) = x;
        return f;
    }
    VectorXd const b = problem_.border(contacts);
    VectorXd const y = factor.solve(b);
    slope_ = b.dot(y);
    if (!keep_s && slope_ > 0)
        s = (problem_.total - b.dot(x)) / slope_;
    VectorXd on = x + s * y;
    // s b and d may be far larger than what they leave for f: once more for what is missing of T
    if (!keep_s && slope_ > 0) {
        double const missing = (problem_.total - b.dot(on)) / slope_;
        on += missing * y;
        s += missing;
    }
    f(contacts) = on;
    return f;
}

ComplementaritySolution ComplementaritySystem::solution(VectorXd f, ContactMethod method) const
{
    ComplementaritySolution result;
    for (Index i = 0; i < count_; ++i) {
        if (f[i] > 0)
            result.contacts.push_back(static_cast<int>(i));
        else
            f[i] = 0;
    }
    VectorXd const elastic = times(problem_, f, threads_);
    result.gap = elastic - problem_.approach - closed_by_s();
    result.residual = residual_of(problem_, f, elastic, s);
    result.energy = f.dot(elastic) / 2 - f.dot(problem_.approach);
    result.force = std::move(f);
    result.scalar = s;
    result.slope = slope_;
    result.iterations = iterations_;
    result.energies = energies;
    result.method = method;
    return result;
}

}  // namespace hdconj::numeric
