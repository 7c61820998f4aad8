// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic/discrete_balls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

#include "elastic/wave_generator_contact.hpp"
#include "hdconj/error.hpp"
#include "numeric/complementarity.hpp"
#include "support/catch.hpp"
#include "support/free_ring.hpp"

namespace hdconj::test::discrete_balls_cases {

using test::free_ring;
using test::inner_radius;

namespace {

using Eigen::Index;

using std::numbers::pi;
constexpr double amplitude = 0.25;
constexpr int angles = 24;  // of contacts in a sector
constexpr int terms = angles / 2 + 1;

elastic::Bearing ring(double oversize)
{
    return {9, 6, 0, oversize, elastic::BearingRing{}};
}

elastic::CamSeries cam(int sectors)
{
    std::vector<double> samples;
    for (int j = 0; j < angles; ++j)
        samples.push_back(amplitude * std::cos(2 * 2 * pi * j / (sectors * angles)));
    return elastic::cam_series(samples, sectors, true);
}

/// Cup and bearing of a sector, without mirror planes.
struct Drive
{
    int sectors;
    elastic::FourierSolid cup{elastic::section_mesh({}, elastic::contact_mesh_size({}, ring(0).width, 3))};
    std::vector<double> z{6, 9, 12};
    elastic::BearingSurface surface;
    elastic::BearingContacts contacts;
    std::vector<elastic::InfluencePoint> wall;
    numeric::Complementarity problem;

    Drive(int sectors_, double oversize)
        : sectors(sectors_), surface(elastic::bearing_surface(ring(oversize), inner_radius, cam(sectors_), z))
    {
        std::vector<elastic::Station> stations;
        for (double const at : z)
            stations.push_back(elastic::wall_station(cup.mesh(), at, 0, elastic::Direction::radial));
        for (int i = 0; i < angles; ++i)
            for (std::size_t j = 0; j < z.size(); ++j) {
                wall.push_back({j, 2 * pi * i / (sectors * angles)});
                contacts.phi.push_back(wall.back().phi);
                contacts.z.push_back(static_cast<Index>(j));
            }
        elastic::Repetition const repetition{sectors, false};
        problem.compliance =
            elastic::influence(cup, {}, stations, elastic::harmonics_of(sectors, sectors * (terms - 1)))
                .matrix(wall, repetition) +
            surface.compliance->matrix(wall, repetition);
        problem.approach.resize(static_cast<Index>(wall.size()));
        for (Index i = 0; i < problem.approach.size(); ++i) {
            double sum = 0;
            for (Index k = 0; k < surface.cosine.cols(); ++k)
                sum += surface.cosine(contacts.z[static_cast<std::size_t>(i)], k) *
                       std::cos(static_cast<double>(k) * sectors * wall[static_cast<std::size_t>(i)].phi);
            problem.approach[i] = sum;
        }
    }

