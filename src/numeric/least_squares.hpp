// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares, compiled once: Eigen's decompositions are templates that take seconds wherever they are used.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

namespace hdconj::numeric {

/// x with the least |A x - b|, by Householder reflections with pivoted columns (Golub and Van Loan 2013, 5.4).
/// Degenerate: of a matrix that is not of full rank x is one of many, and may be large; ask for the rank first.
/// Accuracy: backward stable, |A| n eps. Errors: none.
class LeastSquares
{
  public:
    /// @param a  rows of observations; there may be fewer of them than columns
    explicit LeastSquares(Eigen::MatrixXd const& a);
    /// @param threshold  pivots below it, relative to the largest, count as 0
    LeastSquares(Eigen::MatrixXd const& a, double threshold);

    /// Number of pivots that count. It changes no solution.
    [[nodiscard]] Eigen::Index rank() const { return qr_.rank(); }
    /// Column that was chosen as number @p i, the most independent first.
    [[nodiscard]] Eigen::Index chosen(Eigen::Index i) const { return qr_.colsPermutation().indices()[i]; }
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd const& b) const;
    /// One solution for each column.
    [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd const& b) const;

  private:
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
};

/// (A' A)^-1, the covariance of a solution for observations of variance 1. Domain: A of full rank.
[[nodiscard]] Eigen::MatrixXd covariance(Eigen::MatrixXd const& a);

}  // namespace hdconj::numeric
