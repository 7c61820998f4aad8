// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/region/outer_boundary.hpp"

#include <cmath>

#include "hdconj/error.hpp"
#include "support/catch.hpp"

namespace hdconj::test::region_cases {

namespace {

std::vector<Vec2> const floor_line{{-10, 0}, {0, 0.0}, {10, 0}};

}  // namespace

TEST_CASE("the walk follows the upper side of two crossing tents", "[region]")
{
    std::vector<std::vector<Vec2>> const curves{{{-3, -1}, {-1, 3}, {1, -1}}, {{-1, -1}, {1, 3}, {3, -1}}, floor_line};
    region::OuterBoundary const boundary = region::outer_boundary(curves, 2);
    std::vector<int> order;
    for (region::BoundaryRun const& run : boundary.runs)
        order.push_back(run.curve);
    REQUIRE(order == std::vector<int>{2, 0, 1, 2});
    // the tents cross at x = 0, height 1
    CHECK(boundary.runs[1].end == Approx(1.5));
    CHECK(boundary.runs[2].begin == Approx(0.5));
    CHECK(boundary.runs[1].begin == Approx(0.25));
}

TEST_CASE("a curve run against its direction has begin > end", "[region]")
{
    std::vector<std::vector<Vec2>> const curves{{{2, -1}, {0, 2}, {-2, -1}}, floor_line};
    region::OuterBoundary const boundary = region::outer_boundary(curves, 1);
    REQUIRE(boundary.runs.size() == 3);
    CHECK(boundary.runs[1].begin > boundary.runs[1].end);
}

TEST_CASE("pieces that bound nothing are left out: antennas, inner curves, what hangs below the floor", "[region]")
{
    std::vector<std::vector<Vec2>> const curves{{{-2, -1}, {0, 3}, {2, -1}},  // tent
                                                {{0, 3}, {0, 5}},             // antenna on its top
                                                {{-0.5, 0.5}, {0.5, 0.5}},    // inside
                                                {{5, -2}, {6, -1}},           // below
                                                floor_line};
    region::OuterBoundary const boundary = region::outer_boundary(curves, 4);
    for (region::BoundaryRun const& run : boundary.runs)
        CHECK((run.curve == 0 || run.curve == 4));
    REQUIRE(boundary.runs.size() >= 3);
}

TEST_CASE("curves that share an end point bit for bit leave no gap", "[region]")
{
    Vec2 const top{0.1, 2.7182818};
    std::vector<std::vector<Vec2>> const curves{{{-2, -1}, top}, {top, {2, -1}}, floor_line};
    region::OuterBoundary const boundary = region::outer_boundary(curves, 2);
    REQUIRE(boundary.runs.size() == 4);
    CHECK(boundary.runs[1].end == 1);
    CHECK(boundary.runs[2].begin == 0);
    // negative control: with a hairline gap the walk goes in and comes out again on the inner side
    std::vector<std::vector<Vec2>> torn = curves;
    torn[1][0].x() += 1e-12;
    region::OuterBoundary const leaked = region::outer_boundary(torn, 2);
    CHECK(leaked.runs.size() != 4);
}

TEST_CASE("what sticks out by a rounding is no loose place, what hangs together with a gap is", "[region]")
{
    // two arcs that run into one point, and share the last rounding before it
    Vec2 const before{0, 3}, top{0, std::nextafter(3, 4)};
    std::vector<std::vector<Vec2>> const curves{{{-2, -1}, before, top}, {top, before, {2, -1}}, floor_line};
    CHECK_FALSE(region::outer_boundary(curves, 2).loose.empty());
    region::OuterBoundary const boundary = region::outer_boundary(curves, 2, 1e-11);
    CHECK(boundary.loose.empty());
    CHECK(boundary.runs.size() == 4);
    std::vector<std::vector<Vec2>> torn = curves;
    torn[1] = {{0.1, 3}, {2, -1}};
    CHECK_FALSE(region::outer_boundary(torn, 2, 1e-11).loose.empty());
}

TEST_CASE("a floor that is not free at its ends is an error with its place", "[region]")
{
    std::vector<std::vector<Vec2>> const curves{{{-10, 0}, {-9, 1}}, floor_line};
    CHECK_THROWS_AS(region::outer_boundary(curves, 1), NumericalError);
}

}  // namespace hdconj::test::region_cases
