// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum.hpp"

#include <cmath>

#include "numeric/least_squares.hpp"

namespace hdconj::running {

std::vector<Harmonic> harmonics(std::vector<double> const& x, std::vector<double> const& values, int highest)
{
    auto const count = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixXd basis(count, 2 * highest + 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        double const at = x[static_cast<std::size_t>(i)];
        basis(i, 0) = 1;
        for (int k = 1; k <= highest; ++k) {
            basis(i, 2 * k - 1) = std::cos(k * at);
            basis(i, 2 * k) = std::sin(k * at);
        }
    }
    Eigen::VectorXd const wanted = Eigen::Map<Eigen::VectorXd const>(values.data(), count);
    Eigen::VectorXd const found = numeric::LeastSquares(basis).solve(wanted);
    std::vector<Harmonic> result;
    for (int k = 1; k <= highest; ++k)
        result.push_back({k, std::hypot(found[2 * k - 1], found[2 * k]), std::atan2(found[2 * k], found[2 * k - 1])});
    return result;
}

}  // namespace hdconj::running
