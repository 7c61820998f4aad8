// SPDX-License-Identifier: GPL-3.0-or-later
// What `hdconj wedm` says to write: each remedy is followed, and helps.
#include <nlohmann/json.hpp>

#include "cli/hdconj_run.hpp"
#include "support/catch.hpp"

namespace hdconj::test::wedm_advice_cases {

using hdconj::test::Outcome;
using hdconj::test::TemporaryFolder;
using nlohmann::json;

namespace {

Outcome wedm(std::string const& arguments, TemporaryFolder const& folder)
{
    return hdconj::test::hdconj_run("wedm " + arguments + " --dialect csv -o cut", folder.path());
}

/// What a key of a remedy is to be: the number behind " = " or " = 0 or at least ", with a comma or another end.
std::string advised(std::string const& text, std::string const& key, std::string const& between = " = ")
{
    auto const at = text.find(key + between);
    INFO(text);
    REQUIRE(at != std::string::npos);
    auto const begin = at + key.size() + between.size();
    std::string number = text.substr(begin, text.find_first_not_of("0123456789.", begin) - begin);
    return number;
}

}  // namespace

TEST_CASE("wedm of an outline of two slices checks straight rulings half way up, and says what it cannot check",
          "[wedm]")
{
    TemporaryFolder const folder;
    auto const checks = [&](std::string const& arguments) {
        auto const done = wedm(arguments + " --json --quiet", folder);
        REQUIRE(done.status == 0);
        return json::parse(done.out).at("checks");
    };
    auto const solved = [&](std::string const& sets) {
        REQUIRE(hdconj::test::hdconj_run("solve --set tilt.angle_deg=0.2 --set slices.count=2 -o two.h5 --quiet" + sets,
                                         folder.path())
                    .status == 0);
    };
    solved("");
    double const three = checks("--tilt 0.2").at("middle_error_um").get<double>();
    CHECK(three > 0.1);
    CHECK(checks("--from two.h5").at("middle_error_um").get<double>() == Approx(three).epsilon(1e-9));
    // a draft moves flanks along their normals, which turn
    solved(" --set tilt.kind=draft");
    auto const drafted = checks("--from two.h5");
    CHECK(drafted.at("middle_error_um").is_null());
    CHECK(drafted.at("ruling_error_um").is_null());
    CHECK_THAT(wedm("--from two.h5", folder).out, ContainsSubstring("cut between the faces        not checked   ") &&
                                                      ContainsSubstring("slices.count = 3 or more"));
}

TEST_CASE("wedm names the key that makes a block too short for rounding, and what makes it long", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const told = "units of the last digit in a face";
    for (std::string const key : {"wedm.overlap", "wedm.stop_before"}) {
        INFO(key);
        std::string const text = wedm("--set " + key + "=0.0001", folder).out;
        CHECK_THAT(text, ContainsSubstring("1 block of pass 1 is shorter than 20 units"));
        CHECK(text.find("or a coarser wedm.tolerance") == std::string::npos);
        for (std::string const& length : {std::string("0"), advised(text, key, " = 0 or at least ")})
            CHECK(wedm("--set " + key + "=" + length, folder).out.find(told) == std::string::npos);
    }
    // a drafted corner is a point in the lower face and an arc in the upper one
    std::string const drafted =
        "--tilt 0.1 --set tilt.kind=draft --set circular_spline.root_clearance=0.02 --set wedm.residual_limit=0.06 "
        "--set wedm.tolerance=0.0008";
    std::string const decimals = advised(wedm(drafted, folder).out, "wedm.decimals");
    CHECK(decimals == "6");
    CHECK_THAT(wedm(drafted + " --decimals 5", folder).out, ContainsSubstring(told));
    CHECK(wedm(drafted + " --decimals 6", folder).out.find(told) == std::string::npos);
}

TEST_CASE("wedm says first that a leaning wire would cross the axis, and how thick the workpiece may be", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const tilted = "--tilt 20 --quiet --set wedm.thickness=";
    auto const refused = wedm(tilted + "250", folder);
    CHECK(refused.status == 2);
    // 25.025 - 125 tan(20 deg)
    CHECK_THAT(refused.err, ContainsSubstring("tip circle of the lower face to -20.47 mm, beyond the axis"));
    CHECK(refused.err.size() < 300);
    std::string const most = advised(refused.err, "write at most", " ");
    CHECK(wedm(tilted + most, folder).status == 0);
    CHECK(wedm(tilted + std::to_string(std::stod(most) + 1), folder).status != 0);
}

TEST_CASE("wedm says how thick a workpiece with a ruled cone may be, beyond which no land is left", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const coned =
        "--quiet --set coning.model=linear --set coning.bottom_to_middle=9 --set slices.count=5 --set "
        "slices.surface=ruled --set wedm.surface_limit=0.05 --set wedm.residual_limit=0.02 --set wedm.thickness=";
    auto const refused = wedm(coned + "12", folder);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring("in the lower face of a workpiece of 12 mm no land is left"));
    CHECK(refused.err.size() < 300);
    std::string const most = advised(refused.err, "write at most", " ");
    CHECK(wedm(coned + most, folder).status == 0);
    CHECK(wedm(coned + std::to_string(std::stod(most) + 1), folder).status != 0);
    CHECK(wedm(coned + "12 --set circular_spline.inner_radius=25.2", folder).status == 0);
}

