// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic/ball_contact.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "elastic/ball_line.hpp"
#include "support/catch.hpp"

namespace hdconj::test::ball_contact_cases {

namespace {

using Eigen::Index;
using std::numbers::pi;

constexpr elastic::Elasticity steel{206e3, 0.3}, ceramic{310e3, 0.26};

/// E/(1 - nu^2) of both bodies in series.
double modulus(elastic::Elasticity const& a, elastic::Elasticity const& b)
{
    auto const of = [](elastic::Elasticity const& body) {
        return (1 - body.poissons_ratio * body.poissons_ratio) / body.youngs_modulus;
    };
    return 1 / (of(a) + of(b));
}

/// k of two steel bodies by the formulas of Hamrock and Brewe (J. Lubr. Technol. 105, 1983), which fit the integrals.
double by_fit(double along, double across)
{
    double const ratio = along / across, radius = 1 / (along + across);
    double const q = pi / 2 - 1, axes = std::pow(ratio, 2 / pi), second = 1 + q / ratio,
                 first = pi / 2 + q * std::log(ratio);
    return pi * axes * 2 * modulus(steel, steel) * std::sqrt(radius * second / (4.5 * first * first * first));
}

double approach(double force, double constant)
{
    return std::pow(force / constant, 2.0 / 3);
}

}  // namespace

TEST_CASE("a point contact is that of Hertz", "[balls]")
{
    // a sphere on a plane
    CHECK(elastic::point_constant({steel, ceramic, 1 / 1.5, 1 / 1.5}) ==
          Approx(4.0 / 3 * modulus(steel, ceramic) * std::sqrt(1.5)).epsilon(1e-14));
    // Harris, Rolling Bearing Analysis, table 6.1: difference over sum of the curvatures, and the approach over that of
    // a sphere with the same sum
    constexpr double digits = 4e-4;
    for (auto const& [difference, relative] :
         {std::pair(0.1075, 0.9974), std::pair(0.3204, 0.9761), std::pair(0.4795, 0.9429), std::pair(0.5916, 0.9077),
          std::pair(0.6716, 0.8733), std::pair(0.7332, 0.8394), std::pair(0.7948, 0.7961), std::pair(0.83495, 0.7602),
          std::pair(0.87366, 0.7169), std::pair(0.90999, 0.6636), std::pair(0.93657, 0.6112),
          std::pair(0.95738, 0.5551), std::pair(0.97290, 0.4960)}) {
        CAPTURE(difference);
        double const sphere = elastic::point_constant({steel, steel, 1, 1});
        double const k = elastic::point_constant({steel, steel, 1 + difference, 1 - difference});
        CHECK(std::pow(sphere / k, 2.0 / 3) == Approx(relative).margin(digits));
    }
    // a fit, good to some per cent
    for (double const ratio : {1.0, 2.0, 5.0, 10.0, 25.0, 60.0})
        CHECK(elastic::point_constant({steel, steel, 1, 1 / ratio}) == Approx(by_fit(1, 1 / ratio)).epsilon(0.05));
    // no jump where the integrals hand over to the circle
    CHECK(elastic::point_constant({steel, steel, 1 + 1.01e-6, 1 - 1.01e-6}) ==
          Approx(elastic::point_constant({steel, steel, 1, 1})).epsilon(1e-9));
}

TEST_CASE("a ball in its grooves yields at both", "[balls]")
{
    elastic::GroovedBall ball{3, 22.797, 0.52, 0.52, steel, steel};
    double const k = elastic::ball_constant(ball), force = 300;
    double const inner = by_fit(2 / 3.0 + 1 / 19.797, 2 / 3.0 - 1 / 1.56),
                 outer = by_fit(2 / 3.0 - 1 / 22.797, 2 / 3.0 - 1 / 1.56);
    CHECK(approach(force, k) == Approx(approach(force, inner) + approach(force, outer)).epsilon(0.05));
    ball.inner_conformity = ball.outer_conformity = 0.515;  // a closer fit is stiffer
    CHECK(elastic::ball_constant(ball) > k);
    ball.ball = ceramic;
    CHECK(elastic::ball_constant(ball) > k);
}

TEST_CASE("a ball between two plates yields as force to two thirds", "[balls]")
{
    elastic::BallLine line;
    line.phi = {0};
    line.held = Eigen::VectorXd::Zero(1);
    line.stiffness = Eigen::MatrixXd::Zero(1, 1);
    line.lift = Eigen::MatrixXd::Ones(1, 1);
    line.hertz = 1.2e5;
    for (double const way : {1e-5, 1e-3, 1e-2}) {
        constexpr double stiff = 1e-12;  // compliance of the plates [mm/N]
        numeric::Complementarity plates{
            Eigen::MatrixXd::Constant(1, 1, stiff), Eigen::VectorXd::Constant(1, way), {}, 0};
        elastic::BallContact const found = elastic::solve_on_balls(plates, 0, line, {}, {1.0});
        CHECK(found.force[0] == Approx(*line.hertz * std::pow(way, 1.5)).epsilon(1e-6));
        CHECK(found.contacts.force[0] == Approx(found.force[0]).epsilon(1e-6));
    }
}

TEST_CASE("balls by Hertz meet their law, touch or push in every ring", "[balls]")
{
    std::mt19937 random(20261125);
    std::normal_distribution<double> normal;
    constexpr Index balls = 6, rows = 4;
    int loose = 0, most = 0;
    for (int run = 0; run < 1000; ++run) {
        auto const matrix = [&](Index n, Index m) {
            return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(n, m, [&] { return normal(random); }));
        };
        Eigen::MatrixXd const a = matrix(rows + 1, rows), b = matrix(balls, balls);
        elastic::BallLine line;
        line.phi.assign(balls, 0);
        line.stiffness = b * b.transpose() + 0.01 * Eigen::MatrixXd::Identity(balls, balls);
        line.held = matrix(balls, 1);
        line.lift = matrix(rows, balls);
        numeric::Complementarity const held{
            a.transpose() * a + 0.01 * Eigen::MatrixXd::Identity(rows, rows), matrix(rows, 1), {}, 0};
        numeric::Complementarity problem = held;
        elastic::BallContact const rigid = elastic::solve_on_balls(problem, 0, line);
        line.hertz = std::exp(2 * normal(random));
        problem = held;
        elastic::BallContact const found = elastic::solve_on_balls(problem, 0, line);
        most = std::max(most, found.rounds);
        loose += found.gap.maxCoeff() > 0;
        Eigen::VectorXd way = found.gap;
        for (Index m = 0; m < balls; ++m)
            way[m] -= approach(found.force[m], *line.hertz);
        Eigen::VectorXd const force = line.held + line.stiffness * way + line.lift.transpose() * found.contacts.force;
        Eigen::VectorXd const gap = held.compliance * found.contacts.force - held.approach - line.lift * way;
        double const scale = 1 + force.cwiseAbs().maxCoeff() + way.cwiseAbs().maxCoeff();
        CHECK((force - found.force).cwiseAbs().maxCoeff() <= 2e-5 * scale);
        CHECK(found.force.cwiseMin(found.gap).cwiseAbs().maxCoeff() <= 1e-8 * scale);
        CHECK(gap.cwiseMin(found.contacts.force).cwiseAbs().maxCoeff() <= 2e-5 * scale);
        // balls as hard as one likes are rigid
        line.hertz = 1e30;
        problem = held;
        elastic::BallContact const hard = elastic::solve_on_balls(problem, 0, line);
        CHECK((hard.force - rigid.force).cwiseAbs().maxCoeff() <= 1e-7 * (1 + rigid.force.maxCoeff()));
        CHECK((hard.gap - rigid.gap).cwiseAbs().maxCoeff() <= 1e-7 * (1 + rigid.gap.maxCoeff()));
    }
    CAPTURE(most);
    CHECK(loose > 500);
    CHECK(most < 200);
}

}  // namespace hdconj::test::ball_contact_cases
