// SPDX-License-Identifier: GPL-3.0-or-later
// What is advised where no wall stands the stress, with walls whose stress is given.
#include "design/nearest_wishes.hpp"

#include <algorithm>

#include "design/wishes.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::nearest_wishes_cases {
namespace {

WallTrial wall_with(double assembled, double loaded, bool interferes = false)
{
    WallTrial trial;
    trial.wall = 0.3;
    trial.assembled = assembled;
    trial.loaded = loaded;
    trial.interferes = interferes;
    trial.refusal = interferes ? "the coned cup needs more" : "too much stress";
    return trial;
}

DesignWishes wishes_with(double length_ratio, double land)
{
    DesignWishes wishes;
    wishes.diameter = 20;
    wishes.torque = newton_metre;
    wishes.length_ratio = length_ratio;
    wishes.land = land;
    return wishes;
}

/// What is advised after all of @p walls, the best last, were refused.
Faults advised(DesignWishes const& wishes, std::vector<WallTrial> walls)
{
    design::MeshedSheet failed;
    failed.mesh.best = 0;
    failed.walls = std::move(walls);
    design::WallSearch search(wishes, {});
    return nearest_wishes(wishes, failed, search);
}

bool says(Fault const& fault, char const* words)
{
    return fault.reason.find(words) != std::string::npos || fault.remedy.find(words) != std::string::npos;
}

bool names(Faults const& faults, char const* option)
{
    return std::ranges::find(faults, option, &Fault::path) != faults.end();
}

}  // namespace

TEST_CASE("a wall that is clear is a better one than any that is not, then less stress counts", "[design]")
{
    WallTrial const clear = wall_with(900, 950), weaker = wall_with(900, 960), caught = wall_with(500, 500, true);
    WallTrial const failed = wall_with(0, 0);
    CHECK(design::is_better(clear, weaker));
    CHECK(design::is_better(weaker, caught));
    CHECK(design::is_better(caught, failed));
    CHECK_FALSE(design::is_better(caught, clear));
    CHECK_FALSE(design::is_better(clear, clear));
}

TEST_CASE("where the cone is in the way no remedy is named that cannot be followed", "[design]")
{
    for (double const length_ratio : {0.3, 1.})
        for (double const land : {0., 0.4}) {
            CAPTURE(length_ratio, land);
            Faults const faults = advised(wishes_with(length_ratio, land), {wall_with(900, 900, true)});
            REQUIRE(faults.size() == 1);
            CHECK(faults.front().path == (length_ratio < 1 ? "--length-ratio" : "--family"));
            CHECK(says(faults.front(), "larger") == (length_ratio < 1));
            CHECK(says(faults.front(), "--land") == (land > 0));
            CHECK_FALSE(says(faults.front(), "without torque"));
        }
}

TEST_CASE("a cup that is bent too far without torque is told the safety and the steel that it leaves", "[design]")
{
    DesignWishes wishes = wishes_with(1, 0.4);
    wishes.material = "42CrMo4";
    wishes.safety = 3;
    // 550/320 = 1.72; under the torque no safety is left
    Faults const too_safe = advised(wishes, {wall_with(320, 1500), wall_with(330, 1200)});
    CHECK(names(too_safe, "--safety"));
    CHECK_FALSE(names(too_safe, "--torque"));
    CHECK_FALSE(names(too_safe, "--length-ratio"));
    for (Fault const& each : too_safe)
        CHECK(says(each, each.path == "--safety" ? "less than 1.71," : "--torque"));

    wishes.safety = 1.2;
    Faults const too_weak = advised(wishes, {wall_with(480, 1500), wall_with(490, 1200)});
    CHECK(names(too_weak, "--material"));  // 576 MPa are needed without torque

    // nothing but a strength that no steel of the table has, or a cup that is bent less
    for (double const length_ratio : {0.3, 1.}) {
        wishes.length_ratio = length_ratio;
        Faults const faults = advised(wishes, {wall_with(1600, 1700)});
        CHECK(names(faults, "--fatigue"));
        CHECK(names(faults, "--length-ratio") == (length_ratio < 1));
        CHECK(names(faults, "--ratio") == (length_ratio == 1));
        CHECK(faults.size() == 2);
        for (Fault const& each : faults)
            CHECK(says(each, "even without torque"));
    }
}

TEST_CASE("a torque that no wall stands asks for a larger drive, where there is one", "[design]")
{
    DesignWishes wishes = wishes_with(0.5, 0.4);
    Faults const faults = advised(wishes, {wall_with(300, 5000)});
    REQUIRE(faults.size() == 1);
    CHECK(says(faults.front(), "a larger --diameter or a larger --ratio"));
    wishes.diameter.reset();
    wishes.module = 0.625;  // 400 mm with 640 teeth
    wishes.ratio = 320;
    CHECK(says(advised(wishes, {wall_with(300, 5000)}).front(), "write a smaller one"));
}

}  // namespace hdconj::test::nearest_wishes_cases
