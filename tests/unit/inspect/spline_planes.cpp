// SPDX-License-Identifier: GPL-3.0-or-later
// A circular spline measured between the slices of its scene: points of its surface have no deviation there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::spline_planes_cases {
namespace {

constexpr double exact = 1e-9;  // [mm]

Scene coned(std::vector<std::string> changes)
{
    changes.emplace_back("solver.threads=1");
    auto const reading = examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50-coned.toml", changes);
    REQUIRE(reading.faults.empty());
    return reading.scene;
}

/// The scene in one plane, without a cone.
Scene plane(std::vector<std::string> changes)
{
    changes.insert(changes.end(), {"!coning", "!slices"});
    auto const reading = examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50-coned.toml", changes);
    REQUIRE(reading.faults.empty());
    return reading.scene;
}

/// The walls of some spaces with the outline @p points that are of the kind @p kind, in the plane @p z.
void add_points(PointFile& file, std::vector<Vec2> const& points, std::vector<OutlinePiece> const& pieces, double z,
                int teeth, std::string_view kind = "flank")
{
    file.has_z = true;
    for (int const tooth : {0, 77})
        for (OutlinePiece const& piece : pieces)
            for (std::size_t i = piece.first; piece.kind == kind && i <= piece.last; i += 7)
                file.points.push_back({turned_clockwise(points[i], 2 * std::numbers::pi * tooth / teeth), z, 0,
                                       std::nullopt, static_cast<int>(file.points.size()) + 2});
}

void check_exact(Scene const& scene, PointFile const& file)
{
    Inspection const found =
        inspect_points(scene, file, {InspectedPart::circular_spline, std::nullopt, 0, Registration::datum});
    REQUIRE(found.points.size() == file.points.size());
    double worst = 0;
    for (PointDeviation const& point : found.points)
        if (point.fate == PointFate::used)
            worst = std::max(worst, std::abs(point.deviation));
    CHECK(worst < exact);
    // points at the ends of a flank are beside it
    CHECK(static_cast<double>(found.beside + found.strays) < 0.03 * static_cast<double>(file.points.size()));
    double stated = 0;
    for (NominalFigures const& nominal : found.nominal)
        stated = std::max(stated, nominal.error);
    CHECK(worst <= stated);
}

}  // namespace

TEST_CASE("between slices the per-slice surface is the conjugate outline of the measured plane", "[inspect]")
{
    Scene const scene = coned({"slices.count=3", "coning.axial_shift=\"none\""});
    std::string const tip =
        fmt::format("circular_spline.inner_radius={}", solve(scene).geometry.circular_spline_inner_radius);
    PointFile file{"ring", {}, true};
    for (double const z : {-2.9, 0.6, 1.3}) {
        constexpr double apex = -8.57;
        double const w0 = 0.25 * (z - apex) / -apex;
        Solution const there = solve(plane({"wave_generator.radial_deformation=" + std::to_string(w0), tip}));
        // six digits of w0 are written: the plane is where the amplitude is that
        double const written = there.geometry.w0 * -apex / 0.25 + apex;
        add_points(file, there.circular_spline.outline.front(), there.circular_spline.pieces, written,
                   scene.drive.circular_spline_teeth);
    }
    check_exact(scene, file);
}

TEST_CASE("a point off its plane is read against the outline of its own height", "[inspect]")
{
    Scene const scene = coned({"slices.count=3", "coning.axial_shift=\"none\""});
    std::string const tip =
        fmt::format("circular_spline.inner_radius={}", solve(scene).geometry.circular_spline_inner_radius);
    PointFile file{"ring", {}, true};
    auto const add_height = [&](double z) {
        constexpr double apex = -8.57;
        double const w0 = 0.25 * (z - apex) / -apex;
        Solution const there = solve(plane({fmt::format("wave_generator.radial_deformation={:.12f}", w0), tip}));
        add_points(file, there.circular_spline.outline.front(), there.circular_spline.pieces, z,
                   scene.drive.circular_spline_teeth);
    };
    for (double const z : {0.565, 0.583, 0.6, 0.618, 0.63})
        add_height(z);
    InspectOptions const options{InspectedPart::circular_spline, std::nullopt, 0, Registration::datum};
    Inspection const found = inspect_points(scene, file, options);
    CHECK(found.nominal.size() == 1);
    CHECK(found.points.size() + found.repeated == file.points.size());
    constexpr double second_order = 1e-4;  // [mm]; the outline moves 25 times as far
    for (PointDeviation const& point : found.points)
        if (point.fate == PointFate::used && std::abs(point.deviation) > second_order)
            FAIL_CHECK("z " << point.line << " deviation " << point.deviation);
    for (std::size_t i = 0; i < file.points.size(); ++i)
        file.points[i].z = std::lerp(0.53, 0.66, static_cast<double>(i) / static_cast<double>(file.points.size() - 1));
    CHECK_THROWS_WITH(inspect_points(scene, file, options),
                      ContainsSubstring("the points of one plane run from z = 0.53 to 0.66 mm, and the outline of "
                                        "this part changes with z"));
}

