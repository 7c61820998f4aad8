// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/complementarity.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/oracle/nnls.hpp"

namespace hdconj::test::complementarity_cases {

using Eigen::Index;

namespace {

constexpr double kkt = 1e-10;  // residual that is asked for

/// A positive definite matrix whose condition number is about 10^decades, with couplings of both signs.
Eigen::MatrixXd random_compliance(std::mt19937& random, Index n, double decades)
{
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-decades / 2, decades / 2);
    Eigen::MatrixXd q = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
    Eigen::MatrixXd const orthogonal = Eigen::HouseholderQR<Eigen::MatrixXd>(q).householderQ();
    Eigen::VectorXd const size = Eigen::VectorXd::NullaryExpr(n, [&] { return std::pow(10.0, uniform(random)); });
    Eigen::MatrixXd const g = orthogonal * size.asDiagonal() * orthogonal.transpose();
    return (g + g.transpose()) / 2;
}

Eigen::VectorXd random_vector(std::mt19937& random, Index n)
{
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
}

/// The solution with a border by trying every set of contacts.
std::optional<Eigen::VectorXd> by_enumeration(numeric::Complementarity const& problem)
{
    Index const n = problem.approach.size();
    for (int set = 0; set < 1 << n; ++set) {
        std::vector<int> in;
        for (int i = 0; i < n; ++i)
            if ((set >> i) & 1)
                in.push_back(i);
        auto const k = static_cast<Index>(in.size());
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(k + 1, k + 1);
        Eigen::VectorXd right(k + 1);
        for (Index a = 0; a < k; ++a) {
            for (Index b = 0; b < k; ++b)
                system(a, b) = problem.compliance(in[static_cast<std::size_t>(a)], in[static_cast<std::size_t>(b)]);
            system(a, k) = -problem.border[in[static_cast<std::size_t>(a)]];
            system(k, a) = problem.border[in[static_cast<std::size_t>(a)]];
            right[a] = problem.approach[in[static_cast<std::size_t>(a)]];
        }
        right[k] = problem.total;
        if (system.row(k).cwiseAbs().maxCoeff() == 0)
            continue;
        Eigen::VectorXd const x = system.fullPivHouseholderQr().solve(right);
        Eigen::VectorXd f = Eigen::VectorXd::Zero(n);
        for (Index a = 0; a < k; ++a)
            f[in[static_cast<std::size_t>(a)]] = x[a];
        Eigen::VectorXd const g = problem.compliance * f - problem.approach - problem.border * x[k];
        constexpr double rounding = 1e-11;
        if (f.minCoeff() >= -rounding && g.minCoeff() >= -rounding)
            return f;
    }
    return std::nullopt;
}

void require_falling(std::vector<double> const& energies)
{
    REQUIRE_FALSE(energies.empty());
    CHECK(std::is_sorted(energies.rbegin(), energies.rend()));
}

}  // namespace

TEST_CASE("contact forces are those of non-negative least squares", "[complementarity]")
{
    std::mt19937 random(20261121);
    for (int problem = 0; problem < 200; ++problem) {
        Index const n = 1 + problem % 40;
        numeric::Complementarity const given{
            random_compliance(random, n, 0.02 * problem), random_vector(random, n), {}, 0};
        Eigen::VectorXd const expected = nnls(given.compliance, given.approach);
        double const size = std::max(expected.maxCoeff(), 1e-300);
        for (numeric::ContactMethod const method :
             {numeric::ContactMethod::active_set, numeric::ContactMethod::projected}) {
            numeric::ComplementarityOptions options;
            options.first = method;
            auto const found = numeric::solve_complementarity(given, options);
            CAPTURE(problem, n, method);
            CHECK((found.force - expected).cwiseAbs().maxCoeff() <= 1e-9 * size);
            CHECK(found.residual <= kkt);
            CHECK(found.residual == complementarity_residual(given, found.force, 0));
            if (method == numeric::ContactMethod::projected && expected.maxCoeff() > 0)
                require_falling(found.energies);
        }
    }
}

