// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/distance/distance_lanes.hpp"

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "hdconj/distance/tooth_distance.hpp"
#include "profile/measured_points.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::distance_lanes_cases {

TEST_CASE("distance lanes: eight points at once have the bits of one at a time", "[contact]")
{
    profile::Profile const tooth = type50_tooth();
    distance::ToothDistance const distance(tooth);
    REQUIRE(distance.together() != nullptr);
    std::mt19937 random(23);
    std::uniform_real_distribution<double> x(-0.5, 0.5), y(0.2, 1.4), near(-1e-3, 1e-3);
    int inside = 0, others = 0;
    for (int i = 0; i < 4000; ++i) {
        distance::Lanes px, py;
        distance::DistanceLanes::Nearest found;
        for (std::size_t l = 0; l < distance::lanes; ++l) {
            Vec2 p(x(random), y(random));
            // on the profile and within a micrometre of it, where rounding decides
            if (i % 2 == 1)
                p = distance(p).point + (i % 4 == 1 ? 0.0 : near(random)) * distance(p).normal;
            px[l] = p.x();
            py[l] = p.y();
        }
        (*distance.together())(px, py, found);
        for (std::size_t l = 0; l < distance::lanes; ++l) {
            distance::NearestPoint const alone = distance(Vec2(px[l], py[l]));
            others +=
                std::bit_cast<std::uint64_t>(found.distance[l]) != std::bit_cast<std::uint64_t>(alone.distance) ? 1 : 0;
            others += found.foot_y[l] != alone.point.y() ? 1 : 0;
            others += found.normal_x[l] != alone.normal.x() || found.normal_y[l] != alone.normal.y() ? 1 : 0;
            inside += alone.distance < 0 ? 1 : 0;
        }
    }
    CHECK(others == 0);
    CHECK(inside > 5000);
}

TEST_CASE("distance lanes: none for a tooth with curves", "[contact]")
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 12; ++i)
        points.emplace_back(0.06 + 0.02 * i, 0.2 - 0.04 * i);
    profile::FlankSegment flank{"flank", {}};
    for (profile::CurvePiece& piece : profile::spline_through(points))
        flank.pieces.emplace_back(std::move(piece));
    profile::Profile const tooth = profile::symmetric_tooth({flank}, {0.25, 200, 0.7, 0, ""}, 0.2, 0.28);
    CHECK(distance::ToothDistance(tooth).together() == nullptr);
}

}  // namespace hdconj::test::distance_lanes_cases
