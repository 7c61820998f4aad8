// SPDX-License-Identifier: GPL-3.0-or-later
// Plans of load and run: they refuse what the verbs refuse.
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/running.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

namespace hdconj::test::refused_plan_cases {
namespace {

Faults faults_of_plan(Scene const& scene, std::string const& verb)
{
    try {
        (void)plan_of(scene, verb, "--for");
    } catch (InputError const& error) {
        return error.faults();
    }
    return {};
}

}  // namespace

TEST_CASE("plans of load and run refuse a cup and a bearing that do not fit, each once", "[load]")
{
    REQUIRE(faults_of_plan(builtin_scene({"load.torque=20"}), "load").empty());
    REQUIRE(faults_of_plan(builtin_scene({"load.torque=20"}), "run").empty());
    for (auto const& [setting, named] :
         {std::pair<std::string, std::string>{"flexspline.cup.length=8", "flexspline.cup.length"},
          {"flexspline.cup.flange_radius=30", "flexspline.cup.flange_radius"},
          {"flexspline.cup.corner_radius=24", "flexspline.cup.flange_radius or corner_radius"},
          {"flexspline.cup.corner_radius=0.3", "flexspline.cup.corner_radius"},
          {"flexspline.cup.rear_ramp=0", "flexspline.cup.rear_ramp"},
          {"flexspline.cup.front_land=0.1", "flexspline.cup.front_land"},
          {"bearing.width=40", "bearing.width of at most 12, or a longer flexspline.cup.length"},
          {"bearing.ring_thickness=30", "such as 1.2"},
          {"circular_spline.width=8.5", "flexspline.cup.tooth_width"}}) {
        INFO(setting);
        Scene const scene = builtin_scene({"load.torque=20", setting});
        REQUIRE(check_scene(scene).empty());
        for (Faults const& faults :
             {check_load(scene, {}), faults_of_plan(scene, "load"), check_run(scene), faults_of_plan(scene, "run")}) {
            REQUIRE(faults.size() == 1);
            CHECK_THAT(faults.front().remedy, ContainsSubstring(named));
        }
        CHECK(faults_of_plan(scene, "solve").empty());
        // without a torque run needs no cup; load takes one that comes with the command
        Scene const unloaded = builtin_scene({"!load.torque", setting});
        CHECK(faults_of_plan(unloaded, "run").empty());
        CHECK(faults_of_plan(unloaded, "load").size() == 1);
    }
    Scene const twice = builtin_scene({"load.torque=20", "load.harmonics=400", "bearing.width=40"});
    CHECK(faults_of_plan(twice, "load").size() == 2);
    // what the scene itself shows is said with its faults
    Scene const bent =
        builtin_scene({"load.torque=20", "coning.model=elastic", "coning.bottom_to_middle=9", "bearing.width=40"});
    CHECK(check_scene(bent).size() == 1);
    CHECK(check_load(bent, {}).empty());
}

TEST_CASE("more rigid balls than the ring's harmonics tell apart are refused with all ways out", "[load]")
{
    auto const remedy = [](char const* teeth, std::string const& balls, char const* more = "bearing.fit=0") {
        Scene const scene = builtin_scene(
            {"load.torque=20", std::string("drive.flexspline_teeth=") + teeth, "bearing.balls=" + balls, more});
        for (Fault const& each : check_load(scene, {}))
            if (each.path == "bearing.balls")
                return each.reason + ": " + each.remedy;
        return std::string();
    };
    CHECK_THAT(remedy("160", "400"), ContainsSubstring("tell apart, 202: write load.harmonics = 200, or leave") &&
                                         ContainsSubstring("continuous row"));
    CHECK(remedy("160", "400", "load.harmonics=200").empty());
    CHECK_FALSE(remedy("160", "400", "load.harmonics=199").empty());
    CHECK(remedy("160", "202").empty());
    CHECK_THAT(remedy("160", "203"), ContainsSubstring("load.harmonics = 101,"));
    CHECK(remedy("160", "203", "load.harmonics=101").empty());
    CHECK_THAT(remedy("200", "400"), ContainsSubstring("202: leave"));  // its teeth tell no more apart
    CHECK(remedy("160", "400", "bearing.radial_stiffness=2000").empty());
}

}  // namespace hdconj::test::refused_plan_cases
