// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a large symmetric matrix of which few are needed.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace hdconj::numeric {

/// What a symmetric matrix [F C'; C B] has beside its dense block B: the whole columns of F and C, and of B's columns
/// the rows of C'. Each is computed when it is first required.
class ColumnsOnDemand
{
  public:
    /// Writes column j: all rows where j is one of the first, the first rows otherwise.
    using Fill = std::function<void(Eigen::Index column, Eigen::VectorXd& values)>;

    /// @param diagonal  of F
    /// @param rest      number of rows of B
    ColumnsOnDemand(Eigen::VectorXd diagonal, Eigen::Index rest, Fill fill);

    /// Number of rows and columns of F.
    [[nodiscard]] Eigen::Index first() const { return diagonal_.size(); }
    [[nodiscard]] Eigen::VectorXd const& diagonal() const { return diagonal_; }

    /// Computes those of the columns @p which that are not there yet. The same bits for every number of threads.
    /// @returns whether all their elements are finite
    [[nodiscard]] bool require(std::vector<Eigen::Index> const& which, int threads);
    /// Column @p j, as it was filled. Domain: a column that was required.
    [[nodiscard]] Eigen::VectorXd const& operator[](Eigen::Index j) const
    {
        return columns_[static_cast<std::size_t>(j)];
    }
    /// Columns computed so far.
    [[nodiscard]] std::size_t computed() const;

  private:
    Eigen::VectorXd diagonal_;
    Fill fill_;
    std::vector<Eigen::VectorXd> columns_;  ///< empty: not yet required
};

}  // namespace hdconj::numeric
