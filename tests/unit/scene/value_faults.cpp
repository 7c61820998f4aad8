// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes made in code, against the schema of scene files.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/running.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wedm.hpp"
#include "support/catch.hpp"

namespace hdconj::test::value_faults_cases {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct WrongValue
{
    std::string path;
    void (*enter)(Scene&);
    std::string reason;
};

std::vector<WrongValue> const& wrong_values()
{
    static std::vector<WrongValue> const table{
        {"drive.module", [](Scene& s) { s.drive.module = nan; }, "not a finite number"},
        {"drive.circular_spline_teeth", [](Scene& s) { s.drive.circular_spline_teeth = s.drive.flexspline_teeth; },
         "positive multiple of waves"},
        {"flexspline.wall", [](Scene& s) { s.flexspline.wall = -1; }, "must be above 0"},
        {"circular_spline.width", [](Scene& s) { s.circular_spline.width = -1; }, "must be above 0"},
        {"circular_spline.root_clearance", [](Scene& s) { s.circular_spline.root_clearance = nan; }, "not a finite"},
        {"circular_spline.backlash_offset", [](Scene& s) { s.circular_spline.backlash_offset = -0.1; }, "at least 0"},
        {"solver.tolerance", [](Scene& s) { s.solver.tolerance = nan; }, "not a finite number"},
        {"solver.tolerance", [](Scene& s) { s.solver.tolerance = 0; }, "must be above 0"},
        {"solver.tolerance", [](Scene& s) { s.solver.tolerance = -1; }, "must be above 0"},
        {"solver.kinematics", [](Scene& s) { s.solver.kinematics = static_cast<Kinematics>(7); }, "unknown word"},
        {"tilt.angle_deg", [](Scene& s) { s.tilt.emplace().angle = nan; }, "not a finite number"},
        {"slices.count", [](Scene& s) { s.slices.emplace().count = 0; }, "must be at least 1"},
        {"slices.count", [](Scene& s) { s.slices.emplace().count = -3; }, "must be at least 1"},
        {"slices.surface", [](Scene& s) { s.slices.emplace().surface = static_cast<ToothSurface>(7); }, "unknown word"},
        {"bearing.angles", [](Scene& s) { s.bearing.emplace().angles = 0; }, "must be at least 8"},
        {"bearing.circles", [](Scene& s) { s.bearing.emplace().circles = 0; }, "must be at least 2"},
        {"contact.flank_points", [](Scene& s) { s.contact.emplace().flank_points = -4; }, "must be at least 5"},
        {"contact.contact_gap", [](Scene& s) { s.contact.emplace().gap = nan; }, "not a finite number"},
        {"load.edge_radius", [](Scene& s) { s.load.emplace().edge_radius = s.drive.module / 3; }, "leave no land"},
        {"load.harmonics", [](Scene& s) { s.load.emplace().harmonics = 0; }, "must be at least 8"},
        {"load.torque", [](Scene& s) { s.load.emplace().torque = nan; }, "not a finite number"},
        {"errors.profile_form",
         [](Scene& s) {
             s.errors.emplace().profile_form = {{}, {0.1}};
         },
         "row 1 has 0"},
        {"errors.circular_spline.pitch",
         [](Scene& s) {
             s.errors.emplace().circular_spline.emplace().pitch = {0.001, 0.002};
         },
         "2 places for 202"},
        {"errors.wave_generator.cam_deviation",
         [](Scene& s) {
             s.errors.emplace().wave_generator.emplace().cam_deviation = {{}, {1}};
         },
         "row 1 has 0"},
        {"running.speeds", [](Scene& s) { s.running.emplace().speeds = {-1}; }, "must be larger than 0"},
        {"wedm.thickness", [](Scene& s) { s.wedm->thickness = nan; }, "not a finite number"},
    };
    return table;
}

/// A drive with a wire and a torque.
Scene drive_with_all()
{
    return builtin_scene({"load.torque=28", "wedm.wire_diameter=0.1", "wedm.spark_gap=0.006"});
}

}  // namespace

TEST_CASE("a scene made in code is checked as one in a file is, and no study takes a wrong one", "[scene]")
{
    REQUIRE(scene::value_faults(drive_with_all()).empty());
    for (WrongValue const& wrong : wrong_values()) {
        Scene scene = drive_with_all();
        wrong.enter(scene);
        Faults const faults = scene::value_faults(scene);
        auto const found = std::ranges::find(faults, wrong.path, &Fault::path);
        INFO(wrong.path << ": " << describe(faults));
        REQUIRE(found != faults.end());
        CHECK_THAT(found->reason, ContainsSubstring(wrong.reason));
        CHECK_FALSE(found->remedy.empty());
        CHECK(describe(faults).find("--set") == std::string::npos);
        CHECK_THROWS_AS(solve(scene), InputError);
        CHECK_THROWS_AS(study_contact(scene), InputError);
        CHECK_THROWS_AS(study_load(scene), InputError);
        CHECK_THROWS_AS(study_run(scene), InputError);
        CHECK_THROWS_AS(wire_set_ups(scene), InputError);
    }
}

TEST_CASE("every scene of data has values that are right in code too", "[scene]")
{
    for (auto const& file : std::filesystem::directory_iterator(HDCONJ_SOURCE_DIR "/data/scenes"))
        if (file.path().extension() == ".toml") {
            INFO(file.path());
            CHECK(describe(scene::value_faults(read_scene(file.path()))).empty());
        }
}

TEST_CASE("the defaults of a scene made in code are those of a file", "[scene]")
{
    Scene scene;
    for (auto const& table : scene::scene_schema())
        if (table.begin != nullptr)
            table.begin(scene, 0);
    for (auto const& table : scene::scene_schema())
        for (auto const& key : table.keys) {
            INFO(table.path << "." << key.spec.key);
            auto const value = key.member.read != nullptr ? key.member.read(scene) : std::nullopt;
            if (!key.standard || !value || table.path == "drive")
                continue;
            if (auto const* const number = std::get_if<double>(&*key.standard))
                CHECK(std::get<double>(*value) == Approx(*number).epsilon(1e-15).margin(0));
            else
                CHECK(*value == *key.standard);
        }
    CHECK_FALSE(scene.bearing->elastic);
    CHECK(scene.bearing->axially_held);
    CHECK_FALSE(scene.wedm->alternating);
}

}  // namespace hdconj::test::value_faults_cases
