// SPDX-License-Identifier: GPL-3.0-or-later
// Fields under unit loads: what is made of them is what is solved for anew.
#include "elastic/harmonic_field.hpp"

#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "unit/elastic/solved_field.hpp"

namespace hdconj::test::unit_fields_cases {

namespace {

struct Cup
{
    elastic::FourierSolid solid{elastic::section_mesh({})};
    std::vector<elastic::Station> stations;
    std::vector<int> harmonics = elastic::harmonics_of(2, 12);

    Cup()
    {
        for (elastic::Direction const direction :
             {elastic::Direction::radial, elastic::Direction::tangential, elastic::Direction::axial})
            for (double const z : {6.0, 9.0, 12.0})
                stations.push_back(elastic::wall_station(solid.mesh(), z,
                                                         direction == elastic::Direction::radial ? 0 : 0.5, direction));
    }
};

}  // namespace

TEST_CASE("influence and field of unit fields are those of the solid", "[unit_fields]")
{
    Cup const cup;
    elastic::UnitFields const unit = *unit_fields(cup.solid, {}, cup.stations, cup.harmonics, 1);
    elastic::Influence const own = influence(cup.solid, {}, cup.stations, cup.harmonics),
                             made = influence_of_fields(cup.solid, unit, cup.stations);
    REQUIRE(made.harmonics() == own.harmonics());
    for (std::size_t i = 0; i < cup.harmonics.size(); ++i)
        CHECK(made.compliance(i) == own.compliance(i));
    auto const rows = static_cast<Eigen::Index>(cup.stations.size()),
               columns = static_cast<Eigen::Index>(cup.harmonics.size());
    Eigen::MatrixXd even(rows, columns), odd(rows, columns);
    for (Eigen::Index k = 0; k < columns; ++k)
        for (Eigen::Index a = 0; a < rows; ++a) {
            even(a, k) = std::cos(1.0 + static_cast<double>(3 * a + 7 * k));
            odd(a, k) = std::sin(2.0 + static_cast<double>(5 * a + 2 * k));
        }
    elastic::HarmonicField const solved = solved_field(cup.solid, {}, cup.stations, cup.harmonics, even, odd),
                                 combined = elastic::harmonic_field(unit, even, odd);
    double const size = solved.even.cwiseAbs().maxCoeff();
    constexpr double rounding = 1e-10;  // of a thin wall's condition
    CHECK((solved.even - combined.even).cwiseAbs().maxCoeff() <= rounding * size);
    CHECK((solved.odd - combined.odd).cwiseAbs().maxCoeff() <= rounding * size);
    // all angles at once are each angle by itself
    std::vector<double> const phi{0, 0.3, 1.1, 2.9};
    Eigen::Matrix3Xd const together = displacements_at(cup.solid.mesh(), solved, cup.stations[4].place,
                                                       elastic::HarmonicWaves(solved.harmonics, phi));
    for (std::size_t j = 0; j < phi.size(); ++j)
        CHECK((together.col(static_cast<Eigen::Index>(j)) -
               displacement_at(cup.solid.mesh(), solved, cup.stations[4].place, phi[j]))
                  .norm() <= rounding * size);
}

TEST_CASE("unit fields have the same bits on any number of threads", "[unit_fields]")
{
    Cup const cup;
    elastic::UnitFields const two = *unit_fields(cup.solid, {}, cup.stations, cup.harmonics, 2);
    CHECK(unit_fields(cup.solid, {}, cup.stations, cup.harmonics, 1)->moved == two.moved);
}

}  // namespace hdconj::test::unit_fields_cases
