// SPDX-License-Identifier: GPL-3.0-or-later
#include "compliance.hpp"

#include <algorithm>
#include <utility>

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

/// Columns of G without what yields: those that were required, where they are computed on demand.
class Columns
{
  public:
    Columns(Complementarity const& problem, std::vector<Index> const& required, int threads)
        : leading_(problem.leading.get()), first_(leading_ != nullptr ? leading_->first() : 0), block_(problem.block())
    {
        if (leading_ != nullptr && !leading_->require(required, threads))
            fail_complementarity("a compliance is not a number");
    }

    [[nodiscard]] double operator()(Index i, Index j) const
    {
        return i < first_ || j < first_ ? (*leading_)[j][i] : block_(i - first_, j - first_);
    }
    /// sum += x times the rows [begin, begin + size) of column j.
    void add(Index j, double x, Index begin, Eigen::Ref<VectorXd> sum) const
    {
        Index const above = j < first_ ? sum.size() : std::clamp<Index>(first_ - begin, 0, sum.size());
        if (above > 0)
            sum.head(above) += x * (*leading_)[j].segment(begin, above);
        if (Index const below = sum.size() - above; below > 0)
            sum.tail(below) += x * block_.col(j - first_).segment(begin + above - first_, below);
    }

  private:
    ColumnsOnDemand* leading_;  ///< null: all columns are in the block
    Index first_;
    MatrixXd const& block_;
};

/// Columns of E for those of the contacts @p which that have one: the last ones.
MatrixXd yielding_of(Complementarity const& problem, std::vector<int> const& which)
{
    Index const first = problem.approach.size() - problem.yielding.cols();
    std::vector<Index> columns;
    for (int const i : which)
        if (i >= first)
            columns.push_back(i - first);
    return problem.yielding(Eigen::all, columns);
}

/// Rows and columns @p which, of column j the rows from @p first_row(j) on.
template <class FirstRow>
MatrixXd part_of(Complementarity const& problem, Columns const& g, std::vector<int> const& which, int threads,
                 FirstRow const& first_row)
{
    constexpr std::size_t grain = 32;
    auto const count = static_cast<Index>(which.size());
    MatrixXd part(count, count);
    parallel_for(which.size(), threads, grain, [&](std::size_t j) {
        for (std::size_t i = first_row(j); i < which.size(); ++i)
            part(static_cast<Index>(i), static_cast<Index>(j)) = g(which[i], which[j]);
    });
    if (problem.yielding.size() == 0)
        return part;
    MatrixXd const e = yielding_of(problem, which);
    Index const rigid = count - e.cols();
    constexpr Index tile = 32;
    parallel_for(static_cast<std::size_t>((e.cols() + tile - 1) / tile), threads, 1, [&](std::size_t t) {
        Index const begin = static_cast<Index>(t) * tile, width = std::min(tile, e.cols() - begin);
        auto const row = static_cast<Index>(first_row(static_cast<std::size_t>(begin)));
        part.block(rigid + row, rigid + begin, e.cols() - row, width).noalias() +=
            e.rightCols(e.cols() - row).transpose() * e.middleCols(begin, width);
    });
    return part;
}

}  // namespace

std::shared_ptr<MatrixXd const> shared_compliance(MatrixXd block, int threads)
{
    if (!all_finite(block, threads))
        fail_complementarity("a compliance is not a number");
    return std::make_shared<MatrixXd const>(std::move(block));
}

VectorXd times(Complementarity const& problem, VectorXd const& x, int threads)
{
    constexpr Index tile = 128;
    std::vector<Index> const which = not_zero(x);
    Columns const g(problem, which, threads);
    VectorXd result = VectorXd::Zero(x.size());
    auto const tiles = static_cast<std::size_t>((x.size() + tile - 1) / tile);
    parallel_for(tiles, threads, 1, [&](std::size_t t) {
        Index const begin = static_cast<Index>(t) * tile;
        auto sum = result.segment(begin, std::min(tile, x.size() - begin));
        for (Index const j : which)
            g.add(j, x[j], begin, sum);
    });
    if (problem.yielding.size() > 0) {
        VectorXd const moved = problem.yielding * x.tail(problem.yielding.cols());
        result.tail(problem.yielding.cols()) += problem.yielding.transpose() * moved;
    }
    return result;
}

MatrixXd principal_part(Complementarity const& problem, std::vector<int> const& which, int threads)
{
    Columns const g(problem, {which.begin(), which.end()}, threads);
    return part_of(problem, g, which, threads, [](std::size_t) { return std::size_t{0}; });
}

MatrixXd lower_principal_part(Complementarity const& problem, std::vector<int> const& which, int threads)
{
    // Below the diagonal, columns of the dense block have no row of another one.
    Index const first = problem.leading ? problem.leading->first() : 0;
    Columns const g(problem, {which.begin(), std::ranges::lower_bound(which, first)}, threads);
    return part_of(problem, g, which, threads, [](std::size_t column) { return column; });
}

VectorXd diagonal_of(Complementarity const& problem)
{
    VectorXd result(problem.approach.size());
    if (problem.leading)
        result << problem.leading->diagonal(), problem.block().diagonal();
    else
        result = problem.block().diagonal();
    if (problem.yielding.size() > 0)
        result.tail(problem.yielding.cols()) += problem.yielding.colwise().squaredNorm().transpose();
    return result;
}

double work_of(Complementarity const& problem, VectorXd const& force, int threads)
{
    std::vector<Index> const on = not_zero(force);
    Columns const g(problem, on, threads);
    double work = 0;
    for (std::size_t j = 0; j < on.size(); ++j) {
        double below = 0;
        for (std::size_t i = j + 1; i < on.size(); ++i)
            below += g(on[i], on[j]) * force[on[i]];
        work += force[on[j]] * (2 * below + g(on[j], on[j]) * force[on[j]]);
    }
    if (problem.yielding.size() > 0)
        work += (problem.yielding * force.tail(problem.yielding.cols())).squaredNorm();
    return work;
}

}  // namespace hdconj::numeric
