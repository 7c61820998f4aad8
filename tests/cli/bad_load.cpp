// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong command lines and measured curves of `hdconj load`: place, reason, remedy, exit status, and no file.
#include <fstream>

#include "bad_commands.hpp"
#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"

namespace hdconj::test::bad_load_cases {

namespace {

using hdconj::test::BadCommand;
using hdconj::test::hdconj_run;
using hdconj::test::TemporaryFolder;

std::string const given_spline = HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml";

std::vector<BadCommand> const& load_commands()
{
    static std::vector<BadCommand> const table{
        {"--torque abc", "--torque", "'abc' is no finite number", "such as --torque 28"},
        {"--torque ''", "--torque", "'' is no finite number", "such as --torque 28"},
        {"--torque nan", "--torque", "'nan' is no finite number", "such as --torque 28"},
        {"--torque 1e400", "--torque", "no finite number", "such as --torque 28"},
        {"--torque 28Nm", "--torque", "'28Nm' is no finite number", "such as --torque 28"},
        {"--torque 0", "--torque", "'0' is not above 0", "such as --torque 28"},
        {"--torque 1e-12", "--torque = 1e-12", "must be at least 1e-09 N m", "such as 28"},
        {"--torque 1e12", "--torque = 1e+12", "larger than any drive has, 1e+09 N m", "such as 28"},
        {"--torque=-28", "--torque", "'-28' is not above 0", "such as --torque 28"},
        {"--set coning.model=linear --set coning.bottom_to_middle=17.19", "bearing.width", "beyond the straight wall",
         "another coning.bottom_to_middle"},
        {"--set errors.flexspline.wobble_deg=0.5", "errors.flexspline.wobble_deg",
         "moves the ends of the teeth by more than a tenth of the module", "write at most 0."},
        {"--set errors.circular_spline.wobble_deg=-0.1", "errors.circular_spline.wobble_deg", "must be at least 0",
         "from 0 to 1"},
        {"--set bearing.fit=5", "bearing.fit = 5", "is more than half of the module", "such as 0.005"},
        {"--set bearing.cam_oversize=0.2", "bearing.cam_oversize = 0.2", "more than half of the module", "0.005"},
        {"--set bearing.clearance=0.5", "bearing.clearance = 0.5", "more than half of the module", "0.005"},
        {"--set running.temperatures=[40,-100]", "running.temperatures", "is no temperature of a lubricant",
         "between -60 and 200 degrees"},
        {"--set errors.flexspline.pitch=[0.001,0.002]", "errors.flexspline.pitch", "2 places for 200 teeth",
         "one number for each tooth"},
        {"--set load.first_torque=20 --set load.second_torque=5", "load.first_torque = 20", "T1 is not below T2, 5 N m",
         "write one below 5 N m"},
        {"--set load.first_torque=20", "load.first_torque = 20", "the usual T2, 17.5 N m", "write one below 17.5 N m"},
        {"--set load.second_torque=28", "load.second_torque = 28", "not below the rated torque, 28 N m", "below 28"},
        {"--points some", "--points", "some", "--help"},
        {"--points 0", "--points", "'0' is no whole number from 1 to 1000", "--help"},
        {"--points 5 --no-curve", "--points = 5", "no curve that could have points", "leave one of them out"},
        {"--tilt 45", "--tilt = 45", "not tilted by 45 degrees", "0,0.1,0.2"},
        {"--tilt abc", "--tilt", "'abc' is no angle", "0,0.1,0.2"},
        {"--surface wrong", "--surface", "unknown word 'wrong'", "known: tilted, ruled, per-slice"},
        {"--surface perslice", "--surface", "unknown word 'perslice'", "write per-slice"},
        {"--kind drafted", "--kind", "unknown word 'drafted'", "write draft"},
        {"--ratio 100", "--ratio = 100", "no measured curve", "write --measured"},
        {"--output-member cup", "--output-member = cup", "no measured curve", "write --measured"},
        {"--measured loop.csv --output-member spline", "--output-member", "unknown word 'spline'", "circular-spline"},
        {"--torque-constant 0.119 --counts-per-turn 2000 --efficiency 0.9", "--efficiency = 0.9", "no measured curve",
         "leave it out"},
        {"--efficiency no", "--efficiency", "'no' is no finite number", "--efficiency 0.8"},
        {"--measured none.csv", "--measured = none.csv", "cannot be read", "a CSV file that is there"},
        {"--measured folder", "--measured = folder", "is a folder", "a CSV file"},
        {"--measured /dev/zero", "--measured = /dev/zero", "no file that ends", "a CSV file"},
        {"--measured empty.csv", "--measured = empty.csv", "no header and no samples", "angle [arcmin], torque [N m]"},
        {"--measured bad.csv", "bad.csv line 3: column 2, torque [N m] = abc", "is no finite number", "12.5"},
        {"--measured motor.csv", "--torque-constant", "is missing: motor.csv has a column of motor current",
         "--torque-constant 0.119"},
        {"--measured motor.csv", "--counts-per-turn", "is missing", "--counts-per-turn 2000"},
        {"--measured motor.csv --torque-constant 0 --counts-per-turn 2000", "--torque-constant = 0",
         "must be finite and not 0", "0.119"},
        {"--measured up.csv", "--measured = up.csv", "one sign only", "0, T, 0, -T, 0"},
        {"--measured up.csv --ratio 100", "--ratio = 100", "no column that needs it", "leave it out"},
        {"--measured back.csv", "--measured = back.csv", "torque falls while the angle grows",
         "turn the sign of one column round"},
        {"--measured loop.csv -o loop.csv", "--output = loop.csv", "this file is read", "another name"},
        {"-o a.h5 --vtu ./a.h5", "--output = a.h5", "is given to --vtu too", "another name"},
        {"-o -", "--output = -", "do not go to standard output", "--json"},
        {"--vtu -", "--vtu = -", "do not go to standard output", "a file name"},
        {"--picture a.jpg", "--picture", "only .svg and .png are known", "NAME.svg"},
        {"--stl a.stl", "--stl", "not expected", "--help"},
        {"-o folder", "folder", "is a folder", "write a file name in it", 1},
        {"--vtu none/a.vtu", "none/a.vtu", "folder none does not exist", "mkdir -p", 1},
    };
    return table;
}

void prepare_load(TemporaryFolder const& folder)
{
    std::filesystem::create_directory(folder / "folder");
    write(folder / "empty.csv", "# nothing\n");
    write(folder / "bad.csv", "angle [deg],torque [N m]\n0,0\n1,abc\n");
    write(folder / "motor.csv", "current [A],position [counts]\n0,0\n1,100\n");
    write(folder / "up.csv", "angle [deg],torque [N m]\n0,0\n1,1\n2,2\n3,3\n4,4\n3,3\n2,2\n1,1\n0,0\n");
    write(folder / "loop.csv", "angle [deg],torque [N m]\n0,0\n1,1\n2,2\n1,1\n0,0\n-1,-1\n-2,-2\n-1,-1\n0,0\n");
    write(folder / "back.csv", "angle [deg],torque [N m]\n0,0\n-1,1\n-2,2\n-1,1\n0,0\n1,-1\n2,-2\n1,-1\n0,0\n");
}

}  // namespace

TEST_CASE("wrong command lines of load say place reason and remedy and write nothing", "[load]")
{
    for (auto const& row : load_commands()) {
        SECTION(row.arguments + " " + row.place)
        {
            TemporaryFolder const folder;
            prepare_load(folder);
            hdconj::test::check_refused("load", row, folder);
        }
    }
}

TEST_CASE("load tells all faults of scene options and measured curve at once", "[load]")
{
    TemporaryFolder const folder;
    prepare_load(folder);
    auto const refused =
        hdconj_run("load --set flexspline.wall=-1 --ratio 0 --measured bad.csv --no-curve --points 3", folder.path());
    INFO(refused.err);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring("flexspline.wall = -1") && ContainsSubstring("--points = 3") &&
                                ContainsSubstring("--ratio = 0") && ContainsSubstring("bad.csv line 3: column 2"));
}

