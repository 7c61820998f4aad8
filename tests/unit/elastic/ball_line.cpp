// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic/ball_line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "elastic/wave_generator_contact.hpp"
#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/free_ring.hpp"

namespace hdconj::test::ball_line_cases {

using test::free_ring;
using test::inner_radius;

namespace {

using Eigen::Index;

using std::numbers::pi;
constexpr int across = 7;

elastic::Bearing bearing_with_ring(double oversize, double thickness = 1.2)
{
    elastic::Bearing bearing{9, 6, 0, oversize, elastic::BearingRing{}};
    bearing.ring->thickness = thickness;
    return bearing;
}

elastic::CamSeries cosine_series(int angles, bool even = true, double turned = 0, int waves = 2)
{
    std::vector<double> samples;
    for (int j = 0; j < angles; ++j)
        samples.push_back(0.25 * std::cos(2 * pi * j / angles - waves * turned));
    return elastic::cam_series(samples, waves, even);
}

elastic::WaveGeneratorContact solved_on_wall(elastic::Bearing const& bearing, elastic::CamSeries const& cam)
{
    elastic::FourierSolid const cup(elastic::section_mesh({}, elastic::contact_mesh_size({}, bearing.width, across)));
    return elastic::solve_wave_generator(cup, inner_radius, bearing, cam, across,
                                         {elastic::wall_station(cup.mesh(), 9, 0, elastic::Direction::radial)});
}

double least(std::vector<double> const& values)
{
    return *std::min_element(values.begin(), values.end());
}

double largest(std::vector<double> const& values)
{
    return *std::max_element(values.begin(), values.end());
}

}  // namespace

TEST_CASE("balls press on the ring or leave a gap", "[balls]")
{
    for (double const oversize : {0.01, 0.0, -0.01, -0.03, -0.1}) {
        CAPTURE(oversize);
        auto const contact = solved_on_wall(bearing_with_ring(oversize), cosine_series(32));
        REQUIRE(contact.ball_force.size() == contact.ball_phi.size());
        CHECK(least(contact.ball_force) >= 0);
        CHECK(least(contact.ball_gap) >= 0);
        CHECK(contact.residual <= numeric::contact_tolerance);
        for (std::size_t m = 0; m < contact.ball_force.size(); ++m)
            CHECK(std::min(contact.ball_force[m], contact.ball_gap[m]) == 0);
        CHECK((largest(contact.ball_gap) > 0) == (oversize < 0));
    }
}

TEST_CASE("a loose ring is that of balls as contacts of a free ring", "[balls]")
{
    constexpr int angles = 24;
    for (double const oversize : {0.005, -0.02, -0.08}) {
        CAPTURE(oversize);
        elastic::Bearing const bearing = bearing_with_ring(oversize);
        auto const contact = solved_on_wall(bearing, cosine_series(angles));
        double const apart = bearing.width / (across - 1);
        elastic::FourierSolid const cup(
            elastic::section_mesh({}, elastic::contact_mesh_size({}, bearing.width, across)));
        std::vector<elastic::InfluencePoint> wall;
        for (double const phi : contact.phi)
            for (std::size_t j = 0; j < contact.z.size(); ++j)
                wall.push_back({j, phi});
        numeric::Complementarity both =
            free_ring(cup, bearing, inner_radius, std::min(elastic::mesh_size(inner_radius).along, 1.5 * apart),
                      contact.z, wall, contact.phi, elastic::harmonics_of(2, angles), {2, true});
        auto const rows = static_cast<Index>(wall.size()), points = static_cast<Index>(contact.phi.size());
        for (Index m = 0; m < points; ++m)
            both.approach[rows + m] = 0.25 * std::cos(2 * contact.phi[static_cast<std::size_t>(m)]) + oversize;
        auto const expected = numeric::solve_complementarity(both);
        double const scale = expected.force.maxCoeff();
        // 4 quarters
        CHECK(contact.total_force == Approx(4 * expected.force.head(rows).sum()).epsilon(1e-7));
        for (Index m = 0; m < points; ++m) {
            double const twice = m == 0 || m == points - 1 ? 2 : 1;
            CHECK(contact.ball_force[static_cast<std::size_t>(m)] ==
                  Approx(twice * expected.force[rows + m]).margin(1e-7 * scale));
            CHECK(contact.ball_gap[static_cast<std::size_t>(m)] == Approx(expected.gap[rows + m]).margin(1e-9));
        }
    }
}

TEST_CASE("a turned loose bearing turns the answer", "[balls]")
{
    double const turn = 3 * pi / 24;
    auto const straight = solved_on_wall(bearing_with_ring(-0.02), cosine_series(24));
    auto const turned = solved_on_wall(bearing_with_ring(-0.02), cosine_series(24, false, turn));
    CHECK(largest(straight.ball_gap) > 0);
    CHECK(turned.total_force == Approx(straight.total_force).epsilon(1e-8));
    for (std::size_t m = 0; m < straight.ball_gap.size(); ++m) {
        CHECK(turned.ball_gap[m + 3] == Approx(straight.ball_gap[m]).margin(1e-9));
        CHECK(turned.ball_force[m + 3] == Approx(straight.ball_force[m]).margin(1e-7 * largest(straight.ball_force)));
    }
    for (double const phi : {0.0, 0.3, 1.0, 2.0})
        CHECK(turned.displacement.at(0, phi + turn) == Approx(straight.displacement.at(0, phi)).margin(1e-9));
}

TEST_CASE("balls and springs of any looseness: a result, or a ring that nothing holds", "[balls]")
{
    SECTION("so loose that no ball reaches the ring, in step with looseness")
    {
        double last = 1e9;
        for (double const oversize : {0.02, 0.0, -0.02, -0.05, -0.15, -0.3}) {
            auto const contact = solved_on_wall(bearing_with_ring(oversize), cosine_series(24));
            CHECK(contact.total_force <= last);
            last = contact.total_force;
        }
        constexpr double rounding = 1e-6;  // [N]: the cup lies on the ring with no force
        CHECK(last < rounding);
        auto const none = solved_on_wall(bearing_with_ring(-0.3), cosine_series(24));
        CHECK(largest(none.ball_force) == 0);
        CHECK(least(none.ball_gap) == Approx(0.05).epsilon(1e-9));
    }
    SECTION("fits, stiffnesses and rings")
    {
        int loose = 0;
        for (double const thickness : {0.3, 1.2, 3.0})
            for (double const fit : {-0.02, 0.0, 0.03})
                for (double const stiffness : {100.0, 3000.0, 1e9}) {
                    elastic::Bearing bearing = bearing_with_ring(-0.01, thickness);
                    bearing.fit = fit;
                    bearing.ring->radial_stiffness = stiffness;
                    auto const contact = solved_on_wall(bearing, cosine_series(16));
                    CAPTURE(thickness, fit, stiffness);
                    CHECK(least(contact.ball_force) >= 0);
                    CHECK(contact.residual <= numeric::contact_tolerance);
                    loose += largest(contact.ball_gap) > 0;
                }
        CHECK(loose > 9);
    }
    SECTION("one lobe: the ring may shift as a whole and the cup holds it, unless it is loose all round")
    {
        auto const held = solved_on_wall(bearing_with_ring(-0.02), cosine_series(24, true, 0, 1));
        CHECK(least(held.ball_force) >= 0);
        CHECK(held.total_force > 0);
        CHECK_THROWS_WITH(solved_on_wall(bearing_with_ring(-0.5), cosine_series(24, true, 0, 1)),
                          ContainsSubstring("too loose"));
    }
}

TEST_CASE("points that the ring's harmonics cannot tell apart are refused", "[balls]")
{
    auto const cam = cosine_series(16);
    elastic::BearingSurface const surface =
        elastic::bearing_surface(bearing_with_ring(0), inner_radius, cam, {6, 9, 12});
    elastic::BearingContacts const contacts{{0.0, 0.1}, {0, 2}, 0};
    CHECK(ball_line(surface, 2, contacts, 16, false).phi.size() == 16);
    CHECK(ball_line(surface, 2, contacts, 16, true).phi.size() == 9);
    CHECK_THROWS_AS(ball_line(surface, 2, contacts, 18, false), NumericalError);
    CHECK_THROWS_AS(ball_line(surface, 2, contacts, 15, false), NumericalError);
    CHECK_THROWS_AS(ball_line({}, 2, contacts, 16, false), NumericalError);
    elastic::BallLine const line = elastic::ball_line(surface, 2, contacts, 16, false);
    CHECK((line.stiffness - line.stiffness.transpose()).norm() == 0);
}

TEST_CASE("a cam that is shifted moves the ring on its balls as a whole and bends nothing", "[balls]")
{
    constexpr double turned = 0.3, shift = 0.25;
    auto const cam = cosine_series(16, false, turned, 1);
    for (std::optional<double> const stiffness : {std::optional<double>(), std::optional<double>(2000)}) {
        elastic::Bearing bearing = bearing_with_ring(0);
        bearing.ring->radial_stiffness = stiffness;
        elastic::BearingSurface const surface = elastic::bearing_surface(bearing, inner_radius, cam, {6, 9, 12});
        for (Index z = 0; z < 3; ++z) {
            CHECK(surface.cosine(z, 1) == Approx(shift * std::cos(turned)).epsilon(1e-8));
            CHECK(surface.sine(z, 1) == Approx(shift * std::sin(turned)).epsilon(1e-8));
        }
        CHECK(std::abs(surface.reaction_to_lift[1]) < 1e-6 * surface.reaction_to_lift[2]);
    }
}

}  // namespace hdconj::test::ball_line_cases
