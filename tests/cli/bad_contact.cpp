// SPDX-License-Identifier: GPL-3.0-or-later
// What `hdconj contact` must refuse: scenes with axial effects with an edit, and command lines; and what must be said
// about them.
#include <fstream>
#include <limits>

#include "bad_commands.hpp"
#include "bad_scene_checks.hpp"
#include "hdconj/contact.hpp"

namespace hdconj::test::bad_contact_cases {

namespace {

using test::BadCommand;
using test::BadScene;
using test::faults_of;
using test::TemporaryFolder;

std::string const scenes = HDCONJ_SOURCE_DIR "/data/scenes/";
std::string const given_spline = scenes + "circular-spline-given.toml";

std::string const& coned()
{
    static std::string const text = test::content(scenes + "type-50-coned.toml");
    return text;
}

/// The scene has no [tilt] and no [contact]: rows that need one add it in front of [slices].
std::vector<BadScene> const& contact_rows()
{
    static std::vector<BadScene> const table{
        {"coning without model", "model = \"linear\"", "", "coning.model", "missing", "model = \"linear\""},
        {"unknown coning", "model = \"linear\"", "model = \"linar\"", "coning.model", "unknown word",
         "write \"linear\""},
        {"elastic coning", "model = \"linear\"", "model = \"elastic\"", "flexspline.cup", "needs the cup's dimensions",
         "length = 15.0", 0},
        {"no cup", "bottom_to_middle = 9.0", "", "coning.bottom_to_middle", "missing", "bottom_to_middle = 9"},
        {"cup of no length", "bottom_to_middle = 9.0", "bottom_to_middle = 0", "coning.bottom_to_middle", "above 0",
         "above 0", 0},
        {"cup that is not finite", "bottom_to_middle = 9.0", "bottom_to_middle = nan", "coning.bottom_to_middle",
         "finite", "length in mm", 0},
        {"teeth through the cup's bottom", "bottom_to_middle = 9.0", "bottom_to_middle = 3.5",
         "coning.bottom_to_middle", "through the cup's bottom", "longer cup"},
        {"apex in front of the middle", "apex_height = 0.43", "apex_height = 9.0", "coning.apex_height",
         "behind the middle of the bearing", "smaller height"},
        {"teeth behind the apex", "apex_height = 0.43", "apex_height = 5.5", "coning.apex_height", "behind the apex",
         "smaller height"},
        {"apex not finite", "apex_height = 0.43", "apex_height = -inf", "coning.apex_height", "finite", "apex_height"},
        {"apex in quotes", "apex_height = 0.43", "apex_height = \"0.43\"", "coning.apex_height", "text where",
         "without quotes"},
        {"misspelt apex", "apex_height = 0.43", "apex_hight = 0.43", "coning.apex_hight", "unknown key",
         "write apex_height"},
        {"unknown axial shift", "axial_shift = \"mapped\"", "axial_shift = \"maped\"", "coning.axial_shift",
         "unknown word", "write \"mapped\""},
        {"axial shift as a truth", "axial_shift = \"mapped\"", "axial_shift = true", "coning.axial_shift", "",
         "mapped"},
        {"misspelt coning", "[coning]", "[conning]", "conning", "unknown table", "[coning]", 0},
        {"tilt without angle", "[slices]", "[tilt]\nkind = \"radial\"\n[slices]", "tilt.angle_deg", "missing",
         "angle_deg = 0.2"},
        {"steep tilt", "[slices]", "[tilt]\nangle_deg = 45\n[slices]", "tilt.angle_deg", "not tilted by 45 degrees",
         "between -45 and 45"},
        {"tilt not finite", "[slices]", "[tilt]\nangle_deg = nan\n[slices]", "tilt.angle_deg", "finite",
         "angle_deg = 0.2"},
        {"tilt in quotes", "[slices]", "[tilt]\nangle_deg = \"0.2\"\n[slices]", "tilt.angle_deg", "text where",
         "without quotes"},
        {"unknown kind of tilt", "[slices]", "[tilt]\nangle_deg = 0.2\nkind = \"draught\"\n[slices]", "tilt.kind",
         "unknown word", "\"draft\""},
        {"draft of a surface with many outlines", "[slices]", "[tilt]\nangle_deg = 0.2\nkind = \"draft\"\n[slices]",
         "tilt.kind", "an outline for each slice", "surface = \"tilted\""},
        {"no slices", "count = 9", "count = 0", "slices.count", "at least 1", "from 1 to 1000"},
        {"half a slice", "count = 9", "count = 2.5", "slices.count", "whole number", "count = 9"},
        {"too many slices", "count = 9", "count = 1001", "slices.count", "at most 1000", "from 1 to 1000"},
        {"slices without count", "count = 9", "", "slices.count", "missing", "count = 9"},
        {"unknown surface", "surface = \"per-slice\"", "surface = \"perslice\"", "slices.surface", "unknown word",
         "write \"per-slice\""},
        {"no width", "width = 7.0", "", "circular_spline.width", "missing", "width = 7.0", 0},
        {"negative width", "width = 7.0", "width = -7.0", "circular_spline.width", "above 0", "above 0", 0},
        {"width of a longer cup", "width = 7.0", "width = 18.0", "coning.bottom_to_middle", "through the cup's bottom",
         "smaller circular_spline.width"},
        {"clearance by another word", "backlash_offset = 0.0", "backlash_offset = \"automatic\"",
         "circular_spline.backlash_offset", "unknown word", "write \"auto\""},
        {"negative clearance", "backlash_offset = 0.0", "backlash_offset = -0.01", "circular_spline.backlash_offset",
         "at least 0", "\"auto\""},
        {"gap of nothing", "[slices]", "[contact]\ncontact_gap = 0\n[slices]", "contact.contact_gap", "above 0",
         "contact_gap = 0.001"},
        {"gap not finite", "[slices]", "[contact]\ncontact_gap = inf\n[slices]", "contact.contact_gap", "finite",
         "contact_gap = 0.001"},
        {"gap below any length", "[slices]", "[contact]\ncontact_gap = 1e-300\n[slices]", "contact.contact_gap",
         "at least 1e-09", "1e-09"},
        {"gap like a tooth", "[slices]", "[contact]\ncontact_gap = 0.026\n[slices]", "contact.contact_gap",
         "do not touch", "at most 0.025"},
        {"too few points", "[slices]", "[contact]\nflank_points = 4\n[slices]", "contact.flank_points", "at least 5",
         "from 5 to 10000"},
        {"too many points", "[slices]", "[contact]\nflank_points = 10001\n[slices]", "contact.flank_points",
         "at most 10000", "from 5 to 10000"},
        {"wave generator twice round", "[slices]", "[contact]\nwave_generator_angle_deg = 720\n[slices]",
         "contact.wave_generator_angle_deg", "at most 360", "from -360 to 360"},
        {"misspelt gap", "[slices]", "[contact]\ncontact_gab = 0.001\n[slices]", "contact.contact_gab", "unknown key",
         "write contact_gap"},
    };
    return table;
}

/// Effects put into the scene whose circular-spline tooth is given.
std::vector<BadScene> const& reverse_rows()
{
    static std::vector<BadScene> const table{
        {"reverse and coning", "[solver]", "[coning]\nmodel = \"linear\"\nbottom_to_middle = 9.0\n[solver]", "coning",
         "need the flexspline's tooth", "remove [coning]", 0},
        {"reverse and tilt", "[solver]", "[tilt]\nangle_deg = 0.2\n[solver]", "tilt", "need the flexspline's tooth",
         "remove [tilt]", 0},
        {"reverse and slices", "[solver]", "[slices]\ncount = 3\n[solver]", "slices", "need the flexspline's tooth",
         "remove [slices]", 0},
        {"reverse and contact", "[solver]", "[contact]\n[solver]", "contact", "need the flexspline's tooth",
         "remove [contact]", 0},
        {"reverse and auto", "backlash_offset = 0.0", "backlash_offset = \"auto\"", "circular_spline.backlash_offset",
         "needs the flexspline's tooth", "length in mm", 0},
    };
    return table;
}

std::vector<BadCommand> const& contact_commands()
{
    static std::vector<BadCommand> const table{
        {"--tilt 45", "--tilt = 45", "not tilted by 45 degrees", "0,0.1,0.2"},
        {"--tilt=-60", "--tilt = -60", "not tilted by 45 degrees", "0,0.1,0.2"},
        {"--tilt abc", "--tilt", "'abc' is no angle", "0,0.1,0.2"},
        {"--tilt 0.1deg", "--tilt", "'0.1deg' is no angle", "0,0.1,0.2"},
        {"--tilt ''", "--tilt", "'' is no angle", "0,0.1,0.2"},
        {"--tilt nan", "--tilt = nan", "not a finite number", "0,0.1,0.2"},
        {"--tilt 1e400", "--tilt = inf", "not a finite number", "0,0.1,0.2"},
        {"--surface wrong", "--surface", "unknown word 'wrong'", "known: tilted, ruled, per-slice"},
        {"--surface tilted,perslice", "--surface", "unknown word 'perslice'", "write per-slice"},
        {"--kind drafted", "--kind", "unknown word 'drafted'", "write draft"},
        {"--kind draft --surface per-slice --tilt 0.2", "--kind = draft", "an outline for each slice",
         "--surface tilted"},
        {"--kind draft --tilt 0.2", "--kind = draft", "surface \"per-slice\" has an outline for each slice",
         "--surface tilted"},
        {"--set slices.surface=tilted --set tilt.angle_deg=0.2 --set tilt.kind=draft --surface ruled",
         "--surface = ruled", "an outline for each slice", "--kind radial"},
        {"--revolution 0", "--revolution", "'0' is no whole number from 1 to 10000", "--help"},
        {"--revolution 1e3", "--revolution", "'1e3' is not written as a whole number (write 1000)", "--help"},
        {"--revolution some", "--revolution", "some", "--help"},
        {"--best", "--best", "surface \"per-slice\" is asked for", "--surface tilted"},
        {"--best --surface tilted --tilt 0.3", "--best", "interval of tilts to search is empty", "FROM below TO"},
        {"--best --surface tilted --tilt 1,1", "--best", "interval of tilts to search is empty", "FROM below TO"},
        {"--ring", "--ring", "no surface file is asked for", "--stl"},
        {"-o a.h5 --stl ./a.h5", "--output = a.h5", "is given to --stl too", "another name"},
        {"-o a.h5 --vtk a.vtk --xdmf a.vtk", "--xdmf = a.vtk", "is given to --vtk too", "another name"},
        {"-o ./scene.toml", "--output = ./scene.toml", "this is the scene file", "another name"},
        {"--vtk scene.toml", "--vtk = scene.toml", "this is the scene file", "another name"},
        {"-o -", "--output = -", "do not go to standard output", "--json"},
        {"--stl -", "--stl = -", "do not go to standard output", "a file name"},
        {"--picture a.jpg", "--picture", "only .svg and .png are known", "NAME.svg"},
        {"--picture a", "--picture", "only .svg and .png are known", "NAME.svg"},
        {"--dxf a.dxf", "--dxf", "not expected", "--help"},
        {"--set '!circular_spline.width'", "circular_spline.width", "missing", "width = 7.0"},
        {"-o folder", "folder", "is a folder", "write a file name in it", 1},
        {"--vtk folder", "folder", "is a folder", "write a file name in it", 1},
        {"-o none/a.h5", "none/a.h5", "folder none does not exist", "mkdir -p", 1},
        {"--xdmf none/a.xdmf", "none/a.xdmf", "folder none does not exist", "mkdir -p", 1},
        {"-o /dev/full", "/dev/full", "No space left on device", "", 1},
        {"--surface tilted --tilt 20", "tip circle", "the flexspline's tips reach", "smaller tilt", 1},
        {"--tilt 20", "slice at z = -3.5 mm", "the flexspline's tips reach", "smaller tilt", 1},
        {"--set circular_spline.backlash_offset=0.24", "slice at z = -3.5 mm", "the flexspline's tips reach",
         "side clearance", 1},
        {"--set coning.apex_height=5.4999", "slice at z = -3.5 mm", "behind the apex", "smaller", 1},
        {"--set coning.apex_height=5.4999 --set coning.axial_shift=none", "slice at z = -3.5 mm",
         "the flexspline's tips reach", "smaller", 1},
    };
    return table;
}

}  // namespace

TEST_CASE("the coned scenes have no fault", "[scene][contact]")
{
    for (std::string const name : {"type-50-coned", "liu-2025-coned"}) {
        auto const faults = faults_of(test::content(scenes + name + ".toml"));
        INFO(describe(faults));
        CHECK(faults.empty());
    }
}

TEST_CASE("wrong axial effects and contact keys are refused", "[scene][contact]")
{
    for (auto const& row : contact_rows()) {
        SECTION(row.name)
        {
            test::check_row(row, test::edited(coned(), row));
        }
    }
}

TEST_CASE("axial effects with the circular spline's tooth given are refused", "[scene][contact][reverse]")
{
    for (auto const& row : reverse_rows()) {
        SECTION(row.name)
        {
            test::check_row(row, test::edited(test::content(given_spline), row));
        }
    }
}

TEST_CASE("wrong command lines of contact say place reason and remedy and write nothing", "[contact]")
{
    for (auto const& row : contact_commands()) {
        SECTION(row.arguments)
        {
            TemporaryFolder const folder;
            std::ofstream(folder / "scene.toml") << coned();
            std::filesystem::create_directory(folder / "folder");
            test::check_refused("contact scene.toml", row, folder);
        }
    }
}

TEST_CASE("contact of a reverse scene points to solve", "[contact][reverse]")
{
    TemporaryFolder const folder;
    auto const refused = test::hdconj_run("contact '" + given_spline + "'", folder.path());
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring("circular_spline.profile") && ContainsSubstring("flexspline's tooth") &&
                                ContainsSubstring("hdconj solve"));
    CHECK(folder.names().empty());
}

TEST_CASE("contact called as a library refuses the same", "[contact]")
{
    auto reading = examine_scene(coned(), "scene");
    examine_geometry(reading);
    REQUIRE(reading.faults.empty());
    ContactOptions options;
    options.tilts = {1.0};
    options.kinds = {TiltKind::draft};
    options.best = true;
    options.best_to = options.best_from;
    options.revolution = -3;
    auto const faults = check_contact(reading.scene, options);
    INFO(describe(faults));
    CHECK(faults.size() == 5);
    options.best_to = std::numeric_limits<double>::infinity();
    CHECK_THAT(describe(check_contact(reading.scene, options)), ContainsSubstring("not a finite number"));
    ContactOptions turns;
    turns.revolution = 10000;
    CHECK(check_options(turns).empty());
    turns.revolution = 10001;
    CHECK(check_options(turns).size() == 1);
    CHECK_THROWS_AS(study_contact(reading.scene, options), InputError);
}

}  // namespace hdconj::test::bad_contact_cases
