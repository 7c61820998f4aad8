// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix G of a complementarity problem, of which some columns are computed when they are needed.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "complementarity.hpp"

namespace hdconj::numeric {

/// A block for Complementarity::shared. @throws NumericalError where it holds what is not a number
[[nodiscard]] std::shared_ptr<Eigen::MatrixXd const> shared_compliance(Eigen::MatrixXd block, int threads);

// Every result has the same bits for every number of threads, and whether or not columns are computed on demand.
// Columns that are not finite numbers are refused: NumericalError.

/// G x, from the columns where x is not 0: costs their number times the rows.
[[nodiscard]] Eigen::VectorXd times(Complementarity const& problem, Eigen::VectorXd const& x, int threads);

/// Rows and columns @p which of G.
[[nodiscard]] Eigen::MatrixXd principal_part(Complementarity const& problem, std::vector<int> const& which,
                                             int threads);

/// Its lower triangle alone, which is what Cholesky looks at; elements above the diagonal are any numbers. Half the
/// work. @param which  increasing
[[nodiscard]] Eigen::MatrixXd lower_principal_part(Complementarity const& problem, std::vector<int> const& which,
                                                   int threads);

/// The diagonal of G.
[[nodiscard]] Eigen::VectorXd diagonal_of(Complementarity const& problem);

/// f'G f
[[nodiscard]] double work_of(Complementarity const& problem, Eigen::VectorXd const& force, int threads);

}  // namespace hdconj::numeric
