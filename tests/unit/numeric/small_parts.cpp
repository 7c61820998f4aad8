// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/segments.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/numeric/bracketed_minimum.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/numeric/chebyshev.hpp"
#include "hdconj/numeric/fourier.hpp"
#include "numeric/least_between.hpp"
#include "support/catch.hpp"

namespace hdconj::test::small_parts_cases {

TEST_CASE("a bracketed root is found to the last bits in few evaluations", "[numeric]")
{
    int calls = 0;
    auto const f = [&](double x) {
        ++calls;
        return std::cos(x) - x;
    };
    numeric::BracketedRoot const root = numeric::bracketed_root(f, 0, 1);
    REQUIRE(root.found);
    CHECK(root.x == Approx(0.7390851332151607).epsilon(1e-15));
    CHECK(calls <= 14);
}

TEST_CASE("a minimum beside a place is found where the function falls from there", "[numeric]")
{
    for (double const sense : {1.0, -1.0}) {
        // smooth: the value to rounding, the place to its square root
        auto const smooth = [&](double x) { return (sense * x - 0.3) * (sense * x - 0.3) - 1; };
        numeric::BracketedMinimum const round = numeric::minimum_beside(smooth, 0.0, sense, smooth(0), 1e-15);
        CHECK(round.value == Approx(-1).epsilon(1e-14));
        CHECK(round.x == Approx(0.3 * sense).margin(1e-6));
        // pointed: slopes that differ, as where a corner passes
        auto const pointed = [&](double x) { return std::max(0.5 - 2 * sense * x, 0.1 * (sense * x - 0.2)); };
        numeric::BracketedMinimum const sharp = numeric::minimum_beside(pointed, 0.0, sense, pointed(0), 1e-15);
        CHECK(sharp.value == Approx(0.52 * 0.1 / 2.1 - 0.02).margin(1e-14));
        CHECK(pointed(sharp.x) == sharp.value);
        // falling all the way: the other end
        auto const falling = [&](double x) { return -sense * x; };
        CHECK(numeric::minimum_beside(falling, 0.0, sense, 0.0, 1e-15).value == Approx(-1).epsilon(1e-14));
        // rising: the place itself, after one look
        int looks = 0;
        auto const rising = [&](double x) {
            ++looks;
            return sense * x;
        };
        CHECK(numeric::minimum_beside(rising, 0.0, sense, 0.0, 1e-15).x == 0);
        CHECK(looks == 1);
    }
}

TEST_CASE("the smallest of several minima is found over whole numbers", "[numeric]")
{
    // minima near 1.2, 4.6 (the deepest) and 7.9
    auto const waves = [](double x) {
        return std::min({std::abs(x - 1.2), 2 * std::abs(x - 4.6) - 0.3, (x - 7.9) * (x - 7.9) + 0.1});
    };
    for (double const from : {0.0, 9.0}) {
        numeric::BracketedMinimum const found = numeric::minimum_of_steps(waves, from, 9 - from, waves(from), 1e-15);
        CHECK(found.value == Approx(-0.3).margin(1e-14));
        CHECK(found.x == Approx(4.6).margin(1e-14));
    }
    CHECK(numeric::minimum_of_steps(waves, 2.0, 2.0, waves(2), 1e-15).x == 2);
    CHECK(numeric::minimum_of_steps(waves, 6.0, 5.0, waves(6), 1e-15).x == Approx(5));
}

TEST_CASE("what a smooth function may do between even places is no higher than what it does", "[numeric]")
{
    // sampled so that its minima lie anywhere between the places
    for (double const phase : {0.0, 0.13, 0.31, 0.5, 0.77}) {
        auto const wave = [&](double x) { return std::cos(0.9 * (x + phase)) + 0.1 * x; };
        std::vector<double> value;
        for (int i = 0; i < 12; ++i)
            value.push_back(wave(i));
        std::vector<numeric::BetweenPlaces> const between = numeric::between_places(value);
        REQUIRE(between.size() == 11);
        double least = value.back();
        for (std::size_t i = 0; i < between.size(); ++i) {
            for (int k = 0; k <= 50; ++k) {
                double const here = wave(static_cast<double>(i) + k / 50.0);
                CHECK(between[i].least <= here);
                least = std::min(least, here);
            }
            // and not much lower: the whole curvature doubled, at the most
            CHECK(between[i].least >= std::min(value[i], value[i + 1]) - 0.9 * 0.9 * 2 / 8);
        }
        CHECK(numeric::least_between(value) <= least);
    }
}

TEST_CASE("between places that lie on a line there is nothing lower and a parabola is met with twice its curvature",
          "[numeric]")
{
    std::vector<double> const line{3, 2.5, 2, 1.5, 1};
    for (numeric::BetweenPlaces const& each : numeric::between_places(line))
        CHECK(each.curvature == Approx(0).margin(1e-15));
    CHECK(numeric::least_between(line) == Approx(1));
    // (x - 1.5)^2 at 0 ... 3: second difference 2, doubled; in the middle interval the ends are level at 0.25, the
    // parabola 4/8 lower
    std::vector<double> const parabola{2.25, 0.25, 0.25, 2.25};
    std::vector<numeric::BetweenPlaces> const between = numeric::between_places(parabola);
    CHECK(between[1].curvature == Approx(4));
    CHECK(between[1].least == Approx(-0.25));
    // f(t) = 2.25 - 2 t - 2 t (1 - t): level at the lower end, |D| = c/2
    CHECK(between[0].least == Approx(0.25));
    // a V with its point anywhere between two places
    for (double const at : {1.05, 1.3, 1.5, 1.9}) {
        std::vector<double> pointed;
        for (int i = 0; i < 4; ++i)
            pointed.push_back(std::abs(i - at));
        CHECK(numeric::between_places(pointed, numeric::pointed_function)[1].least <= 1e-15);
        CHECK(numeric::between_places(pointed, numeric::pointed_function)[1].least > -0.6);
    }
    // one place and two places show no curvature
    CHECK(numeric::least_between({2.0}) == 2);
    CHECK(numeric::between_places({2.0}).empty());
    CHECK(numeric::least_between({2.0, 1.0}) == 1);
    CHECK(numeric::least_between({}) == std::numeric_limits<double>::infinity());
}

TEST_CASE("no sign change, no root, a zero at an end is the root", "[numeric]")
{
    CHECK_FALSE(numeric::bracketed_root([](double x) { return x * x + 1; }, -1, 1).found);
    numeric::BracketedRoot const end = numeric::bracketed_root([](double x) { return x; }, 0, 1);
    CHECK(end.found);
    CHECK(end.x == 0);
    CHECK_FALSE(numeric::bracketed_root([](double) { return std::nan(""); }, 0, 1).found);
}

TEST_CASE("Chebyshev coefficients of a cubic, its derivative and its spread", "[numeric]")
{
    // x^3 = (3 T1 + T3)/4
    numeric::ChebyshevVector const values = numeric::chebyshev_points().array().cube().matrix();
    numeric::ChebyshevVector const c = numeric::chebyshev_coefficients(values);
    CHECK(c[1] == Approx(0.75));
    CHECK(c[3] == Approx(0.25));
    CHECK(numeric::chebyshev_spread(c) == Approx(1.0));
    CHECK(numeric::chebyshev_tail(c) < 1e-15);
    // 3 x^2 = 1.5 + 1.5 T2
    numeric::ChebyshevVector const d = numeric::chebyshev_derivative(c);
    CHECK(d[0] == Approx(1.5));
    CHECK(d[2] == Approx(1.5));
}

TEST_CASE("Fourier series: mean, integral, and an honest no for a kink", "[numeric]")
{
    auto const f = [](double u) { return 1 / (1.25 + std::cos(2 * u)) + 0.1 * std::sin(4 * u); };
    numeric::FourierSeries const series(f, std::numbers::pi);
    REQUIRE(series.resolved());
    // mean of 1/(5/4 + cos x) over a period: 1/sqrt(25/16 - 1) = 4/3
    CHECK(series.mean() == Approx(4.0 / 3).epsilon(1e-15));
    // closed form of the integral from 0: (2/(3/4)) atan(tan(u)/3) / 2 ... for |u| < pi/2, and 0.1 (1 - cos 4u)/4
    for (double u : {0.2, 0.7, 1.3, -0.9}) {
        double const exact = std::atan(std::tan(u) / 3) * 4 / 3 + 0.1 * (1 - std::cos(4 * u)) / 4;
        CHECK(series.integral(u) == Approx(exact).epsilon(1e-14));
    }
    // Poisson's kernel: 4/3 (1 + 2 sum (-1/2)^k cos(2 k u))
    CHECK(series.cosine(0) == Approx(4.0 / 3).epsilon(1e-15));
    CHECK(series.cosine(1) == Approx(-4.0 / 3).epsilon(1e-15));
    CHECK(series.cosine(3) == Approx(-1.0 / 3).epsilon(1e-14));
    CHECK(series.sine(2) == Approx(0.1).epsilon(1e-14));
    CHECK(std::abs(series.sine(1)) <= series.noise());
    CHECK(series.noise() < 1e-13);
    CHECK(series.cosine(series.terms()) == 0);
    numeric::FourierSeries const kinked([](double u) { return 2 + std::abs(std::sin(u)); }, 2 * std::numbers::pi);
    CHECK_FALSE(kinked.resolved());
}

TEST_CASE("a parallel loop visits every slot once and throws the lowest exception", "[numeric][parallel]")
{
    for (int threads : {1, 2, 4}) {
        std::vector<std::atomic<int>> visits(1000);
        parallel_for(visits.size(), threads, 1, [&](std::size_t i) { ++visits[i]; });
        for (auto const& count : visits)
            REQUIRE(count == 1);
        auto const failing = [](std::size_t i) {
            if (i % 300 == 299)
                throw std::runtime_error(std::to_string(i));
        };
        CHECK_THROWS_WITH(parallel_for(1000, threads, 1, failing), "299");
    }
    parallel_for(0, 2, 1, [](std::size_t) { throw std::runtime_error("nothing to visit"); });
    CHECK(thread_count(3) == 3);
    CHECK(thread_count(0) >= 1);
}

TEST_CASE("a tolerance scales with its length", "[numeric]")
{
    Tolerance const small{1e-6, 25};
    Tolerance const large{1e-6, 25000};
    CHECK(large.roundoff() == Approx(1000 * small.roundoff()));
    CHECK(small.coincidence() > small.roundoff());
    CHECK(small.coincidence() < 1e-9);
}

TEST_CASE("segments cross inside both, at an end of one, or not", "[geometry]")
{
    Vec2 const a(0, 0), b(4, 0);
    auto const inside = crossing_of_segments(a, b, {1, -1}, {3, 1});
    REQUIRE(inside);
    CHECK((*inside - Vec2(2, 0)).norm() < 1e-15);
    auto const at_end = crossing_of_segments(a, b, {4, 0}, {4, 2});
    REQUIRE(at_end);
    CHECK(*at_end == b);
    CHECK_FALSE(crossing_of_segments(a, b, {5, -1}, {5, 1}));
    CHECK_FALSE(crossing_of_segments(a, b, {1, 1}, {1, 3}));
    CHECK_FALSE(crossing_of_segments(a, b, {1, 1}, {3, 1}));
    CHECK_FALSE(crossing_of_segments(a, b, {1, 0}, {3, 0}));
}

}  // namespace hdconj::test::small_parts_cases
