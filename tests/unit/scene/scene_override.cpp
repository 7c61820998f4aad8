// SPDX-License-Identifier: GPL-3.0-or-later
// --set key.path=value. No name of a test begins with a dash: Catch would take it for an option.
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::scene_override_cases {

namespace {

Fault only_fault(std::vector<std::string> const& overrides)
{
    auto const reading = examine_scene(builtin_scene_text(), "scene", {}, overrides);
    INFO(describe(reading.faults));
    REQUIRE(reading.faults.size() == 1);
    return reading.faults.front();
}

}  // namespace

TEST_CASE("with --set a key changes", "[scene]")
{
    CHECK(builtin_scene({"flexspline.wall=0.8"}).flexspline.wall == 0.8);
    CHECK(builtin_scene({"flexspline.wall = 0.8"}).drive.module == 0.25);
    CHECK(builtin_scene({"drive.flexspline_teeth=300", "drive.circular_spline_teeth=302"}).drive.flexspline_teeth ==
          300);
    CHECK(builtin_scene({"solver.kinematics=first-order"}).solver.kinematics == Kinematics::first_order);
    CHECK(builtin_scene({"solver.kinematics=material"}).solver.kinematics == Kinematics::material);
    CHECK(builtin_scene({"solver.kinematics=\"first-order\""}).solver.kinematics == Kinematics::first_order);
    CHECK(builtin_scene({"drive.name=my drive (2)"}).drive.name == "my drive (2)");
    CHECK(builtin_scene({"flexspline.profile.concave_offset=0.7"}).flexspline.profile.number("concave_offset") == 0.7);
}

TEST_CASE("the last --set of a key holds", "[scene]")
{
    CHECK(builtin_scene({"flexspline.wall=0.8", "flexspline.wall=0.9"}).flexspline.wall == 0.9);
}

TEST_CASE("with --set tables that are not there are made", "[scene]")
{
    Scene const scene = builtin_scene({"tilt.angle_deg=0", "slices={count = 3, surface = \"ruled\"}"});
    REQUIRE((scene.tilt && scene.slices));
    CHECK(scene.tilt->line == 0);
    CHECK(scene.slices->surface == ToothSurface::ruled);
}

TEST_CASE("an exclamation mark in --set removes", "[scene]")
{
    CHECK_FALSE(builtin_scene({"!circular_spline.inner_radius"}).circular_spline.inner_radius.has_value());
    CHECK_FALSE(builtin_scene({"tilt.angle_deg=1", "!tilt"}).tilt.has_value());
    CHECK(builtin_scene({"!solver"}).solver.tolerance == 1e-6);
}

TEST_CASE("the text after --set is the scene that was judged", "[scene]")
{
    Scene const changed = builtin_scene({"flexspline.wall=0.8", "tilt.angle_deg=0.1", "drive.name=new"});
    Scene const again = parse_scene(changed.text, "again");
    CHECK(again.flexspline.wall == 0.8);
    CHECK(again.drive.name == "new");
    REQUIRE(again.tilt);
    CHECK(again.tilt->angle == changed.tilt->angle);
    CHECK(again.flexspline.profile.number("convex_radius") == changed.flexspline.profile.number("convex_radius"));
    CHECK(again.solver.tolerance == changed.solver.tolerance);
    CHECK(changed.text.find("0.2701\n") != std::string::npos);
    CHECK(changed.text.find("[drive]") < changed.text.find("[flexspline]"));
    CHECK(parse_scene(again.text, "again", {}, {"flexspline.wall=0.8"}).text == changed.text);
}

TEST_CASE("faults of --set say so", "[scene]")
{
    auto const wrong_value = only_fault({"flexspline.wall=-1"});
    CHECK(wrong_value.origin == "--set");
    CHECK(wrong_value.path == "flexspline.wall");
    CHECK(wrong_value.value == "-1");
    CHECK(wrong_value.line == 0);
    CHECK(only_fault({"wedm.passes=[0.02, 0.03, 0]"}).value == "[ 0.02, 0.03, 0 ]");
    auto const wrong_key = only_fault({"flexspline.wal=1"});
    CHECK(wrong_key.origin == "--set");
    auto const crossed = only_fault({"drive.circular_spline_teeth=203"});
    CHECK(crossed.origin == "--set");
    CHECK(only_fault({"drive=3", "!solver"}).origin == "--set");
}

TEST_CASE("a misspelt key of --set is judged as the key that it means", "[scene]")
{
    auto const wrong_key = only_fault({"wave_generator.radial_deformaton=0.26"});
    CHECK(wrong_key.remedy == "write radial_deformation");
    auto const both = examine_scene(builtin_scene_text(), "scene", {}, {"wave_generator.radial_deformaton=-3"}).faults;
    REQUIRE(both.size() == 2);
    CHECK(both.back().path == "wave_generator.radial_deformation");
    CHECK(both.back().reason == "must be above 0");
}

TEST_CASE("numbers without brackets are rows where rows have one number", "[scene]")
{
    std::vector<std::string> const wire = {"wedm.wire_diameter=0.1", "wedm.spark_gap=0.006"};
    auto with = [&wire](std::string const& passes) {
        auto all = wire;
        all.push_back("wedm.passes=" + passes);
        return builtin_scene(all).wedm->stock;
    };
    CHECK(with("[0.02, 0]") == with("[[0.02], [0]]"));
}

TEST_CASE("what is no override is refused", "[scene]")
{
    for (std::string const bad : {"flexspline.wall", "=1", "flexspline..wall=1", ".wall=1", "flexspline.wall.=1",
                                  "flexspline.wall=", "flexspline wall=1", "a.b.c.d.e.f.g.h.i=1", "drive.module.x=1",
                                  "!nothing", "!", "", "!flexspline..wall", "flexspline.wall=[1", "flexspline.wall={",
                                  "flexspline.wall=\"0.7", "flexspline.wall=1\n[tilt]\nangle_deg=1"}) {
        INFO(bad);
        auto const fault = only_fault({bad});
        CHECK(fault.origin == "--set");
        CHECK_FALSE(fault.path.empty());
        CHECK_FALSE(fault.reason.empty());
        CHECK_FALSE(fault.remedy.empty());
    }
}

TEST_CASE("bad overrides are reported together with what is wrong in the file", "[scene]")
{
    auto const reading = examine_scene("[drive]\nmodule = 0,25\n", "scene", {}, {"nonsense", "also nonsense"});
    CHECK(reading.faults.size() == 3);
}

}  // namespace hdconj::test::scene_override_cases
