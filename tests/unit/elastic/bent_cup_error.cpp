// SPDX-License-Identifier: GPL-3.0-or-later
// What a bent cup is said to be known to, against finer ones of the same bodies.
#include "elastic/bent_cup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hdconj/wavegen/cosine_cam.hpp"
#include "support/catch.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::bent_cup_error_cases {

namespace {

struct Bodies
{
    char const* name;
    elastic::CupSection section;
    elastic::Bearing bearing;
    double radius, w0;

    [[nodiscard]] elastic::BentCup with(elastic::BentCupGrid const& grid) const
    {
        std::vector<double> samples;
        for (int j = 0; j < grid.angles; ++j)
            samples.push_back(w0 * std::cos(2 * std::numbers::pi * j / grid.angles));
        return elastic::BentCup(section, bearing, elastic::cam_series(samples, 2, true), grid.circles, 2, grid.layers);
    }
};

/// A short cup with a thick toothed ring, strongly bent by a rigid bearing: edges press where nothing gives way.
Bodies short_and_rigid()
{
    elastic::CupSection section;
    section.inner_radius = 19.1152;
    section.length = 14;
    section.wall = 0.4;
    section.ring_wall = 0.7;
    section.ring_begin = 5.5;
    section.ring_end = 12.5;
    section.rear_ramp = section.front_ramp = 0.3;
    section.bottom = 0.6;
    section.corner_radius = 1.8;
    section.clamp_radius = 10;
    return {"short, rigid bearing", section, {9, 5, 0, 0, std::nullopt}, section.inner_radius + 0.35, 0.4};
}

}  // namespace

TEST_CASE("what a bent cup is said to be known to holds its finer ones, of either bearing", "[bent_cup]")
{
    elastic::BentCupGrid const standard;
    for (Bodies const& bodies :
         {Bodies{"type-50, ring", {}, {9, 6, 0, 0, elastic::BearingRing{}}, 24.35, 0.25},
          Bodies{"type-50, rigid", {}, {9, 6, 0, 0, std::nullopt}, 24.35, 0.25}, short_and_rigid()}) {
        elastic::BentCup const cup = bodies.with(standard);
        std::vector<double> const z = {6.5, 9, 11.5};
        BentCupError const error =
            elastic::bent_cup_error(cup, bodies.with(elastic::discretised_otherwise(standard)), z, bodies.radius);
        std::vector<elastic::BentCupGrid> grids{{96, 13, 2}, {96, 25, 1}, {128, 41, 3}};
        if (full_run())
            grids.insert(grids.begin(), {96, 37, 2});
        double finest = 0;
        for (elastic::BentCupGrid const& grid : grids) {
            INFO(bodies.name << ", " << grid.angles << " angles, " << grid.circles << " circles, " << grid.layers
                             << " layers");
            BentCupError const distance = elastic::distance_between(cup, bodies.with(grid), z, bodies.radius);
            finest = distance.displacement;
            CHECK(distance.displacement <= error.displacement);
            CHECK(distance.force <= error.force);
            CHECK(distance.coning_major <= error.coning_major);
        }
        // and is no empty word
        constexpr double most = 30;
        CHECK(error.displacement <= most * finest);
    }
}

TEST_CASE("the grid to compare one with is coarser around and along, finer through the wall", "[bent_cup]")
{
    elastic::BentCupGrid const other = elastic::discretised_otherwise({48, 13, 1});
    CHECK(other.angles == 24);
    CHECK(other.circles == 7);
    CHECK(other.layers == 2);
    elastic::BentCupGrid const least = elastic::discretised_otherwise({8, 1, 1});
    CHECK(least.angles == 8);
    CHECK(least.circles == 1);
    CHECK(elastic::discretised_otherwise({50, 2, 1}).angles == 24);
}

}  // namespace hdconj::test::bent_cup_error_cases