TEST_CASE("between slices a draft is the side clearance of its height", "[inspect]")
{
    Scene const scene = coned({"!coning", "slices.count=2", "slices.surface=\"tilted\"", "tilt.kind=\"draft\"",
                               "tilt.angle_deg=0.4", "circular_spline.backlash_offset=0.001"});
    PointFile file{"ring", {}, true};
    for (double const offset : {0.009, 0.021}) {
        double const z = (offset - 0.001) / std::tan(0.4 * deg);
        Solution const there = solve(plane({"circular_spline.backlash_offset=" + std::to_string(offset)}));
        add_points(file, there.circular_spline.outline.front(), there.circular_spline.pieces, z,
                   scene.drive.circular_spline_teeth);
    }
    check_exact(scene, file);
}

TEST_CASE("between slices a radial tilt moves the outline outward", "[inspect]")
{
    using Keys = std::vector<std::string>;  // without slices the ring is tilted all the same
    Keys keys = GENERATE(Keys{"slices.count=2", "slices.surface=\"tilted\""}, Keys{"!slices", "!coning"});
    keys.insert(keys.end(), {"tilt.kind=\"radial\"", "tilt.angle_deg=0.77"});
    Scene const scene = coned(keys);
    Solution const middle = solve(plane({}));
    PointFile file{"ring", {}, true};
    for (double const z : {-1.7, 2.2}) {
        std::vector<Vec2> moved = middle.circular_spline.outline.front();
        for (Vec2& p : moved)
            p += z * std::tan(0.77 * deg) * p.normalized();
        add_points(file, moved, middle.circular_spline.pieces, z, scene.drive.circular_spline_teeth);
    }
    check_exact(scene, file);
}

TEST_CASE("between slices a ruled surface has straight lines", "[inspect]")
{
    // lines of two contact zones lie side by side: which points they join must not depend on how finely either is drawn
    auto const change = GENERATE(as<std::string>{}, "wave_generator.radial_deformation=0.25",
                                 "wave_generator.radial_deformation=0.24", "circular_spline.backlash_offset=0.004");
    CAPTURE(change);
    Scene const scene = coned({"slices.count=2", "slices.surface=\"ruled\"", "coning.axial_shift=\"none\"", change});
    Solution const ends = solve(scene);
    auto const& spline = ends.circular_spline;
    PointFile file{"ring", {}, true};
    for (double const z : {-3.1, 1.1}) {
        std::vector<Vec2> between = spline.outline[0];
        for (std::size_t i = 0; i < between.size(); ++i)
            between[i] += (z - spline.z[0]) / (spline.z[1] - spline.z[0]) * (spline.outline[1][i] - between[i]);
        add_points(file, between, spline.pieces, z, scene.drive.circular_spline_teeth);
    }
    check_exact(scene, file);
}

TEST_CASE("a tilted ring whose walls corners alone make is known in each plane", "[inspect]")
{
    auto const scene = [](std::vector<std::string> sets) {
        sets.insert(sets.end(),
                    {"tilt.angle_deg=-0.5", "flexspline.profile.addendum=0.12",
                     "wave_generator.radial_deformation=0.15", "circular_spline.width=7", "solver.threads=1"});
        return read_scene(HDCONJ_SOURCE_DIR "/data/scenes/straight.toml", sets);
    };
    Solution const fine = solve(scene({"slices.count=9", "slices.surface=tilted", "solver.tolerance=1e-8"}));
    auto const& spline = fine.circular_spline;
    REQUIRE(std::ranges::none_of(spline.pieces, [](OutlinePiece const& piece) { return piece.kind == "flank"; }));
    PointFile file;
    for (std::size_t const k : {std::size_t{0}, std::size_t{3}, std::size_t{4}, std::size_t{8}})
        add_points(file, spline.outline[k], spline.pieces, spline.z[k], fine.scene.drive.circular_spline_teeth,
                   "corner");
    check_exact(scene({}), file);
}

}  // namespace hdconj::test::spline_planes_cases
