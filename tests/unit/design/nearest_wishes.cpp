// SPDX-License-Identifier: GPL-3.0-or-later
// What is advised where no wall stands the stress, with walls whose stress is given.
#include "design/nearest_wishes.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "design/length_search.hpp"
#include "design/wishes.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/run/full_run.hpp"

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
/// @param length, torque  that work
Faults advised(DesignWishes const& wishes, std::vector<WallTrial> walls, std::optional<double> length = {},
               std::optional<double> torque = {})
{
    design::MeshedSheet failed;
    failed.mesh.best = 0;
    failed.walls = std::move(walls);
    return nearest_wishes(wishes, failed, {[&] { return torque; }, [&] { return length; }});
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
    for (double const land : {0., 0.4}) {
        CAPTURE(land);
        Faults const faults = advised(wishes_with(0.3, land), {wall_with(900, 900, true)});
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().path == "--family");
        CHECK(says(faults.front(), "--land") == (land > 0));
        CHECK_FALSE(says(faults.front(), "without torque"));
        Faults const longer = advised(wishes_with(0.3, land), {wall_with(900, 900, true)}, 0.45);
        REQUIRE(longer.size() == 1);
        CHECK(longer.front().path == "--length-ratio");
        CHECK(says(longer.front(), "the nearest that works is 0.45"));
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
    Faults const faults = advised(wishes, {wall_with(1600, 1700)});
    CHECK(names(faults, "--fatigue"));
    CHECK(names(faults, "--ratio"));
    CHECK(faults.size() == 2);
    Faults const longer = advised(wishes, {wall_with(1600, 1700)}, 0.7);
    CHECK(longer.size() == 1);
    CHECK(names(longer, "--length-ratio"));
    for (Faults const* all : {&faults, &longer})
        for (Fault const& each : *all)
            CHECK(says(each, "even without torque"));
}

TEST_CASE("a longer cup is named where no torque is stood that is half of the one asked for", "[design]")
{
    DesignWishes const wishes = wishes_with(0.25, 0.4);  // 1 N m
    for (auto const& [torque, named] : {std::pair(0.2, true), std::pair(0.7, false)}) {
        CAPTURE(torque);
        Faults const faults = advised(wishes, {wall_with(300, 600)}, 0.4, torque * newton_metre);
        CHECK(names(faults, "--torque"));
        CHECK(names(faults, "--length-ratio") == named);
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

TEST_CASE("a cup of the least length stands what a twentieth less does not", "[design]")
{
    DesignWishes wishes = wishes_with(0.35, 0.4);
    wishes.ratio = 80;
    wishes.diameter = 40;
    wishes.torque = 8 * newton_metre;
    CHECK(design::least_length(wishes, {}) == 0.4);
    if (full_run())  // every wall is tried in vain
        CHECK_FALSE(design::WallSearch(wishes, {}).best(false).works());
    wishes.length_ratio = 1;
    CHECK_FALSE(design::least_length(wishes, {}));
}

}  // namespace hdconj::test::nearest_wishes_cases
