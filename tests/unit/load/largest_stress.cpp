// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far the largest stress depends on forces being in slices.
#include <array>

#include "load/grids/cup_error.hpp"
#include "load/model/cup_shape.hpp"
#include "support/catch.hpp"

namespace hdconj::test::largest_stress_cases {

TEST_CASE("forces spread over their slices keep sum and place, but for ends, which are moved inward", "[load]")
{
    load::DriveStations const stations{.bearing = 2, .slices = 7};
    auto const count = static_cast<Eigen::Index>(stations.count());
    auto const row = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    for (std::size_t slice = 0; slice < stations.slices; ++slice) {
        CAPTURE(slice);
        Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(count, 3);
        forces(0, 1) = 5;
        forces(row(stations.radial(slice)), 2) = 1;
        Eigen::MatrixXd const spread = load::spread_over_slices(stations, forces);
        CHECK(spread(0, 1) == 5);
        double sum = 0, mean = 0, square = 0;
        for (std::size_t k = 0; k < stations.slices; ++k) {
            double const f = spread(row(stations.radial(k)), 2),
                         z = static_cast<double>(k) - static_cast<double>(slice);
            sum += f;
            mean += f * z;
            square += f * z * z;
        }
        CHECK(sum == Approx(1).epsilon(1e-14));
        CHECK(spread.cwiseAbs().sum() == Approx(6).epsilon(1e-14));
        bool const first = slice == 0, last = slice + 1 == stations.slices;
        CHECK(mean == Approx(first ? 0.25 : last ? -0.25 : 0).margin(1e-14));
        if (!first && !last)
            CHECK(square == Approx(1.0 / 12).epsilon(1e-14));
    }
    // one slice stands for all of the width
    Eigen::MatrixXd const one = Eigen::MatrixXd::Ones(5, 3);
    CHECK(load::spread_over_slices({.bearing = 1, .slices = 1}, one) == one);
}

TEST_CASE("the error of the largest stress reaches what slices change, where grids agree by chance", "[load]")
{
    // an optimised drive of one drafted outline: all force on one end; 33 slices give 518 MPa, and so do spread forces
    std::array const coarser{601.9, 581.7};
    double const error = load::stress_error(598.2, coarser, 54.9, 598.2 - 518.3, 4);
    CHECK(error > 598.2 - 518);
    CHECK(error < 10 * (598.2 - 518));
    // no less than without that
    CHECK(load::stress_error(598.2, coarser, 54.9, 1, 4) == load::stress_error(598.2, coarser, 54.9, 0, 4));
}

}  // namespace hdconj::test::largest_stress_cases
