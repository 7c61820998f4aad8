// SPDX-License-Identifier: GPL-3.0-or-later
// What `inspect` prints and writes, what it refuses, and its registrations against SciPy.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bad_commands.hpp"
#include "support/measured_ring.hpp"
#include "support/not_tried.hpp"
#include "support/read_hdf5.hpp"

namespace hdconj::test::inspect_output_cases {

using nlohmann::json;

namespace {

std::string const ring = "'" HDCONJ_SOURCE_DIR "/data/measured/flexspline-teeth.csv' ";
std::string const type50 = "'" HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml' ";

}  // namespace

TEST_CASE("inspect finds turn, shift and dust of the measured teeth that come with the program", "[inspect]")
{
    TemporaryFolder const folder;
    auto const done = hdconj_run("inspect " + type50 + ring + "--probe 0.05 --deviations d.csv --json", folder.path());
    REQUIRE(done.status == 0);
    auto const found = json::parse(done.out);
    CHECK(found.at("format") == "hdconj-inspection");
    CHECK(found.at("points") == 448);
    CHECK(found.at("points_stray") == 1);
    // the errors of the teeth are drawn with 1.2 um, those of fourteen teeth move the part by about 1.2/sqrt(7)
    auto const& placement = found.at("placement");
    CHECK(std::abs(placement.at("turn_deg").get<double>() - 0.18) < 0.002);
    CHECK(std::abs(placement.at("shift_x_um").get<double>() - 4.0) < 1.2);
    CHECK(std::abs(placement.at("shift_y_um").get<double>() + 2.5) < 1.2);
    CHECK(std::abs(found.at("noise_um").get<double>() - 0.25) < 0.03);
    for (auto const& side : found.at("sides")) {
        double const slope = side.at("flank") == "right" ? 2.0 : 2.8;
        CHECK(std::abs(side.at("mean_profile_slope_um").get<double>() - slope) < 0.15);
        CHECK(std::abs(side.at("mean_profile_crowning_um").get<double>() - 0.8) < 0.2);
        CHECK(side.at("pitch").at("pitches") == 4);
    }
    CHECK(found.at("flanks").size() == 28);
    CHECK(found.at("teeth").front().at("tooth") == 1);
    auto const table = content(folder / "d.csv");
    CHECK(std::count(table.begin(), table.end(), '\n') == 449);
    CHECK_THAT(table, ContainsSubstring(",stray\n"));
}

TEST_CASE("inspect prints every figure of --json, and takes the built-in drive without a scene", "[inspect]")
{
    auto const text = hdconj_run("inspect " + ring + "--probe 0.05");
    REQUIRE(text.status == 0);
    auto const found = json::parse(hdconj_run("inspect " + type50 + ring + "--probe 0.05 --json").out);
    auto const shown = [](json const& value) {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.3f um", value.get<double>());
        return std::string(digits);
    };
    for (auto const& side : found.at("sides")) {
        CHECK_THAT(text.out, ContainsSubstring(shown(side.at("mean_profile_slope_um"))));
        CHECK_THAT(text.out, ContainsSubstring(shown(side.at("pitch").at("total_pitch_deviation_um"))));
    }
    CHECK_THAT(text.out, ContainsSubstring(shown(found.at("planes").front().at("runout_um"))));
    CHECK_THAT(text.out, ContainsSubstring("an involute's"));
    CHECK(hdconj_run("inspect --quiet " + ring + "--probe 0.05").out.empty());
}

TEST_CASE("inspect with one thread and with two prints the same bits", "[inspect]")
{
    auto const one = hdconj_run("inspect " + ring + "--probe 0.05 --json --threads 1");
    CHECK(one.status == 0);
    CHECK(one.out == hdconj_run("inspect " + ring + "--probe 0.05 --json --threads 2").out);
}

TEST_CASE("inspect writes result, chart and a scene of the measured tooth that solve takes", "[inspect]")
{
    TemporaryFolder const folder;
    bool const draws = !is_missing("gnuplot");
    auto const done =
        hdconj_run("inspect " + type50 + ring + "--probe 0.05 --json -o a.h5 --as-tooth cut.toml --pitch p.csv" +
                       (draws ? " --picture a.svg" : ""),
                   folder.path());
    INFO(done.err);
    REQUIRE(done.status == 0);
    auto const found = json::parse(done.out);
    auto const file = open_file(folder / "a.h5");
    auto const slopes = read(file, "/inspection/flanks/profile_slope").values;
    REQUIRE(slopes.size() == found.at("flanks").size());
    for (std::size_t i = 0; i < slopes.size(); ++i)
        CHECK(slopes[i] * 1e3 == Approx(found.at("flanks")[i].at("profile_slope_um").get<double>()).margin(1e-9));
    CHECK(read(file, "/inspection/points/deviation").values.size() == 448);
    if (draws)
        CHECK_THAT(content(folder / "a.svg"), ContainsSubstring("</svg>") && ContainsSubstring("runout"));
    CHECK(std::filesystem::exists(folder / "cut-tooth.csv"));
    CHECK_THAT(content(folder / "p.csv"), ContainsSubstring("tooth,place [um],uncertainty [um]\n1,"));
    auto const some = hdconj_run("check " + type50 + "--set 'errors.flexspline.pitch=\"p.csv\"'", folder.path());
    CHECK(some.status == 2);  // the file has 14 teeth
    CHECK_THAT(some.err, ContainsSubstring("errors.flexspline.pitch"));
    auto const solved = hdconj_run("solve cut.toml --json -o cut.h5", folder.path());
    INFO(solved.err);
    REQUIRE(solved.status == 0);
    // a cut tooth that is some micrometres off makes a space that is as much off
    auto const nominal = hdconj_run("solve " + type50 + "--json -o b.h5", folder.path());
    double const depth = json::parse(solved.out).at("geometry").at("space_depth_mm");
    CHECK(std::abs(depth - json::parse(nominal.out).at("geometry").at("space_depth_mm").get<double>()) < 0.01);
}

TEST_CASE("a mean tooth that solve refuses or that makes no flank is not written", "[inspect]")
{
    TemporaryFolder const folder;
    MeasuredRing part;
    part.measured = {0, 1, 2};
    // the flanks lean until they cross below the tip
    part.left.assign(3, {0, 0.12, 0, 0});
    part.right.assign(3, {0, 0.12, 0, 0});
    designs::Draws draws(1);
    std::string points = "x,y\n";
    for (PartPoint const& point : points_of(part, draws).points)
        points += fmt::format("{},{}\n", point.where.x(), point.where.y());
    write(folder / "lean.csv", points);
    auto const done = hdconj_run("inspect lean.csv --register datum --as-tooth cut.toml", folder.path());
    INFO(done.out << done.err);
    CHECK(done.status == 1);
    for (char const* words : {"as-tooth: cut.toml: is not written", "cannot be used", "measure more teeth"})
        CHECK_THAT(done.err, ContainsSubstring(words));
    CHECK_FALSE(std::filesystem::exists(folder / "cut.toml"));
    CHECK_FALSE(std::filesystem::exists(folder / "cut-tooth.csv"));
    auto const no_flank = hdconj_run("inspect " + type50 + ring +
                                         "--probe 0.05 --set wave_generator.radial_deformation=0.1 "
                                         "--set circular_spline.inner_radius=25.15 --as-tooth cut.toml",
                                     folder.path());
    CHECK(no_flank.status == 1);
    CHECK_THAT(no_flank.err, ContainsSubstring("its tip alone makes the tooth space") &&
                                 ContainsSubstring("write a wave_generator.radial_deformation nearer"));
    CHECK_FALSE(std::filesystem::exists(folder / "cut.toml"));
}

TEST_CASE("inspect refuses what it cannot follow", "[inspect]")
{
    TemporaryFolder const folder;
    write(folder / "two.csv", "x,y\n0.19,24.95\n0.191,24.94\n");
    write(folder / "far.csv", "x,y\n1,2\n3,4\n5,6\n");
    write(folder / "planes.csv", "x,y,z\n0.19,24.95,0\n0.19,24.95,2\n");
    write(folder / "bad.csv", "x,y\nno,24.95\n");
    std::vector<BadCommand> const table = {
        {"", "POINTS", "no file of measured points is given", "hdconj inspect SCENE POINTS"},
        {"no.csv", "POINTS = no.csv", "cannot be read", "that is there"},
        {"no.toml two.csv", "no.toml", "there is no such file", "hdconj init"},
        {".", "POINTS", "is a folder", "the name of a file"},
        {"bad.csv", "line 2", "is no finite number", "write a number"},
        {type50 + "bad.csv", "hdconj: 1 fault in bad.csv\nbad.csv line 2", "is no finite number", "write a number"},
        {type50 + "far.csv", "hdconj: 1 fault\nPOINTS = far.csv", "0 of 3 points stand on a flank", "--part"},
        {type50 + "two.csv far.csv", "far.csv", "", ""},
        {"two.csv --part ring", "--part", "ring", "flexspline"},
        {"two.csv --register best", "--register", "best", "least-squares"},
        {"two.csv --probe x", "--probe", "x", "--probe 0.1"},
        {"two.csv --probe nan", "--probe", "nan", "--probe 0.1"},
        {"two.csv --probe 3", "--probe", "is larger than the module", "radius of the ball"},
        {"two.csv --plane inf", "--plane", "inf", "--plane 0"},
        {"two.csv", "--register", "do not determine the position", "--register turn"},
        {"far.csv", "POINTS", "0 of 3 points stand on a flank", "--part"},
        {"planes.csv --plane 1", "--plane = 1", "the file has no points there; it has planes at 0, 2 mm", "one of"},
        {"two.csv --deviations two.csv", "--deviations", "would replace it", "another name"},
        {"two.csv --deviations -", "--deviations", "do not go to standard output", "a file name"},
        {"two.csv --deviations no/d.csv", "no/d.csv", "", "", 1},
        {"two.csv --set flexspline.wall=-1", "flexspline.wall", "-1", "write"},
        {"two.csv --as-tooth no/t.toml", "no/t.toml", "", "", 1},
        {"two.csv --as-tooth two.toml --deviations two-tooth.csv", "--deviations", "is written by --as-tooth",
         "another"},
        {"two.csv --picture a.pdf", "--picture", "only .svg and .png", "NAME.svg"},
        {"two.csv --regster turn", "--regster", "", "--register"}};
    for (auto const& row : table)
        check_refused("inspect", row, folder);
}

TEST_CASE("SciPy finds the same registrations to 1e-10 mm, with common errors to 1e-8 mm", "[inspect]")
{
    std::string const python = "'" HDCONJ_PYTHON "' ";
    if (std::string(HDCONJ_PYTHON).empty() || run(python + "-c 'import scipy, numpy'").status != 0)
        return not_tried("python with scipy");
    auto const done = run(python + "'" HDCONJ_SOURCE_DIR "/tests/cli/readers/inspect_with_scipy.py' " + program);
    INFO(done.out << done.err);
    CHECK(done.status == 0);
}

}  // namespace hdconj::test::inspect_output_cases
