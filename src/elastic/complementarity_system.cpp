// SPDX-License-Identifier: GPL-3.0-or-later
#include "complementarity_system.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "hdconj/numeric/error.hpp"

namespace hdconj::detail {

using Eigen::Index;
using Eigen::VectorXd;

std::string three_digits(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

void fail_complementarity(std::string const& cause)
{
    throw NumericalError("contact of elastic bodies", "complementarity problem", cause);
}

VectorXd times(Eigen::MatrixXd const& compliance, VectorXd const& force)
{
    VectorXd result = VectorXd::Zero(compliance.rows());
    for (Index j = 0; j < force.size(); ++j)
        if (force[j] != 0)
            result += force[j] * compliance.col(j);
    return result;
}

namespace {

/// As allFinite(), of which no vector instructions are made: what is not finite is not zero less itself.
bool all_finite(Eigen::MatrixXd const& m)
{
    return (m.array() - m.array()).sum() == 0;
}

}  // namespace

ComplementaritySystem::ComplementaritySystem(Complementarity const& problem, double scalar) : s(problem.border.size() > 0 ? scalar : 0), problem_(problem), count_(problem.approach.size())
{
    if (!all_finite(problem.compliance) || !problem.approach.allFinite() || !problem.border.allFinite() || !std::isfinite(problem.total))
        fail_complementarity("a compliance, an approach or the load is not a number");
    double const load = problem.total;
    if (has_border() && load != 0 && (problem.border * load).maxCoeff() <= 0)
        fail_complementarity("no contact can carry the load of " + three_digits(load) + ": none acts in its direction");
    if (!has_border() && load != 0)
        fail_complementarity("a load without a border that carries it");
}

bool ComplementaritySystem::on_border(std::vector<int> const& contacts) const
{
    return std::any_of(contacts.begin(), contacts.end(), [this](int i) { return problem_.border[i] != 0; });
}

VectorXd ComplementaritySystem::gaps(VectorXd const& f) const
{
    return times(problem_.compliance, f) - problem_.approach - closed_by_s();
}

double ComplementaritySystem::energy_at_s(VectorXd const& f) const
{
    return f.dot(times(problem_.compliance, f)) / 2 - f.dot(problem_.approach + closed_by_s());
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
        if (problem_.border[i] * direction > 0)
        {
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
    Eigen::LLT<Eigen::MatrixXd> const llt(problem_.compliance(contacts, contacts));
    if (llt.info() != Eigen::Success)
        fail_complementarity("the compliance matrix is not positive definite");
    VectorXd const x = llt.solve(problem_.approach(contacts));
    if (!has_border())
    {
        f(contacts) = x;
        return f;
    }
    VectorXd const b = problem_.border(contacts);
    VectorXd const y = llt.solve(b);
    slope_ = b.dot(y);
    if (!keep_s && slope_ > 0)
        s = (problem_.total - b.dot(x)) / slope_;
    VectorXd on = x + s * y;
    // s b and d may be far larger than what they leave for f: once more for what is missing of T
    if (!keep_s && slope_ > 0)
    {
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
    for (Index i = 0; i < count_; ++i)
    {
        if (f[i] > 0)
            result.contacts.push_back(static_cast<int>(i));
        else
            f[i] = 0;
    }
    result.gap = gaps(f);
    result.residual = complementarity_residual(problem_, f, s);
    result.energy = f.dot(times(problem_.compliance, f)) / 2 - f.dot(problem_.approach);
    result.force = std::move(f);
    result.scalar = s;
    result.slope = slope_;
    result.iterations = iterations_;
    result.energies = energies;
    result.method = method;
    return result;
}

}  // namespace hdconj::detail
