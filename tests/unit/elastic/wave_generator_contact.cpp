// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic/wave_generator_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"
#include "support/catch.hpp"
#include "support/free_ring.hpp"

namespace hdconj::test::wave_generator_contact_cases {

using test::inner_radius;

namespace {

using std::numbers::pi;
constexpr int band = 33;  // stations from z = 5 to 13

elastic::Bearing rigid(double fit = 0)
{
    return {9, 6, fit, 0, std::nullopt};
}

elastic::Bearing elastic(double thickness, double width = 6)
{
    elastic::Bearing bearing{9, width, 0, 0, elastic::BearingRing{}};
    bearing.ring->thickness = thickness;
    return bearing;
}

std::vector<double> cosine_cam(int angles, double shifted = 0)
{
    std::vector<double> samples;
    for (int j = 0; j < angles; ++j)
        samples.push_back(0.25 * std::cos(2 * pi * j / angles - 2 * shifted));
    return samples;
}

elastic::WaveGeneratorContact solved(elastic::Bearing const& bearing, elastic::CamSeries const& cam, int across = 13,
                                     int threads = 1)
{
    elastic::FourierSolid const cup(elastic::section_mesh({}, elastic::contact_mesh_size({}, bearing.width, across)));
    std::vector<elastic::Station> stations;
    for (int i = 0; i < band; ++i)
        stations.push_back(wall_station(cup.mesh(), 5 + 0.25 * i, 0, elastic::Direction::radial));
    for (elastic::Direction const direction : {elastic::Direction::axial, elastic::Direction::tangential})
        stations.push_back(wall_station(cup.mesh(), 9, 0.5, direction));
    return solve_wave_generator(cup, inner_radius, bearing, cam, across, stations, threads);
}

elastic::WaveGeneratorContact quickly_solved(elastic::Bearing const& bearing)
{
    return solved(bearing, elastic::cam_series(cosine_cam(24), 2, true), 7);
}

elastic::WaveGeneratorContact solved(elastic::Bearing const& bearing)
{
    return solved(bearing, elastic::cam_series(cosine_cam(48), 2, true));
}

/// Slope of the best line through u_r over the tooth ring [deg].
double wall_coning_deg(elastic::WaveGeneratorContact const& contact, double phi_deg)
{
    double top = 0, bottom = 0;
    for (int i = 0; i < band; ++i) {
        double const z = 0.25 * (i - 16);
        top += z * contact.displacement.at(static_cast<std::size_t>(i), phi_deg * pi / 180);
        bottom += z * z;
    }
    return std::atan(top / bottom) * 180 / pi;
}

}  // namespace

TEST_CASE("coning and force on the wave generator are those of the validated table", "[bearing]")
{
    struct Row
    {
        elastic::Bearing bearing;
        double at_0, at_30, at_90;  // deg
        double force;               // N
    };
    auto preloaded = [](double by) {
        elastic::Bearing bearing = elastic(1.2);
        bearing.cam_oversize = by;
        return bearing;
    };
    std::vector<Row> const table{
        {rigid(), 0.939, 0.087, -1.050, 9133},        {rigid(0.0026), 0.884, 0.073, -1.027, 9596},
        {rigid(0.01), 0.720, 0.043, -0.960, 10949},   {rigid(0.02), 0.483, 0.027, -0.866, 12865},
        {elastic(0.8), 1.352, 0.604, -1.334, 3070},   {elastic(1.2), 1.244, 0.522, -1.293, 3992},
        {elastic(1.6), 1.184, 0.454, -1.261, 4840},   {elastic(1.2, 5), 1.369, 0.586, -1.374, 3380},
        {preloaded(0.01), 1.194, 0.541, -1.267, 5242}};
    for (Row const& row : table) {
        CAPTURE(row.at_0, row.force);
        auto const contact = solved(row.bearing, elastic::cam_series(cosine_cam(32), 2, true));
        CHECK(wall_coning_deg(contact, 0) == Approx(row.at_0).epsilon(0.01));
        CHECK(wall_coning_deg(contact, 30) ==
              Approx(row.at_30).epsilon(0.01).margin(
                  0.005));  // 32 angles: one in 5.6 degrees, where the slope of 0.5 degrees in 10 changes sign
        CHECK(wall_coning_deg(contact, 90) == Approx(row.at_90).epsilon(0.01));
        CHECK(contact.total_force == Approx(row.force).epsilon(0.005));
        CHECK(contact.residual <= numeric::contact_tolerance);
    }
}

TEST_CASE("the cup touches the bearing's edges, and the ring leaves balls that are too loose", "[bearing]")
{
    auto const contact = solved(elastic(1.2));
    // 48 angles, 13 circles: rear edge at the major axis, front edge at the minor one
    CHECK(contact.force(0, 0) > 0);
    CHECK(contact.force.row(0).tail(6).maxCoeff() == 0);
    Eigen::Index const minor = contact.force.rows() - 1;
    CHECK(contact.force(minor, 12) > 0);
    CHECK(contact.force.row(minor).head(6).maxCoeff() == 0);
    CHECK(contact.force.minCoeff() >= 0);
    CHECK(contact.gap.minCoeff() > -1e-10);
    // balls carry what the cup presses, but for what the ring itself carries as hoop
    double sum = 0;
    for (std::size_t i = 0; i < contact.ball_force.size(); ++i)
        sum += contact.ball_force[i] * (i == 0 || i + 1 == contact.ball_force.size() ? 0.5 : 1);
    CHECK(4 * sum == Approx(contact.total_force).epsilon(0.2));
    CHECK(*std::min_element(contact.ball_force.begin(), contact.ball_force.end()) > 0);
    CHECK(*std::max_element(contact.ball_gap.begin(), contact.ball_gap.end()) == 0);
    elastic::Bearing loose = elastic(1.2);
    loose.cam_oversize = -0.01;
    auto const off = solved(loose);
    CHECK(*std::min_element(off.ball_force.begin(), off.ball_force.end()) == 0);
    CHECK(*std::max_element(off.ball_gap.begin(), off.ball_gap.end()) > 0);
}

TEST_CASE("a ring that may move along the axis cones with the cup", "[bearing]")
{
    elastic::Bearing bearing = elastic(1.2);
    bearing.ring->axially_held = false;
    auto const contact = solved(bearing);
    CHECK(wall_coning_deg(contact, 0) > 1.5);
    CHECK(wall_coning_deg(contact, 0) < 1.68);
}

TEST_CASE("soft balls tend to rigid ones as they get stiffer", "[bearing]")
{
    auto const stiff = quickly_solved(elastic(1.2));
    double last = 1;
    for (double const stiffness : {1e3, 1e4, 1e5}) {
        elastic::Bearing bearing = elastic(1.2);
        bearing.ring->radial_stiffness = stiffness;
        auto const contact = quickly_solved(bearing);
        CHECK(contact.total_force < stiff.total_force);
        double const error = 1 - contact.total_force / stiff.total_force;
        CHECK(error < 0.5 * last);
        last = error;
    }
    CHECK(last < 0.01);
}

TEST_CASE("a turned cam turns the answer", "[bearing]")
{
    // 3 of 24 samples: the points stay the same; without mirror symmetry the whole lobe is solved
    double const turn = 3 * pi / 24;
    auto const straight = solved(elastic(1.2), elastic::cam_series(cosine_cam(24), 2, true), 5);
    auto const whole = solved(elastic(1.2), elastic::cam_series(cosine_cam(24), 2, false), 5);
    auto const turned = solved(elastic(1.2), elastic::cam_series(cosine_cam(24, turn), 2, false), 5);
    CHECK(whole.total_force == Approx(straight.total_force).epsilon(1e-9));
    CHECK(turned.total_force == Approx(straight.total_force).epsilon(1e-9));
    for (std::size_t station = 0; station < band + 2; ++station)
        for (double const phi : {0.0, 0.3, 1.0, 2.0}) {
            double const expected = straight.displacement.at(station, phi);
            CHECK(whole.displacement.at(station, phi) == Approx(expected).margin(1e-9));
            CHECK(turned.displacement.at(station, phi + turn) == Approx(expected).margin(1e-9));
        }
    // mirror symmetry: radial and axial even, tangential odd
    CHECK(straight.displacement.sine.topRows(band + 1).norm() == 0);
    CHECK(straight.displacement.cosine.row(band + 1).norm() == 0);
    CHECK(straight.force.row(0).sum() == Approx(whole.force.row(0).sum()).epsilon(1e-9));
}

TEST_CASE("the same bits of the contact for any number of threads", "[bearing]")
{
    auto const cam = elastic::cam_series(cosine_cam(32), 2, true);
    auto const one = solved(elastic(1.2), cam, 7, 1), two = solved(elastic(1.2), cam, 7, 2);
    CHECK(one.force == two.force);
    CHECK(one.displacement.cosine == two.displacement.cosine);
    CHECK(one.displacement.sine == two.displacement.sine);
}

TEST_CASE("coning and force converge with the grid of contacts", "[bearing]")
{
    auto const coarse = solved(rigid(), elastic::cam_series(cosine_cam(24), 2, true), 7);
    auto const middle = solved(rigid(), elastic::cam_series(cosine_cam(48), 2, true), 13);
    auto const fine = solved(rigid(), elastic::cam_series(cosine_cam(96), 2, true), 17);
    CHECK(std::abs(middle.total_force - fine.total_force) < 0.002 * fine.total_force);
    CHECK(std::abs(middle.total_force - fine.total_force) < std::abs(coarse.total_force - fine.total_force));
    CHECK(std::abs(wall_coning_deg(middle, 0) - wall_coning_deg(fine, 0)) < 0.005);
}

TEST_CASE("a cam of 1 and 3 waves, and a series that is exact at its samples", "[bearing]")
{
    for (int const waves : {1, 3}) {
        auto const contact = solved(elastic(1.2), elastic::cam_series(cosine_cam(24), waves, true), 7);
        CHECK(contact.residual <= numeric::contact_tolerance);
        CHECK(contact.total_force > 0);
        CHECK(contact.displacement.waves == waves);
        CHECK(contact.displacement.at(16, 0) == Approx(0.25).epsilon(0.2));
    }
    std::vector<double> const samples{0.3, -0.1, 0.2, 0.05, -0.4, 0.7};
    auto const series = elastic::cam_series(samples, 3, false);
    for (std::size_t j = 0; j < samples.size(); ++j)
        CHECK(series.at(2 * pi * static_cast<double>(j) / 18) == Approx(samples[j]).margin(1e-14));
    CHECK_THROWS_AS(elastic::cam_series({1, 2, 3}, 2, false), NumericalError);
}

TEST_CASE("bearings at their limits", "[bearing]")
{
    SECTION("width 0: one line, and the linear coning")
    {
        elastic::Bearing line = rigid();
        line.width = 0;
        auto const contact = quickly_solved(line);
        CHECK(contact.z == std::vector<double>{9});
        CHECK(wall_coning_deg(contact, 0) > 1.3);
        CHECK(contact.force.minCoeff() >= 0);
    }
    SECTION("no interference anywhere: no force")
    {
        auto const contact = quickly_solved(rigid(-0.3));
        CHECK(contact.total_force == 0);
        CHECK(contact.displacement.cosine.norm() == 0);
    }
    SECTION("interference everywhere")
    {
        auto const contact = quickly_solved(rigid(0.5));
        CHECK(contact.total_force > 1e5);
        CHECK(contact.residual <= numeric::contact_tolerance);
    }
    SECTION("wider than the straight wall, no width for a ring, no ring")
    {
        elastic::Bearing wide = rigid();
        wide.width = 20;
        CHECK_THROWS_WITH(quickly_solved(wide), ContainsSubstring("outside the straight wall"));
        elastic::Bearing none = elastic(1.2);
        none.width = 0;
        CHECK_THROWS_WITH(quickly_solved(none), ContainsSubstring("width above 0"));
        CHECK_THROWS_AS(quickly_solved(elastic(0)), NumericalError);
        CHECK_THROWS_AS(quickly_solved(elastic(30)), NumericalError);
        elastic::Bearing soft = elastic(1.2);
        soft.ring->radial_stiffness = 0;
        CHECK_THROWS_AS(quickly_solved(soft), NumericalError);
    }
    SECTION("very thin and very thick rings")
    {
        CHECK(wall_coning_deg(quickly_solved(elastic(0.05)), 0) > wall_coning_deg(quickly_solved(elastic(0.8)), 0));
        CHECK(wall_coning_deg(quickly_solved(elastic(10)), 0) < wall_coning_deg(quickly_solved(elastic(1.6)), 0));
    }
}

}  // namespace hdconj::test::wave_generator_contact_cases
