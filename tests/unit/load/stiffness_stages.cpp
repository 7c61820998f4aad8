// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "hdconj/load.hpp"
#include "support/catch.hpp"

namespace hdconj::test::stiffness_stages_cases {

namespace {

struct Points
{
    std::vector<double> twist, torque;
};

struct Law
{
    double first = 3e6, second = 9e6, knee = 12e3, start = 1e-3;

    [[nodiscard]] double torque(double twist) const
    {
        double const bend = start + knee / first;
        return twist <= bend ? first * (twist - start) : knee + second * (twist - bend);
    }
    [[nodiscard]] double twist_at(double torque) const
    {
        return torque <= knee ? start + torque / first : start + knee / first + (torque - knee) / second;
    }
};

Points points_of(Law const& law, int count, double largest, double noise = 0, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> error;
    Points points;
    for (int i = 0; i < count; ++i) {
        double const twist = law.start + (law.twist_at(largest) - law.start) * i / (count - 1);
        points.twist.push_back(twist);
        points.torque.push_back(law.torque(twist) + noise * error(random));
    }
    return points;
}

StiffnessStages stages_of(Points const& points)
{
    return stiffness_stages(points.twist, points.torque);
}

/// Sum of squares of the best two lines that meet at @p knee, by the normal equations of torque = a + b min(x - knee,
/// 0) + c max(x - knee, 0).
double squares_at(Points const& points, double knee)
{
    double m[3][4] = {};
    auto const row = [&](std::size_t i, double out[4]) {
        double const x = points.twist[i] - knee;
        out[0] = 1;
        out[1] = std::min(x, 0.0) * 1e3;
        out[2] = std::max(x, 0.0) * 1e3;
        out[3] = points.torque[i] / 1e4;
    };
    double r[4];
    for (std::size_t i = 0; i < points.twist.size(); ++i) {
        row(i, r);
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 4; ++b)
                m[a][b] += r[a] * r[b];
        }
    }
    for (int a = 0; a < 3; ++a) {
        for (int b = a + 1; b < 3; ++b) {
            double const f = m[b][a] / m[a][a];
            for (int c = a; c < 4; ++c)
                m[b][c] -= f * m[a][c];
        }
    }
    double x[3];
    for (int a = 2; a >= 0; --a) {
        x[a] = m[a][3];
        for (int b = a + 1; b < 3; ++b)
            x[a] -= m[a][b] * x[b];
        x[a] /= m[a][a];
    }
    double squares = 0;
    for (std::size_t i = 0; i < points.twist.size(); ++i) {
        row(i, r);
        squares += std::pow(r[3] - x[0] * r[0] - x[1] * r[1] - x[2] * r[2], 2);
    }
    return squares * 1e8;
}

}  // namespace

TEST_CASE("two exact lines are found to rounding, stiffening and softening", "[load][stages]")
{
    for (auto const& [first, second] : {std::pair(3e6, 9e6), std::pair(9e6, 3e6), std::pair(5e6, 5.01e6)}) {
        for (int const count : {6, 7, 14, 200}) {
            // The bend lies with enough points on either side of it, between points and on one.
            Law const law{first, second, 14e3, 1e-3};
            auto const points = points_of(law, count, 28e3);
            auto const found = stages_of(points);
            INFO(first << " " << second << " " << count);
            if (law.torque(points.twist[2]) > law.knee ||
                law.torque(points.twist[points.twist.size() - 3]) < law.knee) {
                continue;
            }
            REQUIRE(found.found);
            CHECK(found.first == Approx(first).epsilon(1e-9));
            CHECK(found.second == Approx(second).epsilon(1e-9));
            CHECK(found.knee == Approx(14e3).epsilon(1e-6));
            CHECK(found.knee_twist == Approx(1e-3 + 14e3 / first).epsilon(1e-6));
            CHECK(found.rms < 1e-6);
            CHECK(found.first_error < 1e-6 * first);
        }
    }
}

TEST_CASE("a negative branch has the stages of its mirror image and the units scale", "[load][stages]")
{
    auto points = points_of({}, 41, 28e3, 100);
    auto const right = stages_of(points);
    REQUIRE(right.found);
    Points left = points, scaled = points;
    for (std::size_t i = 0; i < points.twist.size(); ++i) {
        left.twist[i] = -points.twist[i];
        left.torque[i] = -points.torque[i];
        scaled.twist[i] = points.twist[i] * 8 + 5;
        scaled.torque[i] = points.torque[i] / 1024;
    }
    auto const mirrored = stages_of(left);
    CHECK(mirrored.first == right.first);
    CHECK(mirrored.second == right.second);
    CHECK(mirrored.knee == -right.knee);
    CHECK(mirrored.knee_twist == -right.knee_twist);
    auto const other = stages_of(scaled);
    CHECK(other.first == Approx(right.first / 8192).epsilon(1e-9));
    CHECK(other.second_error == Approx(right.second_error / 8192).epsilon(1e-6));
    CHECK(other.knee_error == Approx(right.knee_error / 1024).epsilon(1e-6));
}

