// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/compliance.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "support/catch.hpp"

namespace hdconj::test::compliance_cases {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// A contact problem with a border, few of whose contacts close.
numeric::Complementarity dense_problem(Index n, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(-1, 1);
    auto const any = [&](auto const&) { return even(random); };
    MatrixXd const m = MatrixXd::NullaryExpr(n, n, [&](Index, Index) { return even(random); });
    VectorXd const approach = VectorXd::NullaryExpr(n, [&](Index i) { return any(i) - 0.8; });
    VectorXd const border = VectorXd::NullaryExpr(n, [&](Index i) { return 1 + 0.1 * any(i); });
    MatrixXd compliance = m * m.transpose();
    compliance = (0.5 * (compliance + compliance.transpose())).eval();
    compliance.diagonal().array() += static_cast<double>(n);
    return {compliance, approach, border, 0.01};
}

/// The same with its first @p first columns on demand, each filled once.
numeric::Complementarity on_demand(numeric::Complementarity const& dense, Index first, std::atomic<int>& filled)
{
    MatrixXd const all = dense.compliance;
    Index const rest = all.rows() - first;
    numeric::Complementarity result{all.bottomRightCorner(rest, rest), dense.approach, dense.border, dense.total};
    result.leading = std::make_shared<numeric::ColumnsOnDemand>(all.diagonal().head(first), rest,
                                                                [all, &filled](Index j, VectorXd& values) {
                                                                    ++filled;
                                                                    values = all.col(j).head(values.size());
                                                                });
    return result;
}

}  // namespace

TEST_CASE("compliance: columns on demand give the bits of the dense matrix and are computed for closed contacts only",
          "[complementarity][parallel]")
{
    constexpr Index n = 700;
    numeric::Complementarity const dense = dense_problem(n, 3);
    for (Index const first : {Index{1}, Index{300}, n}) {
        for (numeric::ContactMethod const method :
             {numeric::ContactMethod::active_set, numeric::ContactMethod::projected}) {
            numeric::ComplementarityOptions options{.first = method};
            auto const expected = numeric::solve_complementarity(dense, options);
            REQUIRE(!expected.contacts.empty());
            REQUIRE(expected.contacts.size() < n / 3);
            for (int const threads : {1, 2, 3}) {
                CAPTURE(first, method, threads);
                options.threads = threads;
                std::atomic<int> filled = 0;
                numeric::Complementarity const problem = on_demand(dense, first, filled);
                auto const found = numeric::solve_complementarity(problem, options);
                CHECK(found.force == expected.force);
                CHECK(found.gap == expected.gap);
                CHECK(found.scalar == expected.scalar);
                CHECK(found.energy == expected.energy);
                CHECK(found.iterations == expected.iterations);
                CHECK(problem.leading->computed() == static_cast<std::size_t>(filled));
                CHECK(filled < n);
            }
        }
    }
}

TEST_CASE("compliance: parts and products with columns on demand are those of the dense matrix", "[complementarity]")
{
    constexpr Index n = 400;
    numeric::Complementarity const dense = dense_problem(n, 5);
    std::vector<int> which;
    for (int i = 0; i < n; i += 3)
        which.push_back(i);
    VectorXd x = dense.approach;
    for (Index i = 0; i < n; i += 2)
        x[i] = 0;
    MatrixXd const part = dense.compliance(which, which);
    VectorXd const product = numeric::times(dense, x, 1);
    CHECK((product - dense.compliance * x).norm() <= n * unit_roundoff * dense.compliance.norm() * x.norm());
    for (int const threads : {1, 2, 4}) {
        CHECK(numeric::principal_part(dense, which, threads) == part);
        MatrixXd const lower = numeric::lower_principal_part(dense, which, threads).triangularView<Eigen::Lower>();
        CHECK(lower == MatrixXd(part.triangularView<Eigen::Lower>()));
        CHECK(numeric::times(dense, x, threads) == product);
    }
    for (Index const first : {Index{1}, Index{150}, Index{399}, n}) {
        CAPTURE(first);
        std::atomic<int> filled = 0;
        CHECK(numeric::times(on_demand(dense, first, filled), x, 2) == product);
        CHECK(filled == n / 2);
        CHECK(numeric::principal_part(on_demand(dense, first, filled), which, 2) == part);
        MatrixXd const lower =
            numeric::lower_principal_part(on_demand(dense, first, filled), which, 2).triangularView<Eigen::Lower>();
        CHECK(lower == MatrixXd(part.triangularView<Eigen::Lower>()));
        CHECK(numeric::diagonal_of(on_demand(dense, first, filled)) == dense.compliance.diagonal());
        CHECK(numeric::work_of(on_demand(dense, first, filled), x, 2) == numeric::work_of(dense, x, 1));
    }
}