TEST_CASE("load called as a library has the limits of the command line", "[load]")
{
    Scene const scene = builtin_scene({"load.torque=20"});
    for (double const torque : {0.0, -5.0, 1e10}) {
        LoadOptions options;
        options.torque = torque * newton_metre;
        CHECK(check_load(scene, options).size() == 1);
    }
    for (int const points : {-1, 0, 1001}) {
        LoadOptions options;
        options.points = points;
        CHECK(check_load(scene, options).size() == 1);
    }
}

TEST_CASE("load of a drive that cannot be assembled advises what lets it be assembled", "[load]")
{
    // few balls with clearance leave the cup another shape than the teeth were made for, on every surface
    std::vector<std::string> set{"bearing.balls=13", "bearing.clearance=0.03"};
    LoadOptions options;
    options.curve = options.errors = false;
    options.surfaces = {ToothSurface::per_slice};
    try {
        (void)study_load(builtin_scene(set), options);
        FAIL("it can be assembled");
    } catch (NumericalError const& error) {
        INFO(error.what());
        CHECK(error.code() == ErrorCode::interference);
        CHECK_THAT(error.remedy(),
                   ContainsSubstring("circular_spline.backlash_offset = ") && !ContainsSubstring("per-slice"));
        REQUIRE(error.set().size() == 1);
        set.push_back(error.set().front());
    }
    CHECK(study_load(builtin_scene(set), options).cases.size() == 1);
}

TEST_CASE("load of a reverse scene is refused", "[load][reverse]")
{
    TemporaryFolder const folder;
    auto const refused = hdconj_run("load '" + given_spline + "'", folder.path());
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring("circular_spline.profile") && ContainsSubstring("flexspline's tooth"));
    CHECK(folder.names().empty());
}

}  // namespace hdconj::test::bad_load_cases
