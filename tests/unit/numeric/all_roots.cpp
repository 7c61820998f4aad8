// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/numeric/all_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"

namespace hdconj::test::all_roots_cases {

namespace {

/// What a scan over a grid finds: the negative control for a pair of roots between two grid points.
template <class F>
int sign_changes_on_grid(F&& f, double a, double b, int steps)
{
    int found = 0;
    double before = f(a);
    for (int i = 1; i <= steps; ++i) {
        double const now = f(a + (b - a) * i / steps);
        found += (before < 0) != (now < 0);
        before = now;
    }
    return found;
}

}  // namespace

TEST_CASE("all roots of a sine over many periods", "[numeric]")
{
    numeric::RootSet const found = numeric::all_roots([](double x) { return std::sin(x); }, 0.5, 100.5, 1);
    REQUIRE(found.certified);
    REQUIRE(found.roots.size() == 31);
    for (std::size_t k = 0; k < found.roots.size(); ++k) {
        CHECK(found.roots[k].x == Approx(std::numbers::pi * static_cast<double>(k + 1)).epsilon(1e-15));
        CHECK_FALSE(found.roots[k].near_double);
    }
}

TEST_CASE("a close pair that a scan steps over is found", "[numeric]")
{
    for (double gap : {1e-2, 1e-4, 1e-6}) {
        double const middle = 0.3183098861;
        auto const f = [&](double x) { return (x - middle - gap / 2) * (x - middle + gap / 2) * std::exp(x); };
        numeric::RootSet const found = numeric::all_roots(f, -1, 1, 1);
        INFO("gap " << gap);
        REQUIRE(found.roots.size() == 2);
        // f is right to roundoff, its slope at the roots is about the gap
        CHECK(found.roots[1].x - found.roots[0].x == Approx(gap).margin(1e-15 / gap));
    }
    auto const f = [](double x) { return (x - 0.3183098861) * (x - 0.3183098861) - 1e-8; };
    CHECK(sign_changes_on_grid(f, -1, 1, 500) == 0);
}

TEST_CASE("a double root comes out as one flagged root of stated width, not as nothing", "[numeric]")
{
    double const middle = 0.123456789;
    numeric::RootSet const found = numeric::all_roots([&](double x) { return (x - middle) * (x - middle); }, -1, 1, 1);
    REQUIRE(found.roots.size() == 1);
    CHECK(found.roots[0].near_double);
    CHECK(std::abs(found.roots[0].x - middle) <= found.roots[0].width);
    // double precision cannot see a pair closer than about sqrt of roundoff
    CHECK(found.roots[0].width < 1e-6);
    CHECK(found.roots[0].width > 0);
}

TEST_CASE("no root is invented", "[numeric]")
{
    CHECK(numeric::all_roots([](double x) { return x * x + 1e-10; }, -1, 1, 1).roots.empty());
    CHECK(numeric::all_roots([](double x) { return std::cosh(x) - 0.999; }, -3, 3, 10).roots.empty());
    CHECK(numeric::all_roots([](double x) { return std::sin(x); }, 1, 1, 1).roots.empty());
}

TEST_CASE("a function that vanishes on a piece is said to", "[numeric]")
{
    numeric::RootSet const found = numeric::all_roots([](double) { return 0.0; }, 0, 1, 1);
    CHECK(found.vanishes);
    REQUIRE(found.roots.size() == 1);
    CHECK(found.roots[0].width == Approx(1));
}

TEST_CASE("noise far above its stated scale ends with an honest no, in bounded work", "[numeric]")
{
    unsigned state = 1;
    auto const noisy = [&](double x) {
        state = state * 1664525u + 1013904223u;
        return x * x - 0.25 + 1e-3 * (static_cast<double>(state) / 4294967296.0 - 0.5);
    };
    numeric::RootSet const found = numeric::all_roots(noisy, -1, 1, 1);
    CHECK_FALSE(found.certified);
    CHECK(found.evaluations < 1000000);
}

TEST_CASE("waves that look smooth at the nodes are not taken for smooth", "[numeric]")
{
    // at the 17 nodes of [-1, 1] cos(32 arccos x) = 1: an interpolant that never crosses 0 for a function with 32 roots
    auto const alias = [](double x) { return std::cos(32 * std::acos(std::clamp(x, -1.0, 1.0))) - 0.5; };
    numeric::RootSet const found = numeric::all_roots(alias, -1, 1, 1);
    REQUIRE(found.certified);
    CHECK(found.roots.size() == 32);
    for (numeric::IsolatedRoot const& root : found.roots)
        CHECK(std::abs(alias(root.x)) < 1e-13);
}

TEST_CASE("high frequencies and many waves are all counted", "[numeric]")
{
    for (double waves : {37.0, 211.0, 1501.0}) {
        numeric::RootSet const found =
            numeric::all_roots([&](double x) { return std::sin(waves * std::numbers::pi * (x - 0.1234567)); }, 0, 1, 1);
        REQUIRE(found.certified);
        CHECK(found.roots.size() == static_cast<std::size_t>(waves));
    }
}

TEST_CASE("bumps through zero are found, from a fortieth of the interval on", "[numeric]")
{
    int seen = 0;
    for (double w : {0.3, 0.1, 0.05}) {
        for (int k = 0; k < 50; ++k) {
            double const at = -0.9 + 1.8 * k / 50 + 0.0123;
            numeric::RootSet const found = numeric::all_roots(
                [&](double x) { return 1 - 2 * std::exp(-(x - at) * (x - at) / (w * w)); }, -1, 1, 1);
            double const half = w * std::sqrt(std::log(2.0));
            int const expected = (at - half > -1) + (at + half < 1);
            seen += found.certified && static_cast<int>(found.roots.size()) == expected;
        }
    }
    CHECK(seen == 150);
}

TEST_CASE("a corner is found or said not to be certified", "[numeric]")
{
    for (double depth : {1e-3, 1e-6, 1e-9}) {
        double const at = 0.2718281;
        numeric::RootSet const found = numeric::all_roots([&](double x) { return std::abs(x - at) - depth; }, -1, 1, 1);
        CHECK((found.roots.size() == 2 || !found.certified));
    }
}

TEST_CASE("the work for a smooth function is a few interpolants", "[numeric]")
{
    std::size_t calls = 0;
    auto const f = [&](double x) {
        ++calls;
        return std::cos(2 * x) - 0.3;
    };
    numeric::RootSet const found = numeric::all_roots(f, -std::numbers::pi / 2, std::numbers::pi / 2, 1);
    CHECK(found.roots.size() == 2);
    CHECK(found.evaluations <= 220);
    CHECK(calls <= found.evaluations + 2 * found.roots.size() * 2);
}

}  // namespace hdconj::test::all_roots_cases