    [[nodiscard]] elastic::BallContact on(elastic::DiscreteBalls const& single) const
    {
        numeric::Complementarity both = problem;
        both.compliance += single.between;
        both.approach -= single.sag;
        return elastic::solve_on_balls(both, 0, single.balls);
    }
    [[nodiscard]] elastic::BallContact on_line() const
    {
        numeric::Complementarity both = problem;
        return elastic::solve_on_balls(both, 0, elastic::ball_line(surface, sectors, contacts, angles, false));
    }
};

double largest_of(Eigen::VectorXd const& values)
{
    return values.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("single balls are forces on a free ring", "[balls]")
{
    constexpr int sectors = 2;
    for (int const count : {2, 6, 14, 22})
        for (std::optional<double> const stiffness : {std::optional<double>(), std::optional<double>(2e4)}) {
            CAPTURE(count, stiffness.has_value());
            Drive const drive(sectors, -0.004);
            std::vector<double> const phi = elastic::ball_angles(count, sectors, 0.1);
            REQUIRE(phi.size() == static_cast<std::size_t>(count / sectors));
            elastic::BallContact const found =
                drive.on(discrete_balls(drive.surface, sectors, drive.contacts, phi, stiffness));

            numeric::Complementarity both =
                free_ring(drive.cup, ring(0), inner_radius, elastic::mesh_size(inner_radius).along, drive.z, drive.wall,
                          phi, elastic::harmonics_of(sectors, sectors * (terms - 1)), {sectors, false});
            auto const rows = static_cast<Index>(drive.wall.size()), points = static_cast<Index>(phi.size());
            for (Index m = 0; m < points; ++m) {
                both.approach[rows + m] = amplitude * std::cos(2 * phi[static_cast<std::size_t>(m)]) - 0.004;
                both.compliance(rows + m, rows + m) += stiffness ? 1 / *stiffness : 0;
            }
            auto const expected = numeric::solve_complementarity(both);
            double const scale = expected.force.maxCoeff();
            CHECK(largest_of(found.contacts.force - expected.force.head(rows)) <= 1e-6 * scale);
            CHECK(largest_of(found.force - expected.force.tail(points)) <= 1e-6 * scale);
            if (!stiffness)
                CHECK(largest_of(found.gap - expected.gap.tail(points)) <= 1e-8);
            // a ring in balance: what the balls push it outward by is what pushes the cup, harmonic 0 of both
            CHECK(found.force.minCoeff() >= 0);
        }
}

TEST_CASE("many balls are a continuous row", "[balls]")
{
    constexpr int sectors = 2;
    Drive const drive(sectors, 0);
    elastic::BallContact const line = drive.on_line();
    double last = 0;
    std::vector<double> apart;
    for (int const count : {6, 12, angles}) {
        elastic::BallContact const single = drive.on(
            discrete_balls(drive.surface, sectors, drive.contacts, elastic::ball_angles(sectors * count, sectors, 0)));
        last = std::abs(single.contacts.force.sum() / line.contacts.force.sum() - 1);
        apart.push_back(last);
    }
    CAPTURE(apart[0], apart[1], apart[2]);
    CHECK(apart[1] < 0.5 * apart[0]);
    // as many as the harmonics tell apart: the same points, but for the one sine that vanishes at all of them
    CHECK(last < 1e-4);
}

TEST_CASE("balls of any number in a whole ring", "[balls]")
{
    // one sector: odd harmonics too, and a ring that may shift
    Drive const drive(1, -0.002);
    for (int const count : {5, 8, 23}) {
        CAPTURE(count);
        for (double const phase : {0.0, 0.2}) {
            elastic::BallContact const found =
                drive.on(discrete_balls(drive.surface, 1, drive.contacts, elastic::ball_angles(count, 1, phase)));
            CHECK(found.force.minCoeff() >= 0);
            CHECK(found.gap.minCoeff() >= 0);
            CHECK(found.contacts.residual <= numeric::contact_tolerance);
            for (Index m = 0; m < found.force.size(); ++m)
                CHECK(std::min(found.force[m], found.gap[m]) == 0);
            // the ring is in balance across its axis: forces of the balls against those of the cup
            double x = 0, y = 0, most = 0;
            for (Index m = 0; m < found.force.size(); ++m) {
                double const phi = phase + 2 * pi * static_cast<double>(m) / count;
                x += found.force[m] * std::cos(phi);
                y += found.force[m] * std::sin(phi);
                most = std::max(most, found.force[m]);
            }
            for (Index i = 0; i < found.contacts.force.size(); ++i) {
                x -= found.contacts.force[i] * std::cos(drive.wall[static_cast<std::size_t>(i)].phi);
                y -= found.contacts.force[i] * std::sin(drive.wall[static_cast<std::size_t>(i)].phi);
            }
            CHECK(std::hypot(x, y) <= 1e-6 * most);
        }
    }
    // of three balls the cam reaches one only, and the ring may move across it
    CHECK_THROWS_WITH(drive.on(discrete_balls(drive.surface, 1, drive.contacts, elastic::ball_angles(3, 1, 0))),
                      ContainsSubstring("too few balls"));
}

TEST_CASE("a ring that its balls do not hold is refused", "[balls]")
{
    Drive const whole(1, 0);
    CHECK_THROWS_WITH(discrete_balls(whole.surface, 1, whole.contacts, {0.3}), ContainsSubstring("move as a whole"));
    CHECK_THROWS_WITH(discrete_balls(whole.surface, 1, whole.contacts, {0.3, 0.3 + pi}),
                      ContainsSubstring("move as a whole"));
    CHECK_NOTHROW(discrete_balls(whole.surface, 1, whole.contacts, {0.3, 1.3}));
    CHECK_THROWS_WITH(discrete_balls(whole.surface, 1, whole.contacts, elastic::ball_angles(2 * angles, 1, 0)),
                      ContainsSubstring("more than the harmonics"));
    CHECK_THROWS_AS(discrete_balls(whole.surface, 1, whole.contacts, {}), NumericalError);
    CHECK_THROWS_AS(discrete_balls({}, 1, whole.contacts, {0.0, 1.0, 2.0}), NumericalError);
    CHECK_THROWS_WITH(discrete_balls(whole.surface, 1, whole.contacts, {0.0, 1.0, 1.0 + 1e-14, 2.0}),
                      ContainsSubstring("too close"));
}

TEST_CASE("the iterations of releasing balls end, with the answer of the one way to say it", "[balls]")
{
    // random rings of a few balls under random forces: all sets of touching balls by enumeration. A ring without a
    // wall: force and gap of the balls alone.
    std::mt19937 random(20261122);
    std::normal_distribution<double> normal;
    constexpr Index balls = 6, rows = 4;
    int loose = 0, most = 0;
    for (int run = 0; run < 2000; ++run) {
        auto const matrix = [&](Index n, Index m) {
            return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(n, m, [&] { return normal(random); }));
        };
        Eigen::MatrixXd const a = matrix(rows + 1, rows), b = matrix(balls, balls);
        elastic::BallLine line;
        line.phi.assign(balls, 0);
        line.stiffness = b * b.transpose() + 0.01 * Eigen::MatrixXd::Identity(balls, balls);
        line.held = matrix(balls, 1);
        line.lift = matrix(rows, balls);
        numeric::Complementarity held{
            a.transpose() * a + 0.01 * Eigen::MatrixXd::Identity(rows, rows), matrix(rows, 1), {}, 0};
        numeric::Complementarity problem = held;
        elastic::BallContact const found = elastic::solve_on_balls(problem, 0, line);
        most = std::max(most, found.rounds);
        loose += found.gap.maxCoeff() > 0;
        Eigen::VectorXd const force =
            line.held + line.stiffness * found.gap + line.lift.transpose() * found.contacts.force;
        Eigen::VectorXd const gap = held.compliance * found.contacts.force - held.approach - line.lift * found.gap;
        double const scale = 1 + force.cwiseAbs().maxCoeff() + gap.cwiseAbs().maxCoeff();
        CHECK(largest_of(force.cwiseMin(found.gap)) <= 1e-8 * scale);
        CHECK(largest_of(gap.cwiseMin(found.contacts.force)) <= 1e-8 * scale);
        // whatever is released to begin with
        std::vector<double> start;
        for (Index m = 0; m < balls; ++m)
            start.push_back(std::max(0.0, normal(random)));
        numeric::Complementarity again = held;
        elastic::BallContact const other = solve_on_balls(again, 0, line, {}, start);
        CHECK(largest_of(other.force - found.force) <= 1e-7 * scale);
        CHECK(largest_of(other.gap - found.gap) <= 1e-7 * (1 + found.gap.cwiseAbs().maxCoeff()));
    }
    CHECK(loose > 1500);
    CHECK(most < 50);
}

}  // namespace hdconj::test::discrete_balls_cases