TEST_CASE("wedm says how far a machine has to travel, and which lead-in is enough for it", "[wedm]")
{
    TemporaryFolder const folder;
    auto const within = [&](std::string const& travel, std::string const& lead_in) {
        return wedm("--quiet --set wedm.largest_travel=" + travel + " --set wedm.lead_in=" + lead_in, folder);
    };
    std::string const narrow = within("10", "3").err, wide = within("30", "3").err;
    std::string const on_axis = advised(narrow, "wedm.lead_in");
    std::string const least = advised(narrow, "or at least wedm.largest_travel");
    CHECK(within(least, on_axis).status == 0);
    CHECK(within(std::to_string(std::stod(least) - 0.001), on_axis).status == 1);
    std::string const lead_in = advised(wide, "wedm.lead_in");
    CHECK(within("30", lead_in).status == 0);
    CHECK(within("30", std::to_string(std::stod(lead_in) - 0.001)).status == 1);
    CHECK(within(advised(narrow, "write at least wedm.largest_travel"), "3").status == 0);
}

TEST_CASE("wedm says how far a machine has to tilt its wire and to move its upper guide", "[wedm]")
{
    TemporaryFolder const folder;
    // a tilt as large as the limit is beyond it by rounding
    for (std::string const tilted : {"--tilt 0.3 --quiet --set wedm.largest_tilt_deg=0.3",
                                     "--tilt -0.3 --quiet --set wedm.largest_uv_travel=0.1"}) {
        std::string const refused = wedm(tilted, folder).err, key = tilted.substr(tilted.rfind(" wedm.") + 1);
        std::string const name = key.substr(0, key.find('='));
        CHECK((refused.find("degrees") != std::string::npos) == (name == "wedm.largest_tilt_deg"));
        CHECK(wedm(tilted + " --set " + name + "=" + advised(refused, "write at least " + name), folder).status == 0);
    }
}

TEST_CASE("wedm cuts the upright flexspline of a stored drive with a tilted circular spline", "[wedm]")
{
    TemporaryFolder const folder;
    REQUIRE(hdconj::test::hdconj_run("solve --set tilt.angle_deg=0.2 --set slices.count=3 -o tilted.h5 --quiet",
                                     folder.path())
                .status == 0);
    auto const figures = [&](std::string const& arguments) {
        auto const done = wedm(arguments + " --part flexspline --json --quiet", folder);
        INFO(done.err);
        REQUIRE(done.status == 0);
        return json::parse(done.out);
    };
    CHECK(figures("--from tilted.h5") == figures(""));
}

}  // namespace hdconj::test::wedm_advice_cases
