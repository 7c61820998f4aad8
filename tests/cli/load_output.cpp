// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj load` as a user meets it: the same figures in all that it writes. What holds for other verbs too:
// every_verb.cpp.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <sstream>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"
#include "support/rig_loop.hpp"

namespace hdconj::test::load_output_cases {

using hdconj::test::Outcome;
using hdconj::test::TemporaryFolder;
using nlohmann::json;
namespace sample = hdconj::sample;

namespace {

/// Few slices and torques: what is looked at here does not depend on them.
std::string const coarse = "--set slices.count=3 ";
std::string const one_torque = coarse + "--no-curve ";

Outcome load(std::string const& arguments, TemporaryFolder const& folder)
{
    return hdconj::test::hdconj_run("load " + arguments, folder.path());
}

/// Words of a line with one space between them.
std::string one_spaced(std::string const& text)
{
    return std::regex_replace(text, std::regex(" +"), " ");
}

std::string line_of(std::string const& label, std::string const& value, std::string const& words)
{
    return "\n " + label + " " + value + " " + words + "\n";
}

/// A log of the thesis' rig: current of a motor with 119 mN m/A, counts of 2000 per turn, behind 1:100.
void write_log(std::filesystem::path const& file)
{
    sample::Rig rig;
    rig.per_branch = 60;
    auto const curve = sample::rig_loop(rig);
    std::ofstream out(file);
    out << "# rig\ncurrent [A],position [counts]\n";
    for (std::size_t i = 0; i < curve.twist.size(); ++i) {
        out << curve.torque[i] / 1000 / 100 / 0.119 << ','
            << std::lround(curve.twist[i] / (2 * std::numbers::pi) * 2000 * 100) << '\n';
    }
}

}  // namespace

TEST_CASE("load names its result after the drive and says so", "[load]")
{
    TemporaryFolder const folder;
    auto const done = load(one_torque, folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    CHECK(done.err.empty());
    CHECK_THAT(done.out, ContainsSubstring("coning, major axis") && ContainsSubstring("type-50-load.h5"));
    CHECK(folder.names() == std::vector<std::string>{"type-50-load.h5"});
}

TEST_CASE("load: the curve is run as asked and JSON and HDF5 say the same", "[load]")
{
    TemporaryFolder const folder;
    auto const done = load(coarse + "--torque 20 --points 4 --json --quiet -o a.h5", folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    json const found = json::parse(done.out).at("load");
    REQUIRE(found.at("cases").size() == 1);
    json const& only = found.at("cases")[0];
    json const& curve = only.at("curve");
    std::vector<double> const wanted{-20, -15, -12.5, -10, -5, -3.5, -0.8, 0, 0.8, 3.5, 5, 10, 12.5, 15, 20};
    REQUIRE(curve.size() == wanted.size());
    auto const file = hdconj::test::open_file(folder / "a.h5");
    auto const doubles = [&](std::string const& name) { return hdconj::test::read(file, name.c_str()).values; };
    constexpr double arcmin = 60 * 180 / std::numbers::pi;
    auto const torque = doubles("/load/case_000/curve/torque"), twist = doubles("/load/case_000/curve/twist"),
               pressure = doubles("/load/case_000/curve/largest_pressure");
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        INFO(k);
        CHECK(curve[k].at("torque_Nm").get<double>() == Approx(wanted[k]).margin(1e-9));
        CHECK(torque[k] == Approx(wanted[k] * 1000).margin(1e-6));
        CHECK(curve[k].at("twist_arcmin").get<double>() == Approx(twist[k] * arcmin).margin(1e-9));
        CHECK(curve[k].at("largest_pressure_MPa").get<double>() == Approx(pressure[k]).margin(1e-9));
    }
    CHECK(std::is_sorted(twist.begin(), twist.end()));
    json const& rated = only.at("rated");
    CHECK(rated.at("torque_Nm").get<double>() == Approx(20));
    CHECK(rated.at("teeth").get<int>() > 0);
    CHECK(rated.at("contact_fraction").get<double>() > 0);
    REQUIRE(rated.at("largest_pressure_MPa").get<double>() > rated.at("flank_pressure_MPa").get<double>());
    CHECK(only.at("rated_error").at("largest_pressure_MPa").is_null());  // on an edge
    CHECK(only.at("not_converged").dump().find("\"largest_pressure\"") != std::string::npos);
    CHECK(doubles("/load/backlash")[0] * arcmin == Approx(only.at("backlash_arcmin").get<double>()).margin(1e-9));
    auto const map = doubles("/load/case_000/map/pressure");
    CHECK(*std::max_element(map.begin(), map.end()) == Approx(rated.at("largest_pressure_MPa").get<double>()));
}

TEST_CASE("load: the text names each error that the scene gives", "[load]")
{
    TemporaryFolder const folder;
    auto const done =
        load(one_torque +
                 "-o a.h5 --no-errors --set bearing.clearance=0.002 "
                 "--set errors.wave_generator.eccentricity=0.001 "
                 "--set 'errors.wave_generator.cam_deviation=[[0, 0], [90, 0.001], [180, 0], [270, 0]]' "
                 "--set errors.flexspline.profile_slope=0.002 "
                 "--set 'errors.circular_spline.profile_form=[[-0.3, 0], [-0.1, 0], [0.1, 0], [0.3, 0.001]]'",
             folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    for (std::string const& line :
         {line_of("bearing clearance", "2 um", "on the diameter, under torque"),
          line_of("eccentricity", "1 um", "wave generator"), line_of("cam deviation", "4 rows", "wave generator"),
          line_of("profile slope", "2 um", "flexspline, tip over root"),
          line_of("profile form", "4 rows", "circular spline")})
        CHECK_THAT(one_spaced(done.out), ContainsSubstring(line));
}

TEST_CASE("load: the members in series add up to the twist, in text, JSON and HDF5 alike", "[load][compliance]")
{
    TemporaryFolder const folder;
    std::string const keys = one_torque + "-o a.h5 --set compliance.shaft=25000 --set compliance.outer_radius=35 ";
    auto const done = load(keys + "--json --quiet", folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    json const only = json::parse(done.out).at("load").at("cases")[0];
    json const& members = only.at("members");
    std::vector<std::string> const names{"half of the backlash", "teeth and bearing", "cup in torsion",
                                         "body of the circular spline", "shaft"};
    REQUIRE(members.size() == names.size());
    auto const file = hdconj::test::open_file(folder / "a.h5");
    auto const twist = hdconj::test::read(file, "/load/case_000/members/twist").values,
               stiffness = hdconj::test::read(file, "/load/case_000/members/stiffness").values;
    auto const text = load(keys, folder);
    double sum = 0, fractions = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        CHECK(members[i].at("name") == names[i]);
        CHECK(members[i].at("stiffness_Nm_per_rad").get<double>() == Approx(stiffness[i] / 1000));
        CHECK(members[i].at("twist_arcmin").get<double>() == Approx(twist[i] * 60 * 180 / std::numbers::pi));
        CHECK_THAT(text.out, ContainsSubstring("\n  " + names[i] + "  "));
        sum += members[i].at("twist_arcmin").get<double>();
        fractions += members[i].at("fraction").get<double>();
    }
    CHECK(stiffness.back() == 25e6);
    CHECK(sum == Approx(only.at("rated").at("twist_arcmin").get<double>()).epsilon(1e-12));
    CHECK(fractions == Approx(1).epsilon(1e-12));
}

TEST_CASE("load lays a measured curve over the simulation", "[load][measured]")
{
    TemporaryFolder const folder;
    write_log(folder / "log.csv");
    auto const run = one_torque + "-o a.h5 --measured log.csv --torque-constant 0.119 --counts-per-turn 2000 ";
    auto const done = load(run + "--json", folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    json const measured = json::parse(done.out).at("load").at("measured");
    CHECK(measured.at("ratio") == 100);
    CHECK(measured.at("angle_per_spline").get<double>() == Approx(1.01));
    // the same counts and currents behind the circular spline: it turns less often, and nothing is to be carried over
    auto const spline = load(run + "--json --output-member circular-spline", folder);
    REQUIRE(spline.status == 0);
    json const of_spline = json::parse(spline.out).at("load").at("measured");
    CHECK(of_spline.at("ratio") == 101);
    CHECK(of_spline.at("angle_per_spline") == 1);
    CHECK(of_spline.at("backlash").at("value_arcmin").get<double>() ==
          Approx(measured.at("backlash").at("value_arcmin").get<double>() / 1.01));
    CHECK(of_spline.at("first_stage").at("value_Nm_per_deg").get<double>() ==
          Approx(measured.at("first_stage").at("value_Nm_per_deg").get<double>() * 1.01 * 1.01));
    CHECK(measured.at("backlash").at("value_arcmin").get<double>() == Approx(6.2).epsilon(0.03));
    CHECK(measured.at("first_stage").at("value_Nm_per_deg").get<double>() == Approx(98.7).epsilon(0.02));
    CHECK(measured.at("second_stage").at("value_Nm_per_deg").get<double>() == Approx(182.8).epsilon(0.02));
    CHECK(measured.at("angle_step_arcmin").get<double>() == Approx(0.108));
    CHECK_THAT(load(run, folder).out,
               ContainsSubstring(
                   "measured: log.csv (current [A], position [counts], 0.119 N m/A, 2000 counts per turn, ratio 100)"));
}

TEST_CASE("load: a case that cannot be made is named and leaves the others as they are", "[load]")
{
    TemporaryFolder const folder;
    std::string const run = one_torque + "--surface tilted --kind draft --tilt 0,4 -o a.h5 ";
    auto const done = load(run + "--json", folder);
    INFO(done.err);
    CHECK(done.status == 1);
    std::string const reason = "no result for tilt 4 deg, kind \"draft\", surface \"tilted\": ";
    CHECK_THAT(done.err, ContainsSubstring("hdconj: 1 result is missing") && ContainsSubstring(reason));
    json const summary = json::parse(done.out);
    json const& cases = summary.at("load").at("cases");
    REQUIRE(cases.size() == 1);
    std::string notes;
    for (auto const& note : summary.at("notes"))
        notes += note.get<std::string>();
    CHECK_THAT(notes, ContainsSubstring(reason));
    auto const file = hdconj::test::open_file(folder / "a.h5");
    CHECK(hdconj::test::read(file, "/load/tilt").values.size() == 1);
    CHECK(H5Aexists_by_name(file, "/", "notes", H5P_DEFAULT) > 0);
    // the others are those of a run without it
    auto const without = load(one_torque + "--surface tilted --kind draft --tilt 0 -o b.h5 --json", folder);
    REQUIRE(without.status == 0);
    json const alone = json::parse(without.out).at("load").at("cases").back();
    for (auto const* key : {"tilt_deg", "backlash_offset_um", "backlash_arcmin", "rated"})
        CHECK(alone.at(key) == cases[0].at(key));
    // none at all is an error, and leaves nothing behind
    auto const none = load(one_torque + "--surface tilted --kind draft --tilt 4,5 -o none.h5", folder);
    CHECK(none.status == 1);
    CHECK_THAT(none.err, ContainsSubstring("draft"));
    CHECK_FALSE(std::filesystem::exists(folder / "none.h5"));
}

TEST_CASE("load: words about the other flanks stand above every bar", "[load][picture]")
{
    if (hdconj::test::is_missing("gnuplot"))
        return;
    TemporaryFolder const folder;
    auto const done = load(
        "'" HDCONJ_SOURCE_DIR "/data/scenes/type-50-elastic.toml' --no-curve --quiet -o a.h5 --picture a.svg", folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    std::string const svg = hdconj::test::content(folder / "a-pressure.svg");
    auto const words = svg.find("downwards: on the other flanks");
    REQUIRE(words != std::string::npos);
    auto const place = svg.rfind("translate(", words);
    double const baseline = std::stod(svg.substr(svg.find(',', place) + 1));
    double highest = 1e9;
    std::string const bar = "<polygon fill = 'rgb(  0, 114, 178)' points = '";
    for (auto at = svg.find(bar); at != std::string::npos; at = svg.find(bar, at + 1)) {
        std::istringstream corners(svg.substr(at + bar.size(), svg.find(" '", at + bar.size()) - at - bar.size()));
        double x = 0, y = 0;
        char comma = 0;
        while (corners >> x >> comma >> y)
            highest = std::min(highest, y);
    }
    CHECK(highest < 1e9);
    CHECK(baseline < highest);
}

}  // namespace hdconj::test::load_output_cases
