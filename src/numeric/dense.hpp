// SPDX-License-Identifier: GPL-3.0-or-later
// Dense matrices by several threads. Every result has the same bits for every number of them.
#pragma once

#include <Eigen/Core>

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

}  // namespace hdconj::numeric
