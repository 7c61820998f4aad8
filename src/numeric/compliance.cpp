// SPDX-License-Identifier: GPL-3.0-or-later
#include "compliance.hpp"

#include <algorithm>

#include "complementarity_system.hpp"
#include "dense.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::numeric {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<Index> not_zero(VectorXd const& x)
{
    std::vector<Index> which;
    for (Index j = 0; j < x.size(); ++j)
        if (x[j] != 0)
            which.push_back(j);
    return which;
}

void require(ColumnsOnDemand& columns, std::vector<Index> const& which, int threads)
{
    if (!columns.require(which, threads))
        fail_complementarity("a compliance is not a number");
}

/// Columns of G whose part beside the dense block has been required.
struct Columns
{
    ColumnsOnDemand const& leading;
    MatrixXd const& block;

    [[nodiscard]] double operator()(Index i, Index j) const
    {
        Index const first = leading.first();
        return i < first || j < first ? leading[j][i] : block(i - first, j - first);
    }
    /// sum += x times the rows [begin, begin + size) of column j.
    void add(Index j, double x, Index begin, Eigen::Ref<VectorXd> sum) const
    {
        Index const first = leading.first();
        Index const above = j < first ? sum.size() : std::clamp<Index>(first - begin, 0, sum.size());
        sum.head(above) += x * leading[j].segment(begin, above);
        if (Index const below = sum.size() - above; below > 0)
            sum.tail(below) += x * block.col(j - first).segment(begin + above - first, below);
    }
};

/// Rows and columns @p which, of column j the rows from @p first_row(j) on.
template <class FirstRow>
MatrixXd part_of(Columns const& g, std::vector<int> const& which, int threads, FirstRow const& first_row)
{
    constexpr std::size_t grain = 32;
    auto const count = static_cast<Index>(which.size());
    MatrixXd part(count, count);
    parallel_for(which.size(), threads, grain, [&](std::size_t j) {
        for (std::size_t i = first_row(j); i < which.size(); ++i)
            part(static_cast<Index>(i), static_cast<Index>(j)) = g(which[i], which[j]);
    });
    return part;
}

}  // namespace

VectorXd times(Complementarity const& problem, VectorXd const& x, int threads)
{
    if (!problem.leading)
        return times(problem.compliance, x, threads);
    constexpr Index tile = 128;  // as that of dense.cpp, for the same bits
    std::vector<Index> const which = not_zero(x);
    require(*problem.leading, which, threads);
    Columns const g{*problem.leading, problem.compliance};
    VectorXd result = VectorXd::Zero(x.size());
    auto const tiles = static_cast<std::size_t>((x.size() + tile - 1) / tile);
    parallel_for(tiles, threads, 1, [&](std::size_t t) {
        Index const begin = static_cast<Index>(t) * tile;
        auto sum = result.segment(begin, std::min(tile, x.size() - begin));
        for (Index const j : which)
            g.add(j, x[j], begin, sum);
    });
    return result;
}

MatrixXd principal_part(Complementarity const& problem, std::vector<int> const& which, int threads)
{
    if (!problem.leading)
        return principal_part(problem.compliance, which, threads);
    require(*problem.leading, {which.begin(), which.end()}, threads);
    return part_of({*problem.leading, problem.compliance}, which, threads, [](std::size_t) { return std::size_t{0}; });
}

MatrixXd lower_principal_part(Complementarity const& problem, std::vector<int> const& which, int threads)
{
    if (!problem.leading)
        return lower_principal_part(problem.compliance, which, threads);
    // Below the diagonal, columns of the dense block have no row of another one.
    require(*problem.leading, {which.begin(), std::ranges::lower_bound(which, problem.leading->first())}, threads);
    return part_of({*problem.leading, problem.compliance}, which, threads, [](std::size_t column) { return column; });
}

VectorXd diagonal_of(Complementarity const& problem)
{
    if (!problem.leading)
        return problem.compliance.diagonal();
    VectorXd result(problem.approach.size());
    result << problem.leading->diagonal(), problem.compliance.diagonal();
    return result;
}

double work_of(Complementarity const& problem, VectorXd const& force, int threads)
{
    std::vector<Index> const on = not_zero(force);
    if (problem.leading)
        require(*problem.leading, on, threads);
    auto const element = [&](Index i, Index j) {
        return problem.leading ? Columns{*problem.leading, problem.compliance}(i, j) : problem.compliance(i, j);
    };
    double work = 0;
    for (std::size_t j = 0; j < on.size(); ++j) {
        double below = 0;
        for (std::size_t i = j + 1; i < on.size(); ++i)
            below += element(on[i], on[j]) * force[on[i]];
        work += force[on[j]] * (2 * below + element(on[j], on[j]) * force[on[j]]);
    }
    return work;
}

}  // namespace hdconj::numeric
