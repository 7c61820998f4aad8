// SPDX-License-Identifier: GPL-3.0-or-later
// Dense matrices, compiled once: decompositions are templates that take seconds wherever they are used. Every result
// has the same bits for every number of threads.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace hdconj::numeric {

/// Whether every element is a finite number. Exact.
[[nodiscard]] bool all_finite(Eigen::MatrixXd const& a, int threads);

/// Factor L of a symmetric positive definite A = L L'. Accuracy: as any Cholesky factor, |A - L L'| <= n eps |A|
/// (Higham 2002, 10.1).
class Cholesky
{
  public:
    /// @param a  its lower triangle is looked at
    Cholesky(Eigen::MatrixXd a, int threads);

    /// Whether A, of finite elements, is positive definite, to rounding; there is no factor else.
    [[nodiscard]] bool found() const { return found_; }
    /// A^-1 b
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd const& b) const;

  private:
    Eigen::MatrixXd factor_;  ///< L in its lower triangle
    bool found_ = true;
};

/// Triangular factors of a square matrix whose rows are exchanged, P A = L U, by GSL. Accuracy: residuals of a solution
/// of some n eps |A| |x| (Golub and Van Loan 2013, 3.4).
class LU
{
  public:
    explicit LU(Eigen::MatrixXd const& a);

    /// Whether a pivot is 0. Nothing below has a meaning then.
    [[nodiscard]] bool is_singular() const;
    /// A^-1 b
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd const& b) const;
    /// A^-1
    [[nodiscard]] Eigen::MatrixXd inverse() const;

  private:
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> factors_;  // both, as GSL keeps them
    std::vector<std::size_t> order_;                                                  // of the rows
};

}  // namespace hdconj::numeric