TEST_CASE("a load on the border is carried as enumeration of all contacts says", "[complementarity]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-3, 3);
    int solved = 0;
    for (int problem = 0; problem < 300; ++problem) {
        Index const n = 1 + problem % 6;
        numeric::Complementarity given{random_compliance(random, n, 2), random_vector(random, n),
                                       random_vector(random, n), uniform(random)};
        CAPTURE(problem, n);
        bool const possible = (given.border * given.total).maxCoeff() > 0;
        for (numeric::ContactMethod const method :
             {numeric::ContactMethod::active_set, numeric::ContactMethod::projected}) {
            numeric::ComplementarityOptions options;
            options.first = method;
            if (!possible) {
                CHECK_THROWS_AS(solve_complementarity(given, options), NumericalError);
                continue;
            }
            auto const found = numeric::solve_complementarity(given, options);
            auto const expected = by_enumeration(given);
            REQUIRE(expected);
            CHECK((found.force - *expected).cwiseAbs().maxCoeff() <= 1e-9 * expected->maxCoeff());
            CHECK(found.residual <= kkt);
            ++solved;
        }
    }
    CHECK(solved > 300);
}

TEST_CASE("no cycling in ten thousand small problems", "[complementarity]")
{
    std::mt19937 random(3);
    int handed_over = 0;
    for (int problem = 0; problem < 10000; ++problem) {
        Index const n = 2 + problem % 7;
        numeric::Complementarity given{random_compliance(random, n, 4), random_vector(random, n), {}, 0};
        if (problem % 2 == 1) {
            given.border = random_vector(random, n);
            given.total = given.border.maxCoeff() > 0 ? 1 : -1;
        }
        auto const found = numeric::solve_complementarity(given);
        CHECK(found.residual <= kkt);
        if (found.method == numeric::ContactMethod::projected) {
            ++handed_over;
            if (given.border.size() == 0)
                CHECK((found.force - nnls(given.compliance, given.approach)).cwiseAbs().maxCoeff() <=
                      1e-9 * std::max(1.0, found.force.maxCoeff()));
        }
    }
    // some do cycle: the fallback is not there for nothing
    CHECK(handed_over > 0);
    CHECK(handed_over < 1000);
}

TEST_CASE("contact problems at their limits", "[complementarity]")
{
    SECTION("nothing at all")
    {
        auto const none = numeric::solve_complementarity({});
        CHECK(none.force.size() == 0);
        CHECK(none.residual == 0);
    }
    numeric::Complementarity given{Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, -2), Eigen::Vector2d(1, 1), 0};
    SECTION("no contact: the gaps stay and no force acts")
    {
        auto const found = numeric::solve_complementarity(given);
        CHECK(found.force.maxCoeff() == 0);
        CHECK(found.gap == Eigen::VectorXd(Eigen::Vector2d(1, 2)));
    }
    SECTION("the smallest load closes the nearest gap")
    {
        given.total = 1e-12;
        auto const found = numeric::solve_complementarity(given);
        CHECK(found.force[0] == Approx(1e-12));
        CHECK(found.force[1] == 0);
        CHECK(found.scalar == Approx(1));
    }
    SECTION("all in contact")
    {
        given.total = 100;
        auto const found = numeric::solve_complementarity(given);
        CHECK(found.force[0] == Approx(50.5));
        CHECK(found.force[1] == Approx(49.5));
    }
    SECTION("a load that no contact can carry")
    {
        given.total = -1;
        CHECK_THROWS_WITH(solve_complementarity(given), ContainsSubstring("no contact can carry the load of -1"));
    }
    SECTION("a gap exactly closed and without force is neither an overlap nor a fault")
    {
        given.approach.setZero();
        auto const found = numeric::solve_complementarity(given);
        CHECK(found.force.maxCoeff() == 0);
        CHECK(found.residual == 0);
    }
    SECTION("a matrix that is not positive definite")
    {
        given.compliance(1, 1) = -1;
        given.approach = Eigen::Vector2d(1, 1);
        given.border.resize(0);
        CHECK_THROWS_AS(solve_complementarity(given), NumericalError);
    }
    SECTION("what is not a number")
    {
        given.approach[0] = std::numeric_limits<double>::quiet_NaN();
        CHECK_THROWS_WITH(solve_complementarity(given), ContainsSubstring("not a number"));
    }
    SECTION("a neighbour's contacts to begin with change nothing but the work")
    {
        given.total = 3;
        numeric::ComplementarityOptions options;
        options.start = {1};
        auto const warm = numeric::solve_complementarity(given, options);
        auto const cold = numeric::solve_complementarity(given);
        CHECK((warm.force - cold.force).norm() <= 1e-14);
    }
}

