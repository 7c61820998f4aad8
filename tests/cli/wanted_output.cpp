// SPDX-License-Identifier: GPL-3.0-or-later
// What solve writes of a neutral curve that it has found, and what it says where there is none.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wanted_curve.hpp"
#include "hdconj/wavegen/table_cam.hpp"
#include "hdconj_run.hpp"
#include "support/catch.hpp"

namespace hdconj::test::wanted_output_cases {

namespace {

using test::hdconj_run;
using test::TemporaryFolder;

std::string const scene = std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50-wanted.toml";
std::string const quoted = "'" + scene + "' ";

/// Displacement of type-50's own curve, r_0 + 0.25 cos(2 u) - r_m, of which the scene gives that on the major axis.
double own_displacement(double u)
{
    return 0.24743281327 - 0.25 * (1 - std::cos(2 * u));
}

/// The curve for the teeth of a solved drive, with @p changes to the scene.
WantedCurve found_for_teeth_of(Solution const& drive, TemporaryFolder const& folder, std::vector<std::string> changes)
{
    write_spline_tooth(drive, folder / "type-50-wanted-tooth.csv");
    // the file's head says where the tooth stands
    std::string const head = content(folder / "type-50-wanted-tooth.csv");
    std::string const key = "inner_radius = ";
    std::size_t const from = head.find(key) + key.size();
    changes.push_back("circular_spline.inner_radius=" + head.substr(from, head.find(' ', from) - from));
    return find_neutral_curve(parse_scene(content(scene), "wanted", folder.path(), changes));
}

}  // namespace

TEST_CASE("the curve of a scene is that of the drive whose teeth it has", "[wanted]")
{
    WantedCurve const found = find_neutral_curve(read_scene(scene));
    for (WantedCurveRow const& row : found.rows) {
        double const off = std::abs(row.displacement - own_displacement(row.u));
        INFO(to_deg(row.u) << " deg");
        CHECK(off < 1e-3);
        if (row.touching)
            CHECK(off < row.error + 1e-12);
    }
    CHECK(found.residual < 1e-8);
    CHECK(found.smallest_clearance > -1e-8);
    CHECK(std::abs(found.length_error) < 1e-9);
    CHECK(to_deg(found.touch_begin) == Approx(1.55).margin(0.05));
    CHECK(to_deg(found.touch_end) == Approx(59.07).margin(0.05));
    // E c w0 (n^2 - 1)/r_m^2 to first order, from both axes
    CHECK(found.bending_stress == Approx(91).margin(2));
}

TEST_CASE("teeth of the first-order motion give its cam back", "[wanted]")
{
    TemporaryFolder const folder;
    std::vector<std::string> changes{"solver.kinematics=first-order"};
    Scene const known = parse_scene(builtin_scene_text(), "type-50", {}, changes);
    changes.push_back("wave_generator.major_displacement=0.25");
    WantedCurve const found = found_for_teeth_of(solve(known), folder, changes);
    CHECK(found.touch_end == found.parting);
    CHECK(found.touch_end > 50 * deg);
    for (WantedCurveRow const& row : found.rows)
        if (row.touching)
            CHECK(std::abs(row.displacement - 0.25 * std::cos(2 * row.u)) < std::max(row.error, 1e-9));
    CHECK(found.geometry.r_0 == found.geometry.r_m);
}

TEST_CASE("the error of a curve holds for a cam that breaks on the major axis", "[wanted]")
{
    TemporaryFolder const folder;
    std::vector<double> angles, rows;
    std::ofstream table(folder / "cam.csv");
    table.precision(17);
    table << "angle_deg,w_mm\n";
    for (int i = 0; i < 18; ++i) {
        angles.push_back(10 * i * deg);
        rows.push_back(0.25 * std::cos(2 * angles.back()));
        table << 10 * i << "," << rows.back() << "\n";
    }
    table.close();
    wavegen::TableCam const cam(angles, rows, 2);
    Solution const known = solve(parse_scene(
        builtin_scene_text(), "type-50", folder.path(),
        {"wave_generator.family=table", "wave_generator.file=cam.csv", "!wave_generator.radial_deformation"}));
    double const raised = known.geometry.r_0 - known.geometry.r_m;
    WantedCurve const found = found_for_teeth_of(
        known, folder, {"wave_generator.major_displacement=" + fmt::format("{:.17g}", raised + cam(0.0).w)});
    double most = 0;
    for (WantedCurveRow const& row : found.rows)
        if (row.touching) {
            double const off = std::abs(row.displacement - (raised + cam(row.u).w));
            INFO(to_deg(row.u) << " deg");
            CHECK(off < row.error + 1e-12);
            most = std::max(most, off);
        }
    CHECK(most > 1e-7);  // no flank tells of the break
}

TEST_CASE("a curve that would bend too much leaves the flanks", "[wanted]")
{
    // a tooth that is 0.1 um thicker: an error of the flanks grows to some um at the end of the mesh
    WantedCurve const found = find_neutral_curve(read_scene(scene, {"flexspline.profile.convex_offset=0.0981"}));
    CHECK(found.touch_end < found.parting);
    CHECK(found.touch_end > 20 * deg);
    CHECK(found.least_curvature > 0);
    REQUIRE_FALSE(found.notes.empty());
    CHECK(contains(found.notes[1], "leaves the flanks at"));
}

TEST_CASE("flanks moved by their error move the closed curve's figures by no more than theirs", "[wanted]")
{
    auto const found = [](char const* offset) {
        return find_neutral_curve(read_scene(scene, {std::string("flexspline.profile.convex_offset=") + offset}));
    };
    WantedCurve const given = found("0.0982");
    CHECK(given.flank_error == 1e-8);
    Scene made = given.scene;
    made.solver.tolerance = 0;  // by code, which no reader has checked
    CHECK_THROWS_AS(find_neutral_curve(made), InputError);
    for (char const* moved : {"0.09819999", "0.09820001"}) {
        INFO(moved);
        WantedCurve const other = found(moved);
        CHECK(std::abs(other.bending_stress - given.bending_stress) < given.stress_error);
        CHECK(std::abs(other.least_curvature - given.least_curvature) < given.curvature_error);
        CHECK(std::abs(other.smallest_clearance - given.smallest_clearance) < given.clearance_error);
        CHECK(std::abs(other.touch_end - given.touch_end) < given.touch_end_error);
    }
}

TEST_CASE("summary, JSON and files of a wanted neutral curve", "[program][wanted]")
{
    TemporaryFolder const folder;
    auto const run =
        hdconj_run("solve " + quoted + "--json -o a.h5 --cam cam.csv --inner-surface inner.csv --completed done.toml",
                   folder.path());
    INFO(run.err);
    REQUIRE(run.status == 0);
    auto const json = nlohmann::json::parse(run.out);
    CHECK(json["format"] == "hdconj-neutral-curve");
    CHECK(json["touch_end_deg"].get<double>() == Approx(59.07).margin(0.05));
    CHECK(json["files"].contains("inner_surface"));
    CHECK(json["rows"].size() == 181);
    auto const text = hdconj_run("solve " + quoted + "-o b.h5", folder.path());
    CHECK(contains(text.out, "given: both teeth; computed: the neutral curve"));
    CHECK(contains(text.out, "bending stress"));
    // the completed drive is a scene as any, on the same curve
    CHECK(hdconj_run("check done.toml", folder.path()).status == 0);
    Solution const solution = solve(read_scene(folder.path() / "done.toml"));
    CHECK(solution.geometry.r_0 == Approx(json["r_0_mm"].get<double>()).margin(1e-9));
    CHECK(solution.geometry.w0 == Approx(json["w0_mm"].get<double>()).margin(1e-9));
    CHECK(std::filesystem::exists(folder / "done-cam.csv"));
    CHECK(content(folder / "cam.csv") == content(folder / "done-cam.csv"));
}

TEST_CASE("the cam's surface lies the given distance inside the curve", "[wanted]")
{
    WantedCurve const found = find_neutral_curve(read_scene(scene));
    REQUIRE(found.inner_surface.size() == found.neutral_curve.size());
    CHECK(found.inner_distance == 4.85);
    for (std::size_t i = 0; i < found.inner_surface.size(); i += 7) {
        // no point of the neutral curve is nearer
        double nearest = 1e9;
        for (Vec2 const& p : found.neutral_curve)
            nearest = std::min(nearest, (p - found.inner_surface[i]).norm());
        CHECK(nearest == Approx(4.85).margin(1e-9));
    }
}

TEST_CASE("where flanks part at once the place is told", "[program][wanted]")
{
    TemporaryFolder const folder;
    // other teeth: their flanks touch for a few degrees, and no curve of bounded curvature goes on from there
    auto const run =
        hdconj_run("solve " + quoted + "-o a.h5 --set flexspline.profile.convex_radius=0.3", folder.path());
    CHECK(run.status == 1);
    CHECK(contains(run.err, "neutral curve: "));
    CHECK(contains(run.err, "stop touching"));
    CHECK(contains(run.err, "deg from the major axis"));
    CHECK_FALSE(std::filesystem::exists(folder / "a.h5"));
}

TEST_CASE("options of one problem have no place in the other", "[program][wanted]")
{
    TemporaryFolder const folder;
    auto const dxf = hdconj_run("solve " + quoted + "--dxf a.dxf", folder.path());
    CHECK(dxf.status == 2);
    CHECK(contains(dxf.err, "--completed"));
    auto const cam = hdconj_run("solve --cam cam.csv", folder.path());
    CHECK(cam.status == 2);
    CHECK(contains(cam.err, "wanted"));
    std::string const narrow = quoted + "--set '!circular_spline.width' ";
    for (std::string const verb : {"contact", "load", "run", "wedm", "report", "export --vtu a.vtu", "accuracy"}) {
        auto const other = hdconj_run(verb + " " + narrow, folder.path());
        INFO(verb << ": " << other.err);
        CHECK(other.status == 2);
        CHECK(contains(other.err, "1 fault"));
        CHECK(contains(other.err, "only solve and check take such a scene"));
    }
}

TEST_CASE("the circular spline's tooth of a solved drive is a file of points", "[program][wanted]")
{
    TemporaryFolder const folder;
    REQUIRE(hdconj_run("solve -q -o a.h5 --spline-tooth tooth.csv", folder.path()).status == 0);
    CHECK(content(folder / "tooth.csv") ==
          content(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50-wanted-tooth.csv"));
}

TEST_CASE("a file of the circular spline's tooth says what it leaves out", "[wanted]")
{
    TemporaryFolder const folder;
    Solution const drive = solve(read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/cycloid.toml"));
    write_spline_tooth(drive, folder / "tooth.csv");
    std::string const head = content(folder / "tooth.csv");
    auto const number_after = [&](std::string const& words) {
        REQUIRE(contains(head, words));
        return std::stod(head.substr(head.find(words) + words.size()));
    };
    // the piece ends beyond the tip circle
    CHECK(number_after("goes on for ") ==
          Approx(number_after("inner_radius = ") - drive.geometry.circular_spline_inner_radius).margin(1e-3));
    CHECK(number_after("at the tip and for ") > 0);
}

}  // namespace hdconj::test::wanted_output_cases
