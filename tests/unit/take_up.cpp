// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact/take_up.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hdconj/contact/smallest_gap.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/tolerance.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

using namespace hdconj;
using namespace hdconj::test;

namespace {

/// At and between the points of the flanks, after a turn.
double smallest(GapField const& field, double turn, int flank)
{
    return smallest_gap(field, field.map(turn, 1), turn, flank, 1).gap;
}

/// All teeth turned clockwise by @p angle about the axis, as the flexspline itself turns.
ToothPlaces turned(ToothPlaces places, double angle)
{
    for (Pose& pose : places.pose)
    {
        double const theta = std::atan2(pose.sine, pose.cosine) + angle;
        pose = {std::cos(theta), std::sin(theta), turned_clockwise(pose.origin, angle)};
    }
    return places;
}

/// Field of the built-in pair, or of its coned form, with a side clearance.
struct Pair
{
    Pair(std::vector<std::string> const& keys, int slices, double clearance, double phase = 0, double turned_by = 0)
        : drive(builtin_scene(keys), slices), grid(moved_into_material(drive.flanks(drive.surface(slices > 1 ? "per-slice" : "tilted"), 60), clearance)),
          places(turned(detail::tooth_places(*drive.bench, phase), turned_by)), field(drive.tooth, grid, places, drive.z_f(), drive.z_c(), phase),
          rest(field.map(0, 1))
    {
    }
    ConedDrive drive;
    FlankGrid grid;
    ToothPlaces places;
    GapField field;
    GapMap rest;
};

constexpr double enough = 1e-12;   // mm

}  // namespace

TEST_CASE("take-up ends where the smallest gap is zero and not before", "[take_up]")
{
    for (double const phase : {0.0, 0.004, -0.011})
        for (int const slices : {1, 3})
        {
            Pair const pair(slices > 1 ? coned() : std::vector<std::string>{}, slices, 0.01, phase);
            REQUIRE(smallest(pair.field, 0, GapMap::right) > 0);
            for (int const flank : {GapMap::left, GapMap::right})
            {
                double const sense = flank == GapMap::right ? 1 : -1;
                TakeUp const found = take_up(pair.field, pair.rest, flank, pair.drive.pitch(), 1);
                INFO("phase " << phase << ", slices " << slices << ", flank " << flank << ", turn " << found.turn);
                CHECK(found.turn > 0);
                GapMap const touching = pair.field.map(sense * found.turn, 1);
                CHECK(std::abs(smallest(pair.field, sense * found.turn, flank)) < enough);
                CHECK(std::abs(found.gap) < enough);
                // the point beside the smallest gap
                double const beside = touching.at(found.where.space, flank, found.where.slice, found.where.point);
                CHECK(beside > found.gap - enough);
                CHECK(beside < found.gap + 0.5 * pair.field.spacing());
                CHECK(found.where.flank == flank);
                for (int i = 0; i < 16; ++i)
                    CHECK(smallest(pair.field, sense * found.turn * i / 16, flank) > 0);
                CHECK(smallest(pair.field, sense * found.turn * (1 + 1e-6), flank) < 0);
                // no faster than the reach
                CHECK(found.turn * pair.field.reach() >= smallest(pair.field, 0, flank));
                TakeUp const threaded = take_up(pair.field, pair.rest, flank, pair.drive.pitch(), 4);
                CHECK(threaded.turn == found.turn);
                CHECK(threaded.gap == found.gap);
            }
        }
}

TEST_CASE("take-up of a symmetric pair is the same either way and grows with the side clearance", "[take_up]")
{
    double before = 0;
    for (double const clearance : {1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.02})
    {
        Pair const pair({}, 1, clearance);
        TakeUp const right = take_up(pair.field, pair.rest, GapMap::right, pair.drive.pitch(), 1);
        TakeUp const left = take_up(pair.field, pair.rest, GapMap::left, pair.drive.pitch(), 1);
        INFO("clearance " << clearance);
        // a turn moves flank points by the radius times a cosine; some flank stands within 60 degrees of the radius
        CHECK(right.turn > clearance / pair.field.reach());
        CHECK(right.turn < 2 * clearance / 25.0 + 1e-6);
        CHECK(left.turn == Approx(right.turn).margin(1e-14));
        CHECK(right.turn > before);
        before = right.turn;
    }
}

TEST_CASE("take-up turns back out of interference by as much as the flexspline was turned into it", "[take_up]")
{
    Pair const free({}, 1, 0.01, 0.003);
    double const play = take_up(free.field, free.rest, GapMap::right, free.drive.pitch(), 1).turn;
    double const play_back = take_up(free.field, free.rest, GapMap::left, free.drive.pitch(), 1).turn;
    for (double const turn : {0.5 * play, 1.001 * play, 1.5 * play, 3 * play, -0.5 * play_back, -4 * play_back})
    {
        Pair const pair({}, 1, 0.01, 0.003, turn);
        INFO("turned by " << turn << " of " << play);
        TakeUp const right = take_up(pair.field, pair.rest, GapMap::right, pair.drive.pitch(), 1);
        TakeUp const left = take_up(pair.field, pair.rest, GapMap::left, pair.drive.pitch(), 1);
        CHECK(right.turn == Approx(play - turn).margin(1e-13));
        CHECK(left.turn == Approx(play_back + turn).margin(1e-13));
        CHECK((smallest(pair.field, 0, GapMap::right) < 0) == (turn > play));
        CHECK(std::abs(right.gap) < enough);
    }
}

TEST_CASE("take-up without any clearance turns by nothing", "[take_up]")
{
    Pair const pair({}, 1, 0);
    for (int const flank : {GapMap::left, GapMap::right})
        CHECK(std::abs(take_up(pair.field, pair.rest, flank, pair.drive.pitch(), 1).turn) < 1e-8);
}

TEST_CASE("take-up finds contact anywhere within its limit and says so where there is none", "[take_up]")
{
    Pair const pair({}, 1, 0.01);
    double const turn = take_up(pair.field, pair.rest, GapMap::right, pair.drive.pitch(), 1).turn;
    for (double const part : {1.001, 1.01, 1.1, 1.3, 1.49, 2.0})
        CHECK(take_up(pair.field, pair.rest, GapMap::right, part * turn, 1).turn == Approx(turn).margin(32 * unit_roundoff));
    for (double const part : {0.999, 0.5, 1e-3})
    {
        CHECK_THROWS_AS(take_up(pair.field, pair.rest, GapMap::right, part * turn, 1), NumericalError);
        CHECK_THROWS_WITH(take_up(pair.field, pair.rest, GapMap::right, part * turn, 1), ContainsSubstring("take-up") && ContainsSubstring("no flank touches"));
    }
}
