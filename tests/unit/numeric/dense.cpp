// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <limits>
#include <random>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "support/catch.hpp"

namespace hdconj::test::dense_cases {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd random_matrix(Index rows, Index columns, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(-1, 1);
    MatrixXd m(rows, columns);
    for (Index j = 0; j < columns; ++j)
        for (Index i = 0; i < rows; ++i)
            m(i, j) = even(random);
    return m;
}

MatrixXd positive_definite(Index n, unsigned seed)
{
    MatrixXd const m = random_matrix(n, n + 3, seed);
    return m * m.transpose();
}

}  // namespace

TEST_CASE("dense: a Cholesky factor solves to rounding, of any size, with the same bits for every number of threads",
          "[dense][parallel]")
{
    for (Index const n : {1, 2, 47, 48, 49, 96, 200, 403}) {
        MatrixXd const a = positive_definite(n, static_cast<unsigned>(n));
        VectorXd const b = random_matrix(n, 1, 7).col(0);
        numeric::Cholesky const one(a, 1);
        REQUIRE(one.found());
        VectorXd const x = one.solve(b);
        // backward error of a stable solver
        double const residual = (a * x - b).norm() / (a.norm() * x.norm() + b.norm());
        CHECK(residual < 8 * static_cast<double>(n) * unit_roundoff);
        for (int const threads : {2, 3, 5})
            CHECK(numeric::Cholesky(a, threads).solve(b) == x);
    }
}

TEST_CASE("dense: a Cholesky factor looks at the lower triangle only", "[dense]")
{
    MatrixXd const a = positive_definite(130, 3);
    MatrixXd lower = a;
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    VectorXd const b = VectorXd::Ones(130);
    CHECK(numeric::Cholesky(lower, 2).solve(b) == numeric::Cholesky(a, 1).solve(b));
}

TEST_CASE("dense: what is not positive definite has no factor, wherever it shows", "[dense]")
{
    MatrixXd const a = positive_definite(150, 11);
    for (Index const i : {0, 60, 149}) {
        MatrixXd bad = a;
        bad(i, i) = -1;
        CHECK(!numeric::Cholesky(bad, 1).found());
        CHECK(!numeric::Cholesky(bad, 2).found());
    }
    CHECK(numeric::Cholesky(MatrixXd(0, 0), 2).found());
}

TEST_CASE("dense: what is not finite is found with every number of threads", "[dense][parallel]")
{
    Index const n = 1100;  // enough for a second thread
    MatrixXd const a = random_matrix(n, n, 5);
    for (int const threads : {1, 2, 4}) {
        CHECK(numeric::all_finite(a, threads));
        for (double const bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
            MatrixXd broken = a;
            broken(n - 1, 351) = bad;
            CHECK(!numeric::all_finite(broken, threads));
        }
    }
}

TEST_CASE("dense: factors with exchanged rows solve to rounding, and tell a matrix without an inverse", "[dense]")
{
    for (Index const n : {1, 2, 7, 40, 130}) {
        MatrixXd a = random_matrix(n, n, static_cast<unsigned>(n));
        if (n > 1)
            a(0, 0) = 0;  // a first row that must be exchanged
        numeric::LU const factors(a);
        REQUIRE_FALSE(factors.is_singular());
        VectorXd const b = random_matrix(n, 1, 7).col(0), x = factors.solve(b);
        double const residual = (a * x - b).norm() / (a.norm() * x.norm() + b.norm());
        CHECK(residual < 8 * static_cast<double>(n) * unit_roundoff);
        MatrixXd const inverse = factors.inverse();
        double const rest = (a * inverse - MatrixXd::Identity(n, n)).norm() / (a.norm() * inverse.norm());
        CHECK(rest < 8 * static_cast<double>(n) * unit_roundoff);
        a.col(n - 1).setZero();
        CHECK(numeric::LU(a).is_singular());
    }
}

}  // namespace hdconj::test::dense_cases
