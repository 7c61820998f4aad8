// SPDX-License-Identifier: GPL-3.0-or-later
// What `hdconj wedm` must refuse: keys of the scene, what the drive says to them, and command lines; and what must be
// said about them.
#include <algorithm>
#include <fstream>

#include "bad_commands.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/wedm.hpp"
#include "support/catch.hpp"
#include "wedm/faces.hpp"

namespace hdconj::test::bad_wedm_cases {

namespace {

using test::BadCommand;
using test::hdconj_run;
using test::TemporaryFolder;

/// Keys put into the built-in scene: what must be said, and of which key.
struct BadKeys
{
    std::vector<std::string> sets;
    std::string path;
    std::string reason;
    std::string remedy;
};

std::vector<BadKeys> const& keys()
{
    static std::vector<BadKeys> const table{
        {{"!wedm"},
         "wedm",
         "states wire and gap, which are never assumed",
         "wire_diameter = 0.08 and spark_gap = 0.006"},
        {{"!wedm.wire_diameter"}, "wedm.wire_diameter", "missing", "wire_diameter = 0.08"},
        {{"!wedm.spark_gap"}, "wedm.spark_gap", "missing", "spark_gap = 0.006"},
        {{"wedm.wire_diametre=0.1"}, "wedm.wire_diametre", "unknown key", "wire_diameter"},
        {{"wedm.wire_diameter=0"}, "wedm.wire_diameter", "above 0", "length in mm"},
        {{"wedm.wire_diameter=-0.1"}, "wedm.wire_diameter", "above 0", "length in mm"},
        {{"wedm.wire_diameter=nan"}, "wedm.wire_diameter", "not a finite number", "length in mm"},
        {{"wedm.wire_diameter=\"0.1\""}, "wedm.wire_diameter", "text where a length belongs", "without quotes"},
        {{"wedm.wire_diameter=0.8"},
         "wedm.wire_diameter",
         "slot of 0.812 mm, and a whole pitch",
         "fits into a tooth space"},
        {{"wedm.spark_gap=-0.001"}, "wedm.spark_gap", "must not be negative", "0 or more"},
        {{"wedm.spark_gap=inf"}, "wedm.spark_gap", "not a finite number", "0 or more"},
        {{"wedm.spark_gap=0.2"}, "wedm.spark_gap", "wider than the wire", "such as 0.006"},
        {{"wedm.tolerance=0"}, "wedm.tolerance", "above 0", "at least 1e-12"},
        {{"wedm.tolerance=0.00005"},
         "wedm.tolerance",
         "rounding to 4 decimals moves a point",
         "more decimals or a larger tolerance"},
        {{"wedm.decimals=3"},
         "wedm.decimals",
         "rounding to 3 decimals moves a point",
         "more decimals or a larger tolerance"},
        {{"wedm.tolerance=0.03"}, "wedm.tolerance", "a tenth of the module", "at most 0.025"},
        {{"wedm.tolerance=0.000005", "wedm.decimals=7"},
         "wedm.tolerance",
         "known to 1e-06 mm only",
         "smaller solver.tolerance"},
        {{"wedm.passes=[[0.005], [0.02], [0]]"}, "wedm.passes", "cuts nothing", "decreasing lengths that end with 0"},
        {{"wedm.passes=[[0.02], [0.005]]"}, "wedm.passes", "leaves 0.005 mm on the part", "end with 0"},
        {{"wedm.passes=[[0.3], [0]]"}, "wedm.passes", "more than one module", "module 0.25"},
        {{"wedm.passes=[]"}, "wedm.passes", "0 rows", "[length]"},
        {{"wedm.passes=[[-0.01], [0]]"}, "wedm.passes", "must not be negative", "[length]"},
        {{"wedm.passes=[0.02, true]"}, "wedm.passes", "row 2: length is no number", "[length]"},
        {{"wedm.passes=0.02"}, "wedm.passes", "a number where a list belongs", "[0.02, 0.005, 0]"},
        {{"wedm.stop=M2"}, "wedm.stop", "unknown word", "\"M0\" or \"M1\""},
        {{"wedm.stop=0"}, "wedm.stop", "a number where a word belongs", "\"M0\" or \"M1\""},
        {{"wedm.direction=back"}, "wedm.direction", "unknown word", "\"alternating\""},
        {{"wedm.lower_guide=-1"}, "wedm.lower_guide", "must not be negative", "0 or more"},
        {{"wedm.upper_guide=-0.5"}, "wedm.upper_guide", "must not be negative", "0 or more"},
        {{"wedm.upper_guide=nan"}, "wedm.upper_guide", "not a finite number", "0 or more"},
        {{"wedm.thickness=6"}, "wedm.thickness", "the toothing is wider", "at least that width"},
        {{"wedm.thickness=1e6"}, "wedm.thickness", "must be at most 1000", "at most 1000"},
        {{"wedm.thickness=0"}, "wedm.thickness", "above 0", "such as thickness = 7.0"},
        {{"!circular_spline.width"}, "wedm.thickness", "circular_spline.width does not tell it", "thickness = 7.0"},
        {{"wedm.start_hole_radius=0.05"}, "wedm.start_hole_radius", "do not go through a start hole", "above 0.056"},
        {{"wedm.start_hole_radius=0"}, "wedm.start_hole_radius", "above 0", "such as start_hole_radius = 0.5"},
        {{"wedm.start_hole_radius=2.95"}, "wedm.start_hole_radius", "would reach into the cut", "smaller hole"},
        {{"wedm.start_hole_radius=25"}, "wedm.start_hole_radius", "would reach into the cut", "radius below 2.944"},
        {{"wedm.lead_in=0.5"}, "wedm.lead_in", "start hole would reach into the cut", "lead_in above 0.556"},
        {{"wedm.lead_in=40"}, "wedm.lead_in", "beyond the middle of the bore", "at most 25.025"},
        {{"wedm.lead_in=-3"}, "wedm.lead_in", "above 0", "such as lead_in = 3.0"},
        {{"wedm.lead_in=1e300"}, "wedm.lead_in", "larger than any drive", "such as lead_in = 3.0"},
        {{"wedm.start=202"}, "wedm.start", "202 tooth spaces, counted from 0", "from 0 to 201"},
        {{"wedm.start=-1"}, "wedm.start", "at least 0", "whole number"},
        {{"wedm.start=1.5"}, "wedm.start", "whole number", "such as start = 0"},
        {{"wedm.overlap=100"}, "wedm.overlap", "more than half the way around", "a few mm"},
        {{"wedm.overlap=-1"}, "wedm.overlap", "must not be negative", "0 or more"},
        {{"wedm.stop_before=500"}, "wedm.stop_before", "more than half the way around", "a few mm"},
        {{"wedm.residual_limit=-1"}, "wedm.residual_limit", "must not be negative", "0 or more"},
        {{"wedm.surface_limit=-1"}, "wedm.surface_limit", "must not be negative", "0 or more"},
        {{"wedm.largest_tilt_deg=60"}, "wedm.largest_tilt_deg", "at most 45", "from 0 to 45"},
        {{"wedm.largest_travel=0"}, "wedm.largest_travel", "above 0", "length in mm"},
        {{"wedm.largest_uv_travel=-2"}, "wedm.largest_uv_travel", "above 0", "length in mm"},
        {{"wedm.decimals=1"}, "wedm.decimals", "at least 2", "from 2 to 9"},
        {{"wedm.decimals=10"}, "wedm.decimals", "at most 9", "from 2 to 9"},
        {{"tilt.angle_deg=0.2", "wedm.largest_tilt_deg=0.1"},
         "tilt.angle_deg",
         "tilts its wire by 0.1 degrees at most",
         "smaller angle"},
        {{"tilt.angle_deg=31"}, "tilt.angle_deg", "tilts its wire by 30 degrees at most", "a machine that can"},
        {{"wedm.part=wheel"}, "wedm.part", "unknown word", "\"flexspline\""},
        {{"wedm.part=flexspline", "tilt.angle_deg=0.2"}, "tilt.angle_deg", "parallel to its axis", "--tilt 0"},
        {{"wedm.part=flexspline", "wedm.start=200"}, "wedm.start", "200 tooth spaces", "from 0 to 199"},
        {{"wedm.part=flexspline", "wedm.overlap=50"}, "wedm.overlap", "half of what a set-up cuts", "a few mm"},
        {{"wedm.part=flexspline", "wedm.lead_in=0.5"}, "wedm.lead_in", "reach into the cut", "lead_in above 0.556"},
        {{"wedm.part=flexspline", "!circular_spline.width", "!flexspline.cup"},
         "wedm.thickness",
         "missing",
         "thickness = 7.0"},
    };
    return table;
}

/// `drive.h5` is a result, `no-wire.h5` one without [wedm], `broken.h5` one that was cut off.
std::vector<BadCommand> const& wedm_commands()
{
    static std::vector<BadCommand> const table{
        {"--tilt abc", "--tilt", "'abc' is no angle", "such as 0.2"},
        {"--tilt ''", "--tilt", "'' is no angle", "such as 0.2"},
        {"--tilt 0.2deg", "--tilt", "'0.2deg' is no angle", "such as 0.2"},
        {"--tilt nan", "tilt.angle_deg = nan", "not a finite number", "angle_deg = 0.2"},
        {"--tilt 50", "tilt.angle_deg = 50", "not tilted by 45 degrees", "between -45 and 45"},
        {"--tilt=-31", "tilt.angle_deg = -31", "the machine tilts its wire by 30 degrees", "smaller angle"},
        {"--part wheel", "--part", "unknown word 'wheel'", "known: circular-spline, flexspline"},
        {"--part flexpline", "--part", "unknown word 'flexpline'", "write flexspline"},
        {"--part flexspline --tilt 0.2", "tilt.angle_deg = 0.2", "parallel to its axis", "--tilt 0"},
        {"--decimals abc", "--decimals", "'abc' is no finite number", "such as 4"},
        {"--decimals 4.5", "wedm.decimals = 4.5", "must be a whole number", "from 2 to 9"},
        {"--decimals 3", "wedm.decimals = 3", "rounding to 3 decimals", "more decimals"},
        {"--dialect dfx", "--dialect = dfx", "no dialect is called so", "write dxf"},
        {"--dialect csv,rot13", "--dialect = rot13", "no dialect is called so", "known: dxf, xyuv-guide"},
        {"--dialect 'dxf csv'", "--dialect = dxf csv", "commas stand between several dialects", "write dxf,csv"},
        {"--set wedm.dialects=dxf,csv", "--set: wedm.dialects = \"dxf,csv\"", "blanks stand between several dialects",
         "write dxf csv"},
        {"--set wedm.dialects=xyz", "--set: wedm.dialects = \"xyz\"", "no dialect is called so",
         "known: dxf, xyuv-guide"},
        {"--tilt 0.2 --dialect iso-2d", "--dialect = iso-2d", "one contour for both", "--tilt 0"},
        {"--set wedm.wire_diameter=0.3", "wedm.wire_diameter = 0.3", "too wide to follow the contour", "thinner wire"},
        {"--part flexspline --set wedm.wire_diameter=0.3", "wedm.wire_diameter = 0.3", "too wide to follow the contour",
         "thinner wire"},
        {"--set wedm.largest_travel=20", "check failed", "a guide would travel 47.", "wedm.largest_travel", 1},
        {"--tilt 0.2 --set wedm.largest_uv_travel=0.1", "check failed", "would stand 0.19", "wedm.largest_uv_travel",
         1},
        {"-o -", "--output = -", "do not go to standard output", "--json"},
        {"-o ''", "--output", "an empty name", "leave the option out"},
        {"-o scene.toml", "--output = scene.toml", "this is the scene file", "another name"},
        {"-o folder", "folder", "holds mine.txt, which hdconj did not write there", "a new folder", 1},
        {"-o folder/mine.txt", "folder/mine.txt", "is a file, not a folder", "a new folder", 1},
        {"-o none/cut", "none/cut", "does not exist", "mkdir -p", 1},
        {"-o /proc/cut", "/proc/cut", "cannot write", "", 1},
        {"-o /", "/", "no folder that could be made", "a new one", 1},
        {"--picture a.jpg", "--picture", "only .svg and .png are known", "NAME.svg"},
        {"--picture none/a.svg", "none/a-tooth.svg", "does not exist", "mkdir -p", 1},
        {"--picture ''", "--picture", "an empty name", "leave the option out"},
        {"-o a.svg --picture a.svg", "--output = a.svg", "is given to --picture too", "another name"},
        {"--dxf a.dxf", "--dxf", "not expected", "--help"},
    };
    return table;
}

std::vector<BadCommand> const& from_results()
{
    static std::vector<BadCommand> const table{
        {"--from drive.h5 --tilt 0.2", "--from = drive.h5", "the tilt that it was solved with",
         "leave one of them out"},
        {"--from drive.h5 scene.toml", "--from = drive.h5", "a result holds its own scene", "leave one of them out"},
        {"--from drive.h5 --set drive.module=0.3", "--from = drive.h5",
         "another scene than one with --set drive.module=0.3", "[wedm] only"},
        {"--from drive.h5 --set '!wedm.spark_gap'", "wedm.spark_gap", "missing", "spark_gap = 0.006"},
        {"--from drive.h5 --set wedm.thickness=5", "wedm.thickness = 5", "the toothing is wider",
         "at least that width"},
        {"--from no-wire.h5", "wedm", "wire and gap, which are never assumed", "wire_diameter = 0.08"},
        {"--from broken.h5", "broken.h5", "no result file of hdconj", "hdconj solve"},
        {"--from scene.toml", "scene.toml", "no result file of hdconj", "hdconj solve"},
        {"--from none.h5", "none.h5", "", "hdconj solve"},
        {"--from ''", "--from", "an empty name", "leave the option out"},
    };
    return table;
}

void make_scene(TemporaryFolder const& folder)
{
    std::ofstream(folder / "scene.toml") << builtin_scene_text();
    std::filesystem::create_directory(folder / "folder");
    std::ofstream(folder / "folder" / "mine.txt") << "notes\n";
}

}  // namespace

TEST_CASE("wrong keys of wedm are refused with key reason and remedy", "[wedm]")
{
    CHECK(keys().size() + wedm_commands().size() + from_results().size() >= 50);
    for (auto const& row : keys()) {
        Faults faults;
        try {
            faults = check_wedm(builtin_scene(row.sets));
        } catch (InputError const& error) {
            faults = error.faults();
        }
        INFO(row.sets.front() << "\n" << describe(faults));
        auto const fault =
            std::find_if(faults.begin(), faults.end(), [&](Fault const& f) { return f.path == row.path; });
        REQUIRE(fault != faults.end());
        CHECK_THAT(fault->reason, ContainsSubstring(row.reason));
        CHECK_THAT(fault->remedy, ContainsSubstring(row.remedy));
    }
}

TEST_CASE("wrong command lines of wedm say place reason and remedy and write nothing", "[wedm]")
{
    TemporaryFolder const folder;
    make_scene(folder);
    for (auto const& row : wedm_commands())
        test::check_refused("wedm scene.toml", row, folder);
}

TEST_CASE("results that cannot be cut say place reason and remedy and write nothing", "[wedm]")
{
    TemporaryFolder const folder;
    make_scene(folder);
    REQUIRE(hdconj_run("solve --quiet -o drive.h5", folder.path()).status == 0);
    REQUIRE(hdconj_run("solve --quiet --set '!wedm' -o no-wire.h5", folder.path()).status == 0);
    REQUIRE(
        hdconj_run("solve --quiet --set slices.count=3 --set tilt.angle_deg=0.2 -o tilted.h5", folder.path()).status ==
        0);
    std::ofstream(folder / "broken.h5", std::ios::binary) << test::content(folder / "drive.h5").substr(0, 20000);
    for (auto const& row : from_results())
        test::check_refused("wedm", row, folder);
}

TEST_CASE("a tooth without a tip land is not cut in two set-ups", "[wedm]")
{
    // half the thickness is 0.195 mm, and the flanks meet 0.195 mm / tan(29 deg) = 0.3517893123 mm above the pitch line
    auto const straight = [](char const* addendum) {
        return read_scene(
            HDCONJ_SOURCE_DIR "/data/scenes/straight.toml",
            {"wedm.wire_diameter=0.1", "wedm.spark_gap=0.006", "wedm.part=flexspline", "wedm.thickness=7",
             "circular_spline.inner_radius=25.1", std::string("flexspline.profile.addendum=") + addendum});
    };
    CHECK_NOTHROW(wedm::flexspline_faces(straight("0.35")));
    CHECK_THROWS_WITH(wedm::flexspline_faces(straight("0.3517893")),
                      ContainsSubstring("the tooth ends in an edge") && ContainsSubstring("smaller addendum"));
    Scene const reverse = read_scene(HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml",
                                     {"wedm.wire_diameter=0.1", "wedm.spark_gap=0.006"});
    auto const faults = check_wedm(reverse);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults.front().remedy, ContainsSubstring("--part flexspline"));
}

}  // namespace hdconj::test::bad_wedm_cases
