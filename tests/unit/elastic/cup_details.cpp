// SPDX-License-Identifier: GPL-3.0-or-later
// Fillets beside the tooth ring, and the teeth as a layer on it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "elastic/bent_cup.hpp"
#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "unit/elastic/solved_field.hpp"

namespace hdconj::test::cup_details_cases {

namespace {

using std::numbers::pi;

/// Largest equivalent stress between two heights under a line load of two waves at z = 9 that moves the wall there by
/// 0.25 mm, on a mesh of @p size in both directions.
double stress_near(elastic::CupSection const& cup, double size, double low, double high)
{
    elastic::FourierSolid const solid(elastic::section_mesh(cup, {size, size}));
    std::vector<elastic::Station> const station{elastic::wall_station(solid.mesh(), 9, 0, elastic::Direction::radial)};
    elastic::HarmonicField field =
        solved_field(solid, {}, station, {2}, Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Zero(1, 1));
    field.even *= 0.25 / elastic::displacement_at(solid.mesh(), field, station.front().place, 0)[0];
    std::vector<double> phi;
    for (int i = 0; i <= 12; ++i)
        phi.push_back(pi / 24 * i);
    double const g = std::sqrt(1.0 / 3);
    std::vector<Vec2> const places{{-1, -g}, {1, -g}, {-1, g}, {1, g}};
    Eigen::MatrixXd const stress = elastic::recovered_stress(solid.mesh(), field, places, phi);
    double largest = 0;
    for (std::size_t i = 0; i < 4 * solid.mesh().elements.size(); ++i)
        if (double const z = elastic::position(solid.mesh(), {i / 4, places[i % 4].x(), places[i % 4].y()}).y();
            z > low && z < high)
            largest = std::max(largest, stress.row(static_cast<Eigen::Index>(i)).maxCoeff());
    return largest;
}

Eigen::MatrixXd ring_compliance(elastic::SectionMesh mesh, int harmonic)
{
    elastic::FourierSolid const solid(std::move(mesh), elastic::Quadrature::full);  // as a layer has it
    elastic::Supports const supports{{0, elastic::Direction::axial, -1, 0}, {0, elastic::Direction::tangential, -1, 0}};
    std::vector<elastic::Station> stations;
    for (elastic::Direction const direction :
         {elastic::Direction::radial, elastic::Direction::axial, elastic::Direction::tangential})
        for (double const z : {0.4, 1.7, 3.0})
            stations.push_back(elastic::wall_station(solid.mesh(), z, 0, direction));
    return elastic::influence(solid, supports, stations, {harmonic}).compliance(0);
}

double coning_of(elastic::CupSection const& section)
{
    std::vector<double> samples;
    for (int j = 0; j < 24; ++j)
        samples.push_back(0.25 * std::cos(2 * pi * j / 24));
    return elastic::BentCup(section, {9, 6, 0, 0, elastic::BearingRing{}}, elastic::cam_series(samples, 2, true), 7, 1)
               .coning(0) *
           180 / pi;
}

}  // namespace

TEST_CASE("stress in a fillet converges where that of a sharp ramp grows", "[cup_details]")
{
    elastic::CupSection ramp, fillet;
    fillet.rear_fillet = fillet.front_fillet = 0.5;
    // the arc from the barrel to the ring is sqrt(0.3 (1 - 0.3)) = 0.458 long
    double const low = 4, high = 5;
    std::vector<double> sharp, rounded;
    for (double const size : {0.1, 0.05, 0.025}) {
        sharp.push_back(stress_near(ramp, size, low, high));
        rounded.push_back(stress_near(fillet, size, low, high));
    }
    CAPTURE(sharp[0], sharp[1], sharp[2], rounded[0], rounded[1], rounded[2]);
    // Gauss points come nearer to the surface as elements get smaller: order one, where there is a limit
    CHECK(sharp[2] - sharp[1] > 1.5 * (sharp[1] - sharp[0]));
    CHECK(rounded[2] - rounded[1] < 0.6 * (rounded[1] - rounded[0]));
    CHECK(std::abs(rounded[2] - rounded[1]) < 0.02 * rounded[1]);
}

TEST_CASE("the mesh of a fillet is an arc, tangent to the thinner wall", "[cup_details]")
{
    elastic::CupSection cup;
    cup.rear_fillet = 0.8;
    cup.front_fillet = 0.4;
    elastic::SectionMesh const mesh = elastic::section_mesh(cup, {0.1, 1});
    for (bool const rear : {true, false}) {
        double const radius = rear ? cup.rear_fillet : cup.front_fillet;
        double const length = std::sqrt(0.3 * (2 * radius - 0.3));
        Vec2 const centre(cup.inner_radius + cup.wall + radius, rear ? cup.ring_begin - length : cup.ring_end + length);
        int on_arc = 0;
        for (Vec2 const& node : mesh.nodes) {
            bool const beside = rear ? node.y() > centre.y() && node.y() < cup.ring_begin
                                     : node.y() < centre.y() && node.y() > cup.ring_end;
            if (beside && node.x() > cup.inner_radius + 0.9 * cup.wall) {
                CHECK((node - centre).norm() == Approx(radius).epsilon(1e-12));
                ++on_arc;
            }
        }
        CHECK(on_arc > 8);
    }
    // what carries the load changes little
    CHECK(coning_of(cup) == Approx(coning_of({})).epsilon(0.01));
    cup.rear_fillet = 0.2;
    CHECK_THROWS_WITH(section_mesh(cup), ContainsSubstring("less than the wall grows by"));
    cup.rear_fillet = 0.3;
    CHECK_NOTHROW(elastic::FourierSolid(section_mesh(cup)));
    cup.rear_fillet = -1;
    CHECK_THROWS_AS(section_mesh(cup), NumericalError);
}

TEST_CASE("a layer of the wall's own material is a thicker wall", "[cup_details]")
{
    elastic::Elasticity const steel;
    elastic::MeshSize const size{0.5, 0.5};
    elastic::SectionMesh layered = elastic::ring_mesh({10, 0}, {10.5, 3.5}, steel, size);
    elastic::add_outer_layer(layered, 0, 3.5, 1, size.across, elastic::stress_matrix(steel));
    REQUIRE(layered.elements.size() == 3 * layered.wall_elements());
    for (int const n : {0, 2, 7})  // a free ring has no answer for n = 1
    {
        Eigen::MatrixXd const thick = ring_compliance(elastic::ring_mesh({10, 0}, {11.5, 3.5}, steel, size), n),
                              both = ring_compliance(layered, n);
        CHECK((both - thick).norm() <= 1e-9 * thick.norm());
    }
}

TEST_CASE("teeth carry no hoop stress", "[cup_details]")
{
    // without lateral strain a pressed ring does not feel the teeth on it at all
    elastic::Elasticity const material{206e3, 0};
    elastic::SectionMesh const bare = elastic::ring_mesh({10, 0}, {10.5, 3.5}, material, {0.5, 1});
    elastic::SectionMesh toothed = bare;
    elastic::add_outer_layer(toothed, 0, 3.5, 0.6, 1, elastic::tooth_stress_matrix(material, 0.5));
    auto const pressed = [](elastic::SectionMesh const& mesh) {
        elastic::FourierSolid const solid(mesh);
        elastic::Supports const supports{{0, elastic::Direction::axial, -1, 0},
                                         {0, elastic::Direction::tangential, -1, 0}};
        std::vector<elastic::Station> stations;
        Eigen::MatrixXd load(8, 1);
        for (int i = 0; i <= 7; ++i) {
            stations.push_back(elastic::wall_station(mesh, 0.5 * i, 0, elastic::Direction::radial));
            load(i, 0) = (i == 0 || i == 7 ? 1.0 : 2.0);
        }
        // and the middles of the elements: Simpson's rule
        for (int i = 0; i < 7; ++i)
            stations.push_back(elastic::wall_station(mesh, 0.5 * i + 0.25, 0, elastic::Direction::radial));
        load.conservativeResize(15, 1);
        load.bottomRows(7).setConstant(4);
        elastic::HarmonicField const field =
            solved_field(solid, supports, stations, {0}, load, Eigen::MatrixXd::Zero(15, 1));
        return elastic::displacement_at(mesh, field, elastic::wall_point(mesh, 1.1, 0.3), 0)[0];
    };
    CHECK(pressed(toothed) == Approx(pressed(bare)).epsilon(1e-10));
    // bending along the axis it does: a ring whose edge is pushed
    CHECK(ring_compliance(toothed, 4)(0, 0) < 0.999 * ring_compliance(bare, 4)(0, 0));
}

TEST_CASE("a layer of teeth that fades away leaves the bare cup", "[cup_details]")
{
    double const bare = coning_of({});
    auto const with = [](double share) {
        elastic::CupSection cup;
        cup.tooth_layer = 0.53;
        cup.tooth_share = share;
        return coning_of(cup);
    };
    double const half = with(0.5), little = with(0.005), least = with(0.0005);
    CAPTURE(bare, half, little, least);
    CHECK(half > bare + 0.01);
    CHECK(half < bare + 0.06);
    CHECK(std::abs(little - bare) < 0.05 * (half - bare));
    // in step with its stiffness
    CHECK((least - bare) / (little - bare) == Approx(0.1).epsilon(0.05));
    elastic::CupSection wrong;
    wrong.tooth_layer = 0.5;
    wrong.tooth_share = 0;
    CHECK_THROWS_WITH(section_mesh(wrong), ContainsSubstring("fraction of it that is steel"));
    elastic::SectionMesh mesh = elastic::section_mesh({});
    CHECK_THROWS_WITH(add_outer_layer(mesh, 20, 21, 1, 1, elastic::StressMatrix::Zero()),
                      ContainsSubstring("no wall between"));
}

}  // namespace hdconj::test::cup_details_cases
