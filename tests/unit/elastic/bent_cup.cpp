// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic/bent_cup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"
#include "support/catch.hpp"
#include "unit/elastic/solved_field.hpp"

namespace hdconj::test::bent_cup_cases {

namespace {

using std::numbers::pi;
constexpr double r_m = 24.35;

elastic::BentCup const& type_50()
{
    static elastic::BentCup const cup = [] {
        elastic::Bearing bearing{9, 6, 0, 0, elastic::BearingRing{}};
        std::vector<double> samples;
        for (int j = 0; j < 48; ++j)
            samples.push_back(0.25 * std::cos(2 * pi * j / 48));
        return elastic::BentCup({}, bearing, elastic::cam_series(samples, 2, true), 13, 1);
    }();
    return cup;
}

}  // namespace

TEST_CASE("the bent cup cones, skews and shifts as the finite-element study says", "[bent_cup]")
{
    elastic::BentCup const& cup = type_50();
    CHECK(cup.coning(0) * 180 / pi == Approx(1.244).epsilon(0.01));
    CHECK(cup.coning(pi / 2) * 180 / pi == Approx(-1.293).epsilon(0.01));
    CHECK(cup.axial(9, r_m, 0).u_z == Approx(-0.175).margin(0.02));
    // displacement of the slice and of the body are one
    for (double const z : {5.3, 9.0, 12.6})
        for (double const phi : {0.0, 0.4, 1.1}) {
            auto const slice = wavegen::displacement_at(cup.displacement(z, r_m), phi);
            Eigen::Vector3d const u = elastic::displacement_at(cup.solid().mesh(), cup.field(),
                                                               elastic::wall_point(cup.solid().mesh(), z, 0.5), phi);
            CHECK(slice.w[0] == Approx(u[0]).margin(1e-12));
            CHECK(slice.v[0] == Approx(u[2]).margin(1e-12));
            CHECK(cup.axial(z, r_m, phi).u_z == Approx(u[1]).margin(1e-12));
            // bending hardly stretches the middle of the wall: w and v' all but cancel
            CHECK(std::abs(slice.v[1] + slice.w[0]) < 0.05);
        }
    CHECK(is_symmetric(cup.displacement(9, r_m)));
    // the field solves the same problem as the influence of the contact: gaps of points that touch are closed
    auto const& contact = cup.contact();
    Eigen::Index const last = contact.force.rows() - 1;
    CHECK(contact.force.row(last).maxCoeff() > 0);
    CHECK(contact.gap.minCoeff() > -1e-10);
}

TEST_CASE("derivatives of the axial move", "[bent_cup]")
{
    elastic::BentCup const& cup = type_50();
    constexpr double step = 1e-4;
    for (double const phi : {0.2, 0.9}) {
        elastic::AxialMove const move = cup.axial(8.3, r_m, phi);
        double const by_phi = (cup.axial(8.3, r_m, phi + step).u_z - cup.axial(8.3, r_m, phi - step).u_z) / (2 * step);
        CHECK(move.by_phi == Approx(by_phi).epsilon(1e-5));
        CHECK(std::abs(move.by_z) < 0.002);
    }
}

TEST_CASE("no wall, no displacement", "[bent_cup]")
{
    elastic::BentCup const& cup = type_50();
    CHECK_THROWS_WITH(cup.displacement(9, 25), ContainsSubstring("does not reach the radius"));
    CHECK_THROWS_WITH(cup.displacement(9, 23.9), ContainsSubstring("does not reach the radius"));
    CHECK_THROWS_AS(cup.displacement(0.3, r_m), NumericalError);
    CHECK_NOTHROW(cup.displacement(13.2, r_m));
}

TEST_CASE("stress of a thick ring under inner pressure is Lame's", "[bent_cup]")
{
    double const a = 10, b = 15, width = 2, pressure = 100;
    elastic::FourierSolid const solid(elastic::ring_mesh({a, 0}, {b, width}, {206e3, 0.3}, {2, 0.5}));
    std::vector<elastic::Station> stations;
    for (double const z : {0.0, 1.0, 2.0})
        stations.push_back(elastic::wall_station(solid.mesh(), z, 0, elastic::Direction::radial));
    Eigen::MatrixXd const load = Eigen::Vector3d(1, 4, 1) * (pressure * width * a / 6);
    elastic::Supports const supports{{0, elastic::Direction::axial, -1, 0}, {0, elastic::Direction::tangential, -1, 0}};
    elastic::HarmonicField const field =
        solved_field(solid, supports, stations, {0}, load, Eigen::MatrixXd::Zero(3, 1));
    double const factor = pressure * a * a / (b * b - a * a);
    double const g = std::sqrt(1.0 / 3);
    std::vector<Vec2> const places{{-g, -g}, {g, -g}, {-g, g}, {g, g}};
    Eigen::MatrixXd const stress = elastic::recovered_stress(solid.mesh(), field, places, {0.7});
    for (std::size_t i = 0; i < 4 * solid.mesh().elements.size(); ++i) {
        double const r = elastic::position(solid.mesh(), {i / 4, places[i % 4].x(), places[i % 4].y()}).x();
        double const share = b * b / (r * r);  // radial and tangential stress are 1 -+ share of the factor
        CHECK(stress(static_cast<Eigen::Index>(i), 0) == Approx(factor * std::sqrt(1 + 3 * share * share)).margin(0.1));
    }
    CHECK(elastic::von_mises({100, 0, 0, 0, 0, 0}) == Approx(100));
    CHECK(elastic::von_mises({100, 100, 100, 0, 0, 0}) == Approx(0).margin(1e-12));
    CHECK(elastic::von_mises({0, 0, 0, 10, 0, 0}) == Approx(10 * std::sqrt(3.0)));
}

TEST_CASE("both families of a field are one turned by a quarter of a wave", "[bent_cup]")
{
    elastic::FourierSolid const solid(elastic::section_mesh({}, {1, 1}));
    std::vector<elastic::Station> const stations{
        elastic::wall_station(solid.mesh(), 9, 0, elastic::Direction::radial),
        elastic::wall_station(solid.mesh(), 10, 1, elastic::Direction::tangential)};
    Eigen::MatrixXd const load = Eigen::Vector2d(3, 2), none = Eigen::Vector2d::Zero();
    elastic::HarmonicField const even = solved_field(solid, {}, stations, {4}, load, none),
                                 odd = solved_field(solid, {}, stations, {4}, none, load);
    elastic::SectionPoint const place = elastic::wall_point(solid.mesh(), 7.7, 0.3);
    for (double const phi : {0.0, 0.3, 1.9}) {
        // sin n phi = cos n (phi - pi/2n)
        Eigen::Vector3d const u = elastic::displacement_at(solid.mesh(), odd, place, phi),
                              turned = elastic::displacement_at(solid.mesh(), even, place, phi - pi / 8);
        CHECK((u - turned).norm() <= 1e-12 * u.norm());
        Eigen::MatrixXd const s = elastic::recovered_stress(solid.mesh(), odd, {{0.3, -0.2}}, {phi}),
                              t = elastic::recovered_stress(solid.mesh(), even, {{0.3, -0.2}}, {phi - pi / 8});
        CHECK((s - t).norm() <= 1e-9 * s.norm());
    }
}

TEST_CASE("the peak of the stress and the same bits for any number of threads", "[bent_cup]")
{
    elastic::BentCup const& cup = type_50();
    std::vector<double> phi;
    for (int i = 0; i <= 24; ++i)
        phi.push_back(pi / 2 * i / 24);
    elastic::StressPeak const peak = elastic::stress_peak(cup.solid().mesh(), cup.field(), phi);
    // at the ramp behind the teeth, as in the finite-element study
    CHECK(elastic::position(cup.solid().mesh(), peak.place).y() == Approx(4.6).margin(0.2));
    CHECK(elastic::recovered_stress(cup.solid().mesh(), cup.field(), {{1, 0}}, phi, 1) ==
          elastic::recovered_stress(cup.solid().mesh(), cup.field(), {{1, 0}}, phi, 2));
}

TEST_CASE("a wall of one element has the stress of its surface", "[bent_cup]")
{
    elastic::BentCup const& cup = type_50();
    std::vector<double> const phi = elastic::even_angles(90, 2);
    double const one = elastic::stress_peak(cup.solid().mesh(), cup.field(), phi).stress;
    for (int const layers : {2, 4}) {
        elastic::BentCup const fine(cup.section(), cup.bearing(), cup.cam(), 13, 1, layers);
        CHECK(elastic::stress_peak(fine.solid().mesh(), fine.field(), phi).stress == Approx(one).epsilon(0.01));
    }
}

TEST_CASE("bending of a ring has Euler's stress on both surfaces", "[bent_cup]")
{
    double const r = 100, t = 1, width = 1;
    for (double const across : {1.0, 0.25}) {
        elastic::FourierSolid const solid(
            elastic::ring_mesh({r - t / 2, 0}, {r + t / 2, width}, {206e3, 0.0}, {width, across}));
        std::vector<elastic::Station> stations;
        for (double const z : {0.0, 0.5, 1.0})
            stations.push_back(elastic::wall_station(solid.mesh(), z, 0.5, elastic::Direction::radial));
        Eigen::MatrixXd const load = Eigen::Vector3d(1, 4, 1);
        elastic::HarmonicField const field = solved_field(solid, {}, stations, {2}, load, Eigen::MatrixXd::Zero(3, 1));
        double const w = elastic::displacement_at(solid.mesh(), field, stations[1].place, 0)[0];
        double const bending = 206e3 * (t / 2) * 3 * w / (r * r);  // E t/2 (n^2 - 1) w/r^2
        CHECK(elastic::stress_peak(solid.mesh(), field, {0}).stress == Approx(bending).epsilon(0.03));
    }
}

}  // namespace hdconj::test::bent_cup_cases