TEST_CASE("a cylinder pressed on a half-plane takes Hertz' pressure", "[complementarity]")
{
    // strips of even pressure; u = -2/(pi E*) integral p ln|x - xi|, its datum far outside
    constexpr double e_star = 1e5, radius = 10, load = 50;  // MPa, mm, N/mm
    double const half_width = std::sqrt(4 * load * radius / (std::numbers::pi * e_star));
    double const peak = 2 * load / (std::numbers::pi * half_width);
    double last = 0;
    for (Index const n : {50, 100, 200}) {
        double const h = 3 * half_width / static_cast<double>(n);
        double const far = 20 * half_width;
        auto const primitive = [&](double x) { return x == 0 ? 0 : x * (std::log(std::abs(x) / far) - 1); };
        numeric::Complementarity contact;
        contact.compliance.resize(n, n);
        contact.approach.resize(n);
        contact.border = Eigen::VectorXd::Ones(n);
        contact.total = load;
        for (Index i = 0; i < n; ++i) {
            double const x = h * (static_cast<double>(i) + 0.5) - 1.5 * half_width;
            contact.approach[i] = -x * x / (2 * radius);
            for (Index j = 0; j < n; ++j) {
                double const apart = h * static_cast<double>(i - j);
                contact.compliance(i, j) =
                    -2 / (std::numbers::pi * e_star) * (primitive(apart + h / 2) - primitive(apart - h / 2)) / h;
            }
        }
        auto const found = numeric::solve_complementarity(contact);
        CHECK(found.residual <= kkt);
        double error = 0;
        for (Index i = 0; i < n; ++i) {
            double const x = (h * (static_cast<double>(i) + 0.5) - 1.5 * half_width) / half_width;
            error += std::abs(found.force[i] / h - peak * std::sqrt(std::max(0.0, 1 - x * x))) /
                     (peak * static_cast<double>(n));
        }
        CAPTURE(n, error);
        CHECK(error < 0.2 / static_cast<double>(n));
        CHECK(found.force.maxCoeff() / h == Approx(peak).epsilon(0.5 / static_cast<double>(n)));
        if (last > 0)
            CHECK(error < 0.6 * last);
        last = error;
    }
}

TEST_CASE("a wavy half-plane against a flat one takes Westergaard's pressure", "[complementarity]")
{
    // gap Delta (1 - cos k x), full contact from p* = E* k Delta/2 on; harmonic m k of the pressure moves the surface
    // by 2/(E* m k)
    constexpr double e_star = 1e5, wave = 1, height = 1e-4;
    constexpr Index n = 128;
    double const k = 2 * std::numbers::pi / wave, full = e_star * k * height / 2;
    for (double const share : {0.1, 0.5, 0.9}) {
        double const mean = share * full;
        numeric::Complementarity contact;
        contact.compliance = Eigen::MatrixXd::Zero(n, n);
        contact.approach.resize(n);
        contact.border = Eigen::VectorXd::Ones(n);
        contact.total = mean * wave;
        for (Index i = 0; i < n; ++i) {
            contact.approach[i] = -height * (1 - std::cos(k * wave * static_cast<double>(i) / n));
            for (Index j = 0; j < n; ++j) {
                // the mean is carried by s: any positive compliance of it will do
                double sum = 2 / (e_star * k * wave);
                for (Index m = 1; m <= n / 2; ++m)
                    sum += (2 * m == n ? 1.0 : 2.0) / wave * 2 / (e_star * static_cast<double>(m) * k) *
                           std::cos(2 * std::numbers::pi * static_cast<double>(m * (i - j)) / n);
                contact.compliance(i, j) = sum;
            }
        }
        auto const found = numeric::solve_complementarity(contact);
        CHECK(found.residual <= kkt);
        double const edge = std::sqrt(share);  // sine of half the phase at the contact's edge
        double error = 0;
        for (Index i = 0; i < n; ++i) {
            double const phase = std::numbers::pi * static_cast<double>(i) / n;
            double const inside = share - std::sin(phase) * std::sin(phase);
            double const expected = inside > 0 ? 2 * mean * std::abs(std::cos(phase)) / share * std::sqrt(inside) : 0;
            error += std::abs(found.force[i] * n / wave - expected) / (mean * n);
        }
        CAPTURE(share, edge, error);
        CHECK(error < 0.01);
    }
}

}  // namespace hdconj::test::complementarity_cases
