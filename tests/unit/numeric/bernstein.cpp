// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/numeric/bernstein_roots.hpp"

#include <random>

#include "support/catch.hpp"

namespace hdconj::test::bernstein_cases {

namespace {

/// Bernstein coefficients of prod (t - root).
std::vector<double> from_roots(std::vector<double> const& roots)
{
    std::vector<double> p{1.0};
    for (double root : roots) {
        std::vector<double> const factor{-root, 1 - root};
        p = numeric::bernstein_product(p, factor);
    }
    return p;
}

}  // namespace

TEST_CASE("Bernstein value, derivative, product and raised degree agree with the monomial form", "[numeric]")
{
    // t^2 - t/2 + 1/8 in Bernstein form of degree 2
    std::vector<double> const p{0.125, -0.125, 0.625};
    for (double t : {0.0, 0.1, 0.5, 0.77, 1.0}) {
        double const exact = t * t - t / 2 + 0.125;
        CHECK(numeric::bernstein_value(p, t) == Approx(exact).margin(1e-16));
        CHECK(numeric::bernstein_value(numeric::bernstein_derivative(p), t) == Approx(2 * t - 0.5).margin(1e-15));
        CHECK(numeric::bernstein_value(numeric::bernstein_raised(p, 7), t) == Approx(exact).margin(1e-15));
        CHECK(numeric::bernstein_value(numeric::bernstein_product(p, p), t) == Approx(exact * exact).margin(1e-15));
    }
}

TEST_CASE("a split polynomial is the same on both halves", "[numeric]")
{
    std::vector<double> p{1, -3, 2.5, 0.25, -1};
    std::vector<double> low = p;
    std::vector<double> high(p.size());
    numeric::bernstein_split(low, high, 0.3);
    for (double t : {0.0, 0.2, 0.9, 1.0}) {
        CHECK(numeric::bernstein_value(low, t) == Approx(numeric::bernstein_value(p, 0.3 * t)).margin(1e-15));
        CHECK(numeric::bernstein_value(high, t) == Approx(numeric::bernstein_value(p, 0.3 + 0.7 * t)).margin(1e-15));
    }
}

TEST_CASE("random planted roots are all found and none invented", "[numeric]")
{
    std::mt19937 random(20120601);
    std::uniform_real_distribution<double> inside(0.01, 0.99), outside(1.05, 3.0);
    int planted = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> roots;
        int const in = trial % 6;
        for (int k = 0; k < in; ++k)
            roots.push_back(inside(random));
        std::sort(roots.begin(), roots.end());
        bool apart = true;
        for (std::size_t k = 1; k < roots.size(); ++k)
            apart = apart && roots[k] - roots[k - 1] > 1e-3;
        if (!apart)
            continue;
        std::vector<double> all = roots;
        all.push_back(outside(random));
        all.push_back(-outside(random));
        numeric::BernsteinRoots const found = numeric::bernstein_roots(from_roots(all), 1e-15);
        REQUIRE(found.count == in);
        for (int k = 0; k < in; ++k)
            CHECK(found.t[static_cast<std::size_t>(k)] == Approx(roots[static_cast<std::size_t>(k)]).margin(1e-9));
        planted += in;
    }
    REQUIRE(planted > 3000);
}

TEST_CASE("a double root is reported once with its width, a root at an end once at the end", "[numeric]")
{
    numeric::BernsteinRoots const twice = numeric::bernstein_roots(from_roots({0.4, 0.4, 2.0}), 1e-16);
    REQUIRE(twice.count >= 1);
    CHECK(twice.t[0] == Approx(0.4).margin(1e-6));
    numeric::BernsteinRoots const at_end = numeric::bernstein_roots(from_roots({0.0, 0.6}), 1e-16);
    REQUIRE(at_end.count == 2);
    CHECK(at_end.t[0] == Approx(0.0).margin(1e-12));
    CHECK(numeric::bernstein_roots(std::vector<double>{1, 2, 3, 0.5}, 1e-16).count == 0);
}

}  // namespace hdconj::test::bernstein_cases
