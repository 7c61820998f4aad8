// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of a loaded drive whose flanks differ from their nominal form.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::load_deviation_cases {

namespace {

using Keys = std::vector<std::string>;

/// Few enough slices and points that a torque takes a fraction of a second; side clearance as large as the thesis'
/// play.
LoadStudy at_torque(double torque, Keys const& more = {}, StageObserver const& on_stage = {})
{
    Keys keys{"slices.count=3", "contact.flank_points=80", "circular_spline.backlash_offset=0.09", "bearing.circles=5"};
    keys.insert(keys.end(), more.begin(), more.end());
    LoadOptions options;
    options.torque = torque * newton_metre;
    options.curve = options.errors = false;
    return study_load(builtin_scene(keys), options, on_stage);
}

LoadedState const& only(LoadStudy const& study)
{
    return study.cases.front().curve.front();
}

}  // namespace

TEST_CASE("reliefs enter their stages where the scene has them only", "[load]")
{
    std::map<Stage, int> count;
    auto const counted = [&](Stage stage) { ++count[stage]; };
    LoadStudy const plain = at_torque(15, {}, counted);
    CHECK(count[Stage::tip_relief] + count[Stage::end_relief] == 0);
    LoadStudy const relieved = at_torque(15, {"tip_relief.amount=0.003", "tip_relief.from_height=0.1"}, counted);
    CHECK(count[Stage::tip_relief] > 0);
    CHECK(count[Stage::end_relief] == 0);
    CHECK(only(relieved).twist > only(plain).twist);
}

TEST_CASE("a relief that goes to zero is none", "[load]")
{
    LoadedState const base = only(at_torque(15));
    double last = 1;
    for (char const* amount : {"3e-3", "3e-4", "3e-5", "0"}) {
        CAPTURE(amount);
        std::string const is = std::string(".amount=") + amount;
        LoadedState const relieved = only(
            at_torque(15, {"tip_relief" + is, "tip_relief.from_height=0.1", "end_relief" + is, "end_relief.length=2"}));
        double const apart = std::abs(relieved.twist / base.twist - 1);
        CHECK(apart < last);
        last = std::max(apart / 3, 1e-6);
        CHECK(relieved.gap_mismatch < 1e-6);
        CHECK(relieved.complementarity < 1e-10);
    }
    CHECK(last == 1e-6);
}

TEST_CASE("an end relief is nothing in the middle of the width", "[load]")
{
    LoadStudy const plain = at_torque(15, {"slices.count=1"});
    LoadStudy const relieved = at_torque(15, {"slices.count=1", "end_relief.amount=0.01", "end_relief.length=3"});
    CHECK(plain.cases.front().map.force == relieved.cases.front().map.force);
    CHECK(only(plain).twist == only(relieved).twist);
}

TEST_CASE("an end relief takes force from the ends of the face width", "[load]")
{
    auto const at_ends = [](LoadStudy const& study) {
        LoadMap const& map = study.cases.front().map;
        double ends = 0, all = 0;
        for (std::size_t i = 0; i < map.force.size(); ++i) {
            all += map.force[i];
            ends += i % map.z.size() == 0 || i % map.z.size() + 1 == map.z.size() ? map.force[i] : 0;
        }
        return ends / all;
    };
    double last = 1;
    for (char const* amount : {"0", "0.002", "0.02"}) {
        CAPTURE(amount);
        double const fraction =
            at_ends(at_torque(15, {"slices.count=5", "slices.surface=per-slice",
                                   std::string("end_relief.amount=") + amount, "end_relief.length=3.5"}));
        CHECK(fraction < last);
        last = fraction;
    }
}

}  // namespace hdconj::test::load_deviation_cases
