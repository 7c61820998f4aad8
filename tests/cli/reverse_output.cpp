// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of a reverse result: every reader finds the solved tooth, the given one, and which is which.
#include <fstream>
#include <nlohmann/json.hpp>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj_run.hpp"
#include "report/plots/plots.hpp"
#include "support/catch.hpp"

namespace hdconj::test::reverse_output_cases {

namespace {

using test::hdconj_run;
using test::TemporaryFolder;

std::string const scene = std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/circular-spline-given.toml";

}  // namespace

TEST_CASE("the plan of a reverse scene says what is given and what is computed", "[program][reverse]")
{
    TemporaryFolder const folder;
    auto const check = hdconj_run("check '" + scene + "'", folder.path());
    CHECK(check.status == 0);
    CHECK(contains(check.out, "circular_spline.profile.family = \"double-circular-arc\""));
    CHECK(contains(check.out, "the largest flexspline tooth without interference"));
    CHECK_FALSE(contains(check.out, "root clearance"));
}

TEST_CASE("summary, JSON, HDF5 and DXF of a reverse result", "[program][reverse]")
{
    TemporaryFolder const folder;
    auto const solve = hdconj_run("solve '" + scene + "' --json -o a.h5 --dxf a.dxf", folder.path());
    INFO(solve.err);
    REQUIRE(solve.status == 0);
    auto const json = nlohmann::json::parse(solve.out);
    CHECK(json["drive"]["given"] == "circular spline");
    CHECK(json["flexspline"]["pieces"].front()["kind"] == "root wall");
    CHECK(json["flexspline"]["points"].get<int>() > 100);
    CHECK(json["circular_spline"]["slices"] == 1);
    CHECK(json["circular_spline"]["landmarks"].size() == 5);
    CHECK(std::abs(json["clearance"]["smallest_clearance_mm"].get<double>()) < 1e-11);
    CHECK(json["geometry"]["addendum_mm"] == 0.225);
    CHECK(contains(hdconj_run("solve '" + scene + "' -o b.h5", folder.path()).out,
                   "given: tooth of the circular spline; computed: tooth of the flexspline"));
    if (!std::string(HDCONJ_PYTHON).empty()) {
        auto const read = test::run(std::string("'" HDCONJ_PYTHON "' '") + HDCONJ_SOURCE_DIR +
                                        "/tests/cli/readers/read_with_h5py.py' a.h5 a.dxf",
                                    folder.path());
        CHECK(read.err.empty());
        CHECK(contains(read.out, " 0 faults"));
        CHECK(read.status == 0);
    }
}

TEST_CASE("the forward problem's results say that the flexspline is given", "[program][reverse]")
{
    TemporaryFolder const folder;
    auto const json = nlohmann::json::parse(hdconj_run("solve --json -o a.h5", folder.path()).out);
    CHECK(json["drive"]["given"] == "flexspline");
    CHECK_FALSE(json.contains("flexspline"));
}

TEST_CASE("the picture of a reverse result is of the flexspline tooth", "[reverse]")
{
    auto const script = report::tooth_space_script(solve(read_scene(scene)));
    CHECK(contains(script, "flexspline tooth, solved for"));
    CHECK(contains(script, "circular spline at the major axis, given"));
    CHECK(contains(script, "positions = 82\n"));
    CHECK(contains(script, "reverse = 1\n"));
    CHECK(contains(script, "from the pitch line"));
    CHECK(contains(script, "$tip_circle << EOD\nEOD\n"));
}

}  // namespace hdconj::test::reverse_output_cases
