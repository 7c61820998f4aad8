// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic cup in the pipeline: what every slice and every surface must obey whatever the cup does.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "contact/study/place_teeth.hpp"
#include "elastic/bent_cup.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "wavegen/length_kept.hpp"
// behind the envelope's headers, which have a Station of their own
#include "hdconj/elastic_cup.hpp"

namespace hdconj::test::elastic_cup_cases {

namespace {

Scene elastic_scene(std::vector<std::string> overrides = {})
{
    // few contacts: laws hold for any
    for (std::string const key : {"bearing.angles=24", "bearing.circles=7", "slices.count=3"})
        overrides.insert(overrides.begin(), key);
    return read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50-elastic.toml", overrides);
}

}  // namespace

TEST_CASE("solving with the elastic cup enters its stage once and others not at all", "[elastic_cup]")
{
    std::map<Stage, int> count;
    Solution const with = solve(elastic_scene(), [&](Stage stage) { ++count[stage]; });
    CHECK(count[Stage::cup] == 1);
    CHECK(with.plan.has(Stage::cup));
    CHECK(count[Stage::coning] == 1);
    REQUIRE(with.cup != nullptr);
    CHECK(with.circular_spline.outline.size() == 3);
    CHECK(with.check->smallest_clearance > -1e-6);
    REQUIRE_FALSE(with.notes.empty());
    CHECK_THAT(with.notes.front(), ContainsSubstring("coning of the whole toothed ring 1.2"));
    CHECK_THAT(describe(*with.cup, std::nullopt), !ContainsSubstring("coning"));  // of an error that is not known

    std::map<Stage, int> linear;
    Solution const without =
        solve(read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50-coned.toml", {"slices.count=3"}),
              [&](Stage stage) { ++linear[stage]; });
    CHECK(linear.count(Stage::cup) == 0);
    CHECK(without.cup == nullptr);
}

TEST_CASE("a cup and a bearing that nobody asks for change no bit", "[elastic_cup]")
{
    std::vector<std::string> const tables{"bearing.type=elastic",           "bearing.width=6",
                                          "bearing.ring_thickness=1.2",     "flexspline.cup.length=15",
                                          "flexspline.cup.barrel_wall=0.4", "flexspline.cup.bottom=0.5",
                                          "flexspline.cup.corner_radius=2", "flexspline.cup.flange_radius=13",
                                          "flexspline.cup.tooth_width=8"};
    std::map<Stage, int> count;
    Solution const with = solve(builtin_scene(tables), [&](Stage stage) { ++count[stage]; });
    Solution const base = solve(builtin_scene());
    CHECK(count.count(Stage::cup) == 0);
    CHECK(with.circular_spline.outline == base.circular_spline.outline);
}

TEST_CASE("the outline of the elastic cup is one for any number of threads", "[elastic_cup]")
{
    Solution const one = solve(elastic_scene({"solver.threads=1"})), two = solve(elastic_scene({"solver.threads=2"}));
    CHECK(one.circular_spline.outline == two.circular_spline.outline);
}

TEST_CASE("teeth on the elastic cup touch the outlines of their own slices and enter none", "[elastic_cup]")
{
    ContactOptions options;
    options.surfaces = {ToothSurface::tilted, ToothSurface::per_slice};
    std::string const shift = GENERATE("none", "mapped");
    CAPTURE(shift);
    ContactStudy const study = study_contact(elastic_scene({"coning.axial_shift=" + shift}), options);
    REQUIRE(study.cases.size() == 2);
    ContactCase const &tilted = study.cases[0], &own = study.cases[1];
    CHECK(own.backlash_offset < 1e-6);
    for (auto const& slice : own.slices) {
        CHECK(slice.flank.clearance > -1e-6);
        CHECK(slice.flank.clearance < 1e-5);
    }
    CHECK(own.least_side_clearance < 1e-6);
    // one outline cannot follow a cup that cones by a degree
    CHECK(tilted.least_side_clearance > 0.02);
    CHECK(own.state.teeth > tilted.state.teeth);
    // amplitudes grow towards the open end, the middle has about the cam's
    CHECK(own.slices[0].amplitude < own.slices[1].amplitude);
    CHECK(own.slices[1].amplitude < own.slices[2].amplitude);
    CHECK(own.slices[1].amplitude == Approx(0.25).epsilon(0.05));
}

TEST_CASE("a stiffer wave generator cones the cup less, and its slices are more alike", "[elastic_cup]")
{
    auto const spread = [](std::vector<std::string> const& keys) {
        auto const cup = elastic_cup(elastic_scene(keys));
        double const r_m = cup->section().inner_radius + cup->section().ring_wall / 2;
        auto const w = [&](double z) { return wavegen::displacement_at(cup->displacement(9 + z, r_m), 0).w[0]; };
        return w(3.5) - w(-3.5);
    };
    double const free = spread({"bearing.axially=free"});
    double const ring = spread({});
    double const rigid = spread({"!bearing.ring_thickness", "!bearing.axially", "bearing.type=rigid"});
    double const pressed =
        spread({"!bearing.ring_thickness", "!bearing.axially", "bearing.type=rigid", "bearing.fit=0.02"});
    CHECK(free > ring);
    CHECK(ring > rigid);
    CHECK(rigid > pressed);
    CHECK(pressed > 0);
    CHECK(free < 2 * 3.5 * std::tan(0.0293));  // linear coning of one line: 1.677 degrees
}

TEST_CASE("a bearing that is too small for the cup is an error that says so", "[elastic_cup]")
{
    CHECK_THROWS_WITH(elastic_cup(elastic_scene({"bearing.fit=-0.5"})), ContainsSubstring("does not touch the cup"));
}

TEST_CASE("teeth in planes across the elastic cup stand where the displaced wall passes through", "[elastic_cup]")
{
    Scene const scene = elastic_scene({"bearing.angles=48", "bearing.circles=13"});
    test::ConedDrive drive(scene, 3);
    drive.middle.cup = solve(elastic_scene({"bearing.angles=48", "bearing.circles=13", "!slices"})).cup;
    drive.context->cup = drive.middle.cup.get();
    elastic::BentCup const& cup = *drive.middle.cup;
    double const r_m = drive.middle.geometry.r_m, k = static_cast<double>(drive.z_f()) / drive.z_c();
    // height of the wall that lies in the plane z, by bisection, and its displacement there
    auto const in_plane = [&](double phi, double z) {
        double low = z - 0.5, high = z + 0.5;
        for (int i = 0; i < 60; ++i) {
            double const h = (low + high) / 2;
            (h + cup.axial(9 + h, r_m, phi).u_z < z ? low : high) = h;
        }
        auto const at = wavegen::displacement_at(wavegen::length_kept(cup.displacement(9 + low, r_m), r_m), phi);
        return Vec2(r_m + at.w[0], at.v[0]);
    };
    contact::ToothPoses const places = contact::tooth_places(*drive.context, 0, drive.context->maker.z());
    constexpr double step = 1e-5;
    for (int const tooth : {0, 7, 23, 41})
        for (std::size_t slice = 0; slice < 3; ++slice) {
            double const phi = 2 * std::numbers::pi * tooth / drive.z_f(), z = drive.z()[slice];
            Vec2 const at = in_plane(phi, z), slope = (in_plane(phi + step, z) - in_plane(phi - step, z)) / (2 * step);
            double const gamma = (1 - k) * phi, theta = gamma - std::atan2(slope.x() - at.y(), at.x() + slope.y());
            Vec2 const origin(at.x() * std::sin(gamma) + at.y() * std::cos(gamma),
                              at.x() * std::cos(gamma) - at.y() * std::sin(gamma));
            Pose const& pose = places.pose[static_cast<std::size_t>(tooth - places.first) * 3 + slice];
            CAPTURE(tooth, z);
            CHECK((pose.origin - origin).norm() < 2e-5);
            CHECK(std::abs(std::sin(std::atan2(pose.sine, pose.cosine) - theta)) < 5e-5);
        }
}

}  // namespace hdconj::test::elastic_cup_cases