TEST_CASE("compliance: what yields counts as the matrix E'E beside the last contacts", "[complementarity][parallel]")
{
    constexpr Index n = 300, rest = 200, rank = 17;
    numeric::Complementarity const stiff = dense_problem(n, 11);
    MatrixXd const e = MatrixXd::NullaryExpr(
        rank, rest, [](Index i, Index j) { return std::sin(static_cast<double>(3 * i + 7 * j)); });
    numeric::Complementarity sum = stiff;
    sum.compliance.bottomRightCorner(rest, rest) += e.transpose() * e;
    std::vector<int> which;
    for (int i = 0; i < n; i += 3)
        which.push_back(i);
    VectorXd x = stiff.approach;
    for (Index i = 0; i < n; i += 2)
        x[i] = 0;
    double const rounding = n * unit_roundoff * sum.compliance.norm();
    for (Index const first : {Index{0}, Index{1}, Index{100}}) {
        CAPTURE(first);
        std::atomic<int> filled = 0;
        numeric::Complementarity yields = first > 0 ? on_demand(stiff, first, filled) : stiff;
        yields.yielding = e;
        MatrixXd const part = numeric::principal_part(yields, which, 1);
        CHECK((part - sum.compliance(which, which)).norm() <= rounding);
        CHECK((numeric::times(yields, x, 1) - sum.compliance * x).norm() <= rounding * x.norm());
        CHECK((numeric::diagonal_of(yields) - sum.compliance.diagonal()).norm() <= rounding);
        CHECK(numeric::work_of(yields, x, 1) == Approx(numeric::work_of(sum, x, 1)).epsilon(1e-12));
        for (int const threads : {2, 3}) {
            CHECK(numeric::principal_part(yields, which, threads) == part);
            CHECK(numeric::times(yields, x, threads) == numeric::times(yields, x, 1));
        }
        MatrixXd const lower = numeric::lower_principal_part(yields, which, 2).triangularView<Eigen::Lower>();
        CHECK((lower - MatrixXd(part.triangularView<Eigen::Lower>())).norm() <= rounding);
        auto const found = numeric::solve_complementarity(yields), expected = numeric::solve_complementarity(sum);
        CHECK((found.force - expected.force).norm() <= 1e-10 * expected.force.norm());
    }
}

TEST_CASE("compliance: a shared block gives the bits of an own one, and is refused where it is not a number",
          "[complementarity]")
{
    numeric::Complementarity const own = dense_problem(120, 13);
    numeric::Complementarity shares = own;
    shares.compliance.resize(0, 0);
    shares.shared = numeric::shared_compliance(own.compliance, 2);
    auto const expected = numeric::solve_complementarity(own), found = numeric::solve_complementarity(shares);
    CHECK(found.force == expected.force);
    CHECK(found.gap == expected.gap);
    MatrixXd bad = own.compliance;
    bad(3, 7) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(numeric::shared_compliance(bad, 2), NumericalError);
}

TEST_CASE("compliance: a column that is not a number is refused", "[complementarity]")
{
    numeric::Complementarity dense = dense_problem(50, 7);
    dense.compliance(3, 40) = dense.compliance(40, 3) = std::numeric_limits<double>::quiet_NaN();
    std::atomic<int> filled = 0;
    VectorXd x = VectorXd::Zero(50);
    x[3] = 1;
    CHECK_THROWS_AS(numeric::times(on_demand(dense, 10, filled), x, 1), NumericalError);
}

}  // namespace hdconj::test::compliance_cases
