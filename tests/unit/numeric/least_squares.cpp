// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/least_squares.hpp"

#include <Eigen/Core>
#include <random>

#include "hdconj/base/tolerance.hpp"
#include "support/catch.hpp"

namespace hdconj::test::least_squares_cases {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd random_matrix(Index rows, Index columns, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(-1, 1);
    return MatrixXd::NullaryExpr(rows, columns, [&](Index, Index) { return even(random); });
}

}  // namespace

TEST_CASE("least squares: what is left is normal to all columns, for one right side and for several", "[least squares]")
{
    MatrixXd const a = random_matrix(40, 5, 1), b = random_matrix(40, 3, 2);
    numeric::LeastSquares const fit(a);
    REQUIRE(fit.rank() == 5);
    double const rounding = 64 * unit_roundoff * a.norm() * b.norm();
    MatrixXd const x = fit.solve(b);
    CHECK((a.transpose() * (b - a * x)).norm() <= rounding);
    for (Index i = 0; i < b.cols(); ++i) {
        VectorXd const one = fit.solve(VectorXd(b.col(i)));
        CHECK((one - x.col(i)).norm() <= rounding);
    }
    MatrixXd const unit = a.transpose() * a * numeric::covariance(a);
    CHECK((unit - MatrixXd::Identity(5, 5)).norm() <= rounding);
}

TEST_CASE("least squares: a column that says next to nothing new does not count above the threshold", "[least squares]")
{
    MatrixXd a = random_matrix(20, 4, 3);
    a.col(3) = a.col(0) - 2 * a.col(1);
    a(0, 3) += 1e-6;
    CHECK(numeric::LeastSquares(a).rank() == 4);
    numeric::LeastSquares const coarse(a, 1e-3);
    CHECK(coarse.rank() == 3);
    CHECK(coarse.chosen(3) != 2);  // the only one that the others do not make
}

}  // namespace hdconj::test::least_squares_cases