TEST_CASE("no bend anywhere leaves a smaller sum of squares", "[load][stages]")
{
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Law const law{3e6, 5e6, 4e3 + 500.0 * seed, 1e-3};
        auto const points = points_of(law, 12 + static_cast<int>(seed), 28e3, 600, seed);
        auto const found = stages_of(points);
        if (!found.found)
            continue;
        double const own = found.rms * found.rms * static_cast<double>(points.twist.size());
        std::size_t const last = points.twist.size() - 1;
        for (int i = 0; i <= 2000; ++i) {
            // With at least three points on either side.
            double const knee = points.twist[2] + (points.twist[last - 2] - points.twist[2]) * i / 2000;
            REQUIRE(own <= squares_at(points, knee) * (1 + 1e-9));
        }
        CHECK(own == Approx(squares_at(points, found.knee_twist)).epsilon(1e-6));
    }
}

TEST_CASE("standard errors are the scatter of many repetitions", "[load][stages]")
{
    Law const law{3e6, 9e6, 12e3, 1e-3};
    constexpr int repetitions = 600;
    double first = 0, second = 0, knee = 0, first_scatter = 0, second_scatter = 0, knee_scatter = 0, first_error = 0,
           second_error = 0, knee_error = 0;
    for (unsigned seed = 1; seed <= repetitions; ++seed) {
        auto const found = stages_of(points_of(law, 60, 28e3, 300, seed));
        REQUIRE(found.found);
        first += (found.first - law.first) / repetitions;
        second += (found.second - law.second) / repetitions;
        knee += (found.knee - law.knee) / repetitions;
        first_scatter += std::pow(found.first - law.first, 2) / repetitions;
        second_scatter += std::pow(found.second - law.second, 2) / repetitions;
        knee_scatter += std::pow(found.knee - law.knee, 2) / repetitions;
        first_error += std::pow(found.first_error, 2) / repetitions;
        second_error += std::pow(found.second_error, 2) / repetitions;
        knee_error += std::pow(found.knee_error, 2) / repetitions;
    }
    // The mean is off by no more than four of its own standard errors; the scatter is the stated one to a tenth.
    CHECK(std::abs(first) < 4 * std::sqrt(first_scatter / repetitions));
    CHECK(std::abs(second) < 4 * std::sqrt(second_scatter / repetitions));
    CHECK(std::abs(knee) < 4 * std::sqrt(knee_scatter / repetitions));
    CHECK(std::sqrt(first_error / first_scatter) == Approx(1).epsilon(0.12));
    CHECK(std::sqrt(second_error / second_scatter) == Approx(1).epsilon(0.12));
    CHECK(std::sqrt(knee_error / knee_scatter) == Approx(1).epsilon(0.12));
}

TEST_CASE("a straight line has no bend with noise or without", "[load][stages]")
{
    Law const straight{5e6, 5e6, 14e3, 1e-3};
    auto const exact = stages_of(points_of(straight, 40, 28e3));
    CHECK_FALSE(exact.found);
    CHECK(exact.first == Approx(5e6).epsilon(1e-12));
    CHECK(exact.second == exact.first);
    CHECK(exact.knee == 0);
    CHECK(exact.knee_twist == Approx(1e-3).epsilon(1e-9));
    for (int const count : {6, 10, 40}) {
        int bent = 0;
        constexpr int tries = 1000;
        for (unsigned seed = 1; seed <= tries; ++seed)
            bent += stages_of(points_of(straight, count, 28e3, 400, seed)).found ? 1 : 0;
        INFO(count);
        CHECK(bent <= tries / 50);  // stated: one in a hundred at most
    }
    // The same noise hides no bend that is there.
    CHECK(stages_of(points_of({}, 40, 28e3, 400)).found);
}

TEST_CASE("few points or one twist make no stages", "[load][stages]")
{
    auto const five = stages_of(points_of({}, 5, 28e3));
    CHECK_FALSE(five.found);
    CHECK(five.first > 3e6);
    CHECK(five.first < 9e6);
    CHECK(five.first == five.second);
    for (auto const& none : {stiffness_stages({}, {}), stiffness_stages({1e-3}, {5}),
                             stiffness_stages(std::vector<double>(9, 1e-3), std::vector<double>(9, 7.0))}) {
        CHECK_FALSE(none.found);
        CHECK(none.first == 0);
        CHECK(none.rms == 0);
    }
    auto const two = stiffness_stages({1, 2}, {10, 30});
    CHECK(two.first == Approx(20));
    CHECK(two.first_error == 0);
    CHECK_THROWS_AS(stiffness_stages({1, 2}, {1}), std::logic_error);
    // Several torques at one twist, as a coarse encoder reads them.
    auto const coarse = stiffness_stages({0, 0, 0, 0, 1, 1, 2, 3}, {0, 1, 2, 3, 5, 6, 10, 15});
    CHECK(std::isfinite(coarse.first));
    CHECK(std::isfinite(coarse.second));
}

}  // namespace hdconj::test::stiffness_stages_cases
