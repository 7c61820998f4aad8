// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj wedm` as a user meets it: files, streams, the same figures everywhere, the part and its files under a turn
// and without a tilt.
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <thread>

#include "hdconj/wire_files.hpp"
#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/sample_wire_program.hpp"

namespace hdconj::test::wedm_output_cases {

using hdconj::test::content;
using hdconj::test::Outcome;
using hdconj::test::TemporaryFolder;
using nlohmann::json;

namespace {

Outcome wedm(std::string const& arguments, TemporaryFolder const& folder)
{
    return hdconj::test::hdconj_run("wedm " + arguments, folder.path());
}

std::vector<std::string> lines_of(std::string const& text)
{
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// Blocks of an XYUV file, their words apart.
std::vector<std::vector<std::string>> blocks_of(std::string const& text)
{
    std::vector<std::vector<std::string>> blocks;
    for (auto const& line : lines_of(text)) {
        if (line.find(" U") == std::string::npos || line.front() == '(')
            continue;
        std::istringstream words(line);
        auto& block = blocks.emplace_back();
        for (std::string word; words >> word;)
            block.push_back(word);
    }
    return blocks;
}

/// Of a ring that is tilted, and has no side clearance.
constexpr char const* no_clearance = "circular_spline.backlash_offset = 0: the teeth of the ring are tilted";

json without_folder(json summary)
{
    summary.erase("folder");
    return summary;
}

}  // namespace

TEST_CASE("wedm names its folder after the drive and says so", "[wedm]")
{
    TemporaryFolder const folder;
    auto const done = wedm("--tilt 0.2", folder);
    CHECK(done.status == 0);
    CHECK(done.err.starts_with(std::string("hdconj: warning: ") + no_clearance));
    CHECK_THAT(done.out, ContainsSubstring("wire diameter                     0.1 mm") &&
                             ContainsSubstring("spark gap                       0.006 mm"));
    CHECK_THAT(done.out,
               ContainsSubstring("written into type-50-wedm\n") && ContainsSubstring("not verified on hardware"));
    CHECK(folder.names() == std::vector<std::string>{"type-50-wedm"});
    // the operator's summary is the same text
    auto const text = content(folder / "type-50-wedm" / "type-50_summary.txt");
    CHECK(done.out.starts_with(text));
    auto const listed = lines_of(content(folder / "type-50-wedm" / "files.txt"));
    std::size_t files = 0;
    for (auto const& entry : std::filesystem::directory_iterator(folder / "type-50-wedm")) {
        (void)entry;
        ++files;
    }
    CHECK(listed.size() == files);  // its heading stands for itself
}

TEST_CASE("wedm: --json prints one object with the figures of the text and --quiet prints nothing", "[wedm]")
{
    TemporaryFolder const folder;
    auto const text = wedm("--tilt 0.2 -o a", folder);
    auto const summary = wedm("--tilt 0.2 -o a --json", folder);
    CHECK(summary.status == 0);
    CHECK(summary.err.ends_with("wrote 7 files into a\n"));
    auto const figures = json::parse(summary.out);
    CHECK(figures.at("format") == "hdconj-wire-summary");
    CHECK(figures.at("folder") == "a");
    auto const shown = [&](char const* pattern, double value) {
        std::array<char, 64> digits{};
        std::snprintf(digits.data(), digits.size(), pattern, value);
        INFO(digits.data());
        CHECK_THAT(text.out, ContainsSubstring(digits.data()));
    };
    shown("face shift                   %.6f mm", figures.at("face_shift_mm"));
    shown("guide offset                 %.6f mm", figures.at("guide_offset_mm"));
    shown("wire tilt %.6f deg", figures.at("largest_wire_tilt_deg"));
    shown("cut off the faces               %.3g um", figures.at("checks").at("face_error_um"));
    shown("cut between the faces           %.3g um", figures.at("checks").at("middle_error_um"));
    shown("constant taper                   %.3g um", figures.at("checks").at("constant_taper_error_um"));
    CHECK(figures.at("face_shift_mm") == Approx(7 * std::tan(0.2 * std::acos(-1.0) / 180)).epsilon(1e-9));
    CHECK(figures.at("guide_offset_mm") == Approx(0.199).margin(5e-4));
    auto const& set_ups = figures.at("set_ups");
    REQUIRE(set_ups.size() == 1);
    shown("material at %.0f places", static_cast<double>(set_ups[0].at("residuals").size()));
    for (auto const& file : figures.at("files")) {
        auto const name = file.at("name").get<std::string>();
        CHECK_THAT(text.out, ContainsSubstring(name));
        CHECK(std::filesystem::file_size(folder / "a" / name) == file.at("bytes").get<std::uintmax_t>());
    }
    auto const quiet = wedm("--tilt 0.2 -o a --quiet", folder);
    CHECK(quiet.out + quiet.err == "");
    CHECK(folder.names() == std::vector<std::string>{"a"});
}

TEST_CASE("wedm of an elastic cup says how well the sections are known, and nothing of it without one", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const elastic = "'" HDCONJ_SOURCE_DIR
                                "/data/scenes/type-50-elastic.toml' --set slices.surface=tilted --set "
                                "wedm.wire_diameter=0.1 --set wedm.spark_gap=0.006 -o a ";
    auto const text = wedm(elastic, folder);
    CHECK(text.status == 0);
    CHECK_THAT(text.out, ContainsSubstring("error, bent sections"));
    double const known = json::parse(wedm(elastic + "--json", folder).out).at("cup_error_um").get<double>();
    CHECK(known > 0.1);  // [um], and no more than a hundredth of the 250 that the cup is bent by
    CHECK(known < 2.5);
    auto const plain = wedm("--tilt 0.2 -o b", folder);
    CHECK_THAT(plain.out, !ContainsSubstring("bent sections"));
    CHECK(json::parse(wedm("--tilt 0.2 -o b --json", folder).out).at("cup_error_um") == 0);
}

TEST_CASE("wedm gives the same figures and files for any number of threads and from a stored outline", "[wedm]")
{
    TemporaryFolder const folder;
    auto const one = wedm("--tilt 0.2 --threads 1 -o a --json --quiet", folder);
    auto const two = wedm("--tilt 0.2 --threads 2 -o b --json --quiet", folder);
    REQUIRE(one.status == 0);
    CHECK(without_folder(json::parse(one.out)) == without_folder(json::parse(two.out)));
    REQUIRE(
        hdconj::test::hdconj_run("solve --quiet --set tilt.angle_deg=0.2 --set slices.count=3 -o s.h5", folder.path())
            .status == 0);
    auto const stored = wedm("--from s.h5 -o c --json --quiet", folder);
    CHECK(without_folder(json::parse(one.out)) == without_folder(json::parse(stored.out)));
    for (auto const& entry : std::filesystem::directory_iterator(folder / "a")) {
        auto const name = entry.path().filename().string();
        INFO(name);
        CHECK(content(folder / "a" / name) == content(folder / "b" / name));
        CHECK(content(folder / "a" / name) == content(folder / "c" / name));
    }
}

TEST_CASE("wedm of a result with cases cuts the ring of its scene, and says what the ring of the case has", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const scene = "--set slices.count=3 --set tilt.angle_deg=0.2 ";
    REQUIRE(hdconj::test::hdconj_run("contact --quiet --no-errors -o c.h5 " + scene, folder.path()).status == 0);
    auto const own = json::parse(wedm(scene + "-o a --json --quiet", folder).out);
    auto const from = json::parse(wedm("--from c.h5 -o b --json --quiet", folder).out);
    for (std::string const face : {"lower_face", "upper_face"})
        CHECK(from.at(face) == own.at(face));
    CHECK(content(folder / "a" / "type-50_path.csv") == content(folder / "b" / "type-50_path.csv"));
    REQUIRE(own.at("warnings").size() == 1);
    CHECK_THAT(own.at("warnings")[0].get<std::string>(), ContainsSubstring(no_clearance));
    REQUIRE(from.at("warnings").size() == 2);
    // contact raises both: the flanks would interfere, and the tip circle cuts in
    auto const warning = from.at("warnings")[0].get<std::string>();
    CHECK_THAT(from.at("warnings")[1].get<std::string>(),
               ContainsSubstring("contact in c.h5 found that teeth enter the flanks by 9.") &&
                   ContainsSubstring(" um, most at z = ") &&
                   ContainsSubstring("write circular_spline.backlash_offset = 0.009") &&
                   ContainsSubstring("circular_spline.inner_radius = 25.033"));
    CHECK_THAT(warning, ContainsSubstring("c.h5 holds the ring of a case of contact") &&
                            ContainsSubstring("a side clearance of 0.009") &&
                            ContainsSubstring("in place of 0.000000 mm (+9.") &&
                            ContainsSubstring("a tip circle at z = 0 of 25.033") &&
                            ContainsSubstring("circular_spline.inner_radius = 25.033") &&
                            ContainsSubstring("um off the one that is cut") && !ContainsSubstring("a tilt of"));
    CHECK_THAT(content(folder / "b" / "type-50_summary.txt"), ContainsSubstring("WARNING: " + warning));
    CHECK_THAT(content(folder / "b" / "type-50_setup.txt"), ContainsSubstring("WARNING  c.h5 holds the ring"));
    // a case with the other kind of tilt says nothing of this ring
    REQUIRE(
        hdconj::test::hdconj_run("contact --quiet --no-errors --kind draft -o d.h5 " + scene, folder.path()).status ==
        0);
    auto const draft = json::parse(wedm("--from d.h5 -o d --json --quiet", folder).out);
    REQUIRE(draft.at("warnings").size() == 2);
    for (auto const& each : draft.at("warnings"))
        CHECK_THAT(each.get<std::string>(), !ContainsSubstring("found that teeth enter"));
}

TEST_CASE("wedm of a result whose cup bends says which keys make its ring of a scene without a cone", "[wedm]")
{
    TemporaryFolder const folder;
    auto const warning_of = [&](std::string const& name, std::string const& keys) {
        auto const loaded =
            hdconj::test::hdconj_run("load --quiet --no-errors --no-curve -o " + name + ".h5 " + keys, folder.path());
        REQUIRE(loaded.status == 0);
        return wedm("--from " + name + ".h5 --dialect csv -o " + name, folder).err;
    };
    std::string const bare = warning_of("bare", ""), begin = "write ";
    REQUIRE_THAT(bare, ContainsSubstring("the outline of the bent cup"));
    std::size_t const from = bare.find(begin) + begin.size();
    std::string keys = bare.substr(from, bare.find(" into the scene") - from);
    keys = std::regex_replace(std::regex_replace(keys, std::regex(", "), " --set "), std::regex(" = "), "=");
    INFO(keys);
    CHECK_THAT(keys, ContainsSubstring("coning.bottom_to_middle=9"));
    CHECK_THAT(warning_of("bent", "--set " + keys), !ContainsSubstring("holds the ring of a case"));
}

TEST_CASE("wedm warns of a cone without side clearance, by the study that knows it where there is one", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const coned = "--set coning.model=linear --set coning.bottom_to_middle=9 --set slices.count=5 ";
    auto const alone = wedm(coned + "-o a", folder);
    CHECK(alone.status == 0);
    CHECK_THAT(alone.err, ContainsSubstring("hdconj: warning: circular_spline.backlash_offset = 0: the cup cones") &&
                              ContainsSubstring("hdconj contact"));
    CHECK_THAT(alone.out, ContainsSubstring("WARNING: circular_spline.backlash_offset = 0: the cup cones"));
    CHECK(wedm(coned + "--set circular_spline.backlash_offset=0.07 --set circular_spline.inner_radius=25.15 "
                       "--dialect csv -o b",
               folder)
              .err.empty());
    CHECK(wedm(coned + "--part flexspline --dialect csv -o c", folder).err.empty());
    // too little of it only a study finds
    std::string const little = coned + "--set circular_spline.backlash_offset=0.02 ";
    REQUIRE(hdconj::test::hdconj_run("contact --quiet --no-errors -o c.h5 " + little, folder.path()).status == 0);
    CHECK(wedm(little + "--dialect csv -o d", folder).err.empty());
    auto const from = wedm("--from c.h5 --dialect csv -o e", folder);
    CHECK_THAT(from.err,
               ContainsSubstring("hdconj: warning: circular_spline.backlash_offset = 0.02: contact in c.h5 found"));
    // what it advises is enough
    std::string const keys = from.err.substr(from.err.rfind("write ") + 6);
    double const clearance = std::stod(keys.substr(keys.find("= ") + 2)),
                 tip = std::stod(keys.substr(keys.rfind("= ") + 2));
    auto const again =
        hdconj::test::hdconj_run("contact --quiet --no-errors -o f.h5 " + coned +
                                     "--set circular_spline.backlash_offset=" + std::to_string(clearance) +
                                     " --set circular_spline.inner_radius=" + std::to_string(tip),
                                 folder.path());
    REQUIRE(again.status == 0);
    CHECK(wedm("--from f.h5 --dialect csv -o g", folder).err.empty());
}

TEST_CASE("wedm --strict refuses a ring whose tilt takes the tip circle into the flexspline", "[wedm]")
{
    TemporaryFolder const folder;
    auto const done = wedm("--tilt 10 --strict --json --quiet -o a", folder);
    CHECK(done.status == 1);
    auto const notes = json::parse(done.out).at("judgement").dump();
    CHECK_THAT(notes, ContainsSubstring("late-mesh") && ContainsSubstring("the tilt makes the tip circle"));
    CHECK(wedm("--tilt 0.2 --strict --quiet -o b", folder).status == 0);
}

TEST_CASE("wedm without a tilt writes U as X and V as Y byte for byte", "[wedm]")
{
    TemporaryFolder const folder;
    REQUIRE(wedm("--tilt 0 --quiet -o a", folder).status == 0);
    for (std::string const plane : {"face", "guide"}) {
        auto const blocks = blocks_of(content(folder / "a" / ("type-50_xyuv_" + plane + "_pass1.ngc")));
        REQUIRE(blocks.size() > 7000);
        CHECK(std::all_of(blocks.begin(), blocks.end(), [](auto const& block) {
            return block.size() == 6 && block[2].substr(1) == block[4].substr(1) &&
                   block[3].substr(1) == block[5].substr(1);
        }));
    }
    CHECK(std::filesystem::exists(folder / "a" / "type-50_2d_pass1.iso"));
    REQUIRE(wedm("--tilt 0 --quiet --dialect 3b --set wedm.tolerance=0.001 -o b", folder).status == 0);
    CHECK(content(folder / "b" / "type-50_lower_pass1.3b") == content(folder / "b" / "type-50_upper_pass1.3b"));
}

TEST_CASE("wedm: another first space turns the path by pitches", "[wedm]")
{
    TemporaryFolder const folder;
    REQUIRE(wedm("--tilt 0.2 --dialect xyuv-guide --decimals 6 --set wedm.stop_before=0 --quiet -o a", folder).status ==
            0);
    REQUIRE(
        wedm("--tilt 0.2 --dialect xyuv-guide --decimals 6 --set wedm.stop_before=0 --set wedm.start=1 --quiet -o b",
             folder)
            .status == 0);
    auto const first = blocks_of(content(folder / "a" / "type-50_xyuv_guide_pass1.ngc"));
    auto const second = blocks_of(content(folder / "b" / "type-50_xyuv_guide_pass1.ngc"));
    REQUIRE(first.size() == second.size());
    double const pitch = 2 * std::acos(-1.0) / 202, c = std::cos(pitch), s = std::sin(pitch);
    double worst = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        for (std::size_t k : {std::size_t{2}, std::size_t{4}}) {  // X Y, then U V
            std::size_t const at = first[i].size() - 6 + k;
            double const x = std::stod(first[i][at].substr(1)), y = std::stod(first[i][at + 1].substr(1));
            worst = std::max({worst, std::abs(c * x + s * y - std::stod(second[i][at].substr(1))),
                              std::abs(-s * x + c * y - std::stod(second[i][at + 1].substr(1)))});
        }
    }
    CHECK(worst < 2e-6);  // both are rounded to 1e-6 mm
}

TEST_CASE("wedm cuts the flexspline in two set-ups that appear together", "[wedm]")
{
    TemporaryFolder const folder;
    auto const done = wedm("--part flexspline --set wedm.overlap=0.1 --json --quiet", folder);
    REQUIRE(done.status == 0);
    CHECK(folder.names() == std::vector<std::string>{"type-50-flexspline-wedm"});
    auto const figures = json::parse(done.out);
    auto const& set_ups = figures.at("set_ups");
    REQUIRE(set_ups.size() == 2);
    CHECK(set_ups[0].at("first_space") == 0);
    CHECK(set_ups[0].at("spaces") == 100);
    CHECK(set_ups[1].at("first_space") == 100);
    CHECK(set_ups[1].at("spaces") == 100);
    CHECK(set_ups[1].at("part_turned_deg") == 180);
    CHECK(figures.at("external") == true);
    CHECK(figures.at("thickness_mm") == 8);  // flexspline.cup.tooth_width; the circular spline is 7 mm wide
    // half a turn is a whole number of pitches of 200 teeth: both set-ups have one program
    auto const file = [&](std::string const& name) {
        return content(folder / "type-50-flexspline-wedm" / ("type-50-flexspline_" + name));
    };
    CHECK(blocks_of(file("setup1_xyuv_face_pass1.ngc")) == blocks_of(file("setup2_xyuv_face_pass1.ngc")));
    CHECK(file("setup1_twoplane_pass1.nc") == file("setup2_twoplane_pass1.nc"));
    CHECK_THAT(file("summary.txt"),
               ContainsSubstring("set-up 2 of 2: 100 spaces from 100 clockwise, part turned 180 deg") &&
                   ContainsSubstring("0.1 mm   overlap beyond"));
}

TEST_CASE("wedm cuts the flexspline that a given circular spline calls for", "[wedm]")
{
    TemporaryFolder const folder;
    auto const done = wedm("'" HDCONJ_SOURCE_DIR
                           "/data/scenes/circular-spline-given.toml' --part flexspline --set wedm.wire_diameter=0.1 "
                           "--set wedm.spark_gap=0.006 --quiet -o a",
                           folder);
    CHECK(done.status == 0);
    CHECK(done.err.empty());
    CHECK(std::filesystem::exists(folder / "a" / "circular-spline-given-flexspline_setup2_planes.dxf"));
}

TEST_CASE("wedm tells a pass that leaves more than the next one takes", "[wedm]")
{
    TemporaryFolder const folder;
    auto const rough = wedm("--tilt 0.2 --set 'wedm.passes=[[0.05], [0.048], [0]]' --dialect csv -o a", folder);
    CHECK(rough.status == 0);
    CHECK_THAT(rough.out, ContainsSubstring("WARNING: pass 1 leaves up to 0.0") &&
                              ContainsSubstring("more than the layer of 0.002 mm that pass 2 is to take"));
    auto const fine = wedm("--tilt 0.2 --set 'wedm.passes=[[0.02], [0]]' --dialect csv -o a", folder);
    CHECK(fine.out.find("WARNING: pass") == std::string::npos);
}

TEST_CASE("wedm leaves out a dialect with a grid of its own that loses a block unless it was asked for by name",
          "[wedm]")
{
    TemporaryFolder const folder;
    // a drafted corner is a point in the lower face and an arc in the upper one
    std::string const drafted =
        "--tilt 0.1 --set tilt.kind=draft --set circular_spline.root_clearance=0.02 --set wedm.residual_limit=0.06 ";
    std::string const fine = drafted + "--set wedm.tolerance=0.0008 ";
    auto const all = wedm(fine + "--json --quiet -o a", folder);
    REQUIRE(all.status == 0);
    CHECK(all.err.empty());
    auto const summary = json::parse(all.out);
    REQUIRE(summary.at("warnings").size() == 2);
    CHECK_THAT(summary.at("warnings")[0].get<std::string>(), ContainsSubstring("shorter than 20 units"));
    REQUIRE(summary.at("left_out").size() == 1);
    CHECK_THAT(summary.at("left_out")[0].get<std::string>(),
               ContainsSubstring("dialect 3b: pass 1, block ") &&
                   ContainsSubstring("no length in the lower plane when rounded to 0.001 mm"));
    CHECK(summary.at("files").size() == 7);  // of 9
    CHECK(std::filesystem::exists(folder / "a" / "type-50_twoplane_pass1.nc"));
    CHECK_FALSE(std::filesystem::exists(folder / "a" / "type-50_lower_pass1.3b"));
    CHECK_THAT(content(folder / "a" / "type-50_summary.txt"), ContainsSubstring("left out: dialect 3b"));
    // by name: an error, and the tolerance that it advises is one that works
    auto const named = wedm(fine + "--dialect csv,3b --quiet -o b", folder);
    CHECK(named.status == 1);
    CHECK_THAT(named.err, ContainsSubstring("3b, pass 1, block ") && ContainsSubstring("write wedm.tolerance = ") &&
                              ContainsSubstring("or another dialect"));
    CHECK(named.err.find("decimals") == std::string::npos);
    CHECK(folder.names() == std::vector<std::string>{"a"});
    auto const from = named.err.find("wedm.tolerance = ");
    REQUIRE(from != std::string::npos);
    auto const advice = named.err.substr(from, named.err.find(',', from) - from);
    CHECK(wedm(drafted + "--dialect csv,3b --quiet -o b --set '" + advice + "'", folder).status == 0);
    CHECK(std::filesystem::exists(folder / "b" / "type-50_lower_pass1.3b"));
}

TEST_CASE("wedm leaves out the dialect whose grid is too coarse for the tolerance, and says what to write for it",
          "[wedm]")
{
    TemporaryFolder const folder;
    std::string const cause =
        "rounding to 3 decimals moves a point by up to 0.000707107 mm, more than the tolerance of 0.0005 mm";
    auto const all = wedm("--tilt 0.2 --set circular_spline.backlash_offset=0.01 -o a", folder);
    CHECK(all.status == 0);
    CHECK_THAT(all.out, ContainsSubstring("left out: dialect 3b: grid of 0.001 mm: " + cause) &&
                            ContainsSubstring("--dialect 3b says what to write for it"));
    CHECK(all.out.find("WARNING") == std::string::npos);  // nothing is wrong with the part
    auto const named = wedm("--tilt 0.2 --dialect 3b -o b", folder);
    CHECK(named.status == 1);
    CHECK_THAT(named.err, ContainsSubstring("3b, grid of 0.001 mm: " + cause) &&
                              ContainsSubstring("write wedm.tolerance = 0.0008, or another dialect"));
    CHECK(wedm("--tilt 0.2 --dialect 3b --set wedm.tolerance=0.0008 -o b", folder).status == 0);
    auto const decimals = wedm("--tilt 0.2 --decimals 3 -o c", folder);
    CHECK(decimals.status == 2);
    CHECK_THAT(decimals.err, ContainsSubstring(cause));
}

TEST_CASE("wedm: blocks have at least 20 units of the last digit, or a warning counts those that have not", "[wedm]")
{
    TemporaryFolder const folder;
    for (std::string const arguments :
         {"--tilt 0.2", "--tilt 0.2 --set wedm.stop_before=1.0015 --set wedm.overlap=0.0961",
          "--tilt 0.2 --decimals 3 --set wedm.tolerance=0.001",
          "--tilt 0.3 --set tilt.kind=draft --set wedm.surface_limit=0.002"}) {
        INFO(arguments);
        auto const done = wedm(arguments + " --dialect xyuv-guide,xyuv-face --json --quiet -o a", folder);
        REQUIRE(done.status == 0);
        auto const summary = json::parse(done.out);
        double const unit = arguments.find("decimals 3") != std::string::npos ? 1e-3 : 1e-4;
        std::size_t shorter = 0;
        for (std::string const plane : {"face", "guide"}) {
            auto const blocks = blocks_of(content(folder / "a" / ("type-50_xyuv_" + plane + "_pass1.ngc")));
            auto const value = [&](std::size_t i, std::size_t k) { return std::stod(blocks[i].at(k).substr(1)); };
            for (std::size_t i = 1; i < blocks.size(); ++i) {
                auto const length = [&](std::size_t k) {
                    return std::hypot(value(i, k) - value(i - 1, k), value(i, k + 1) - value(i - 1, k + 1));
                };
                shorter += std::min(length(2), length(4)) < 20 * unit - 1.5 * unit ? 1 : 0;
            }
        }
        bool told = false;
        for (auto const& warning : summary.at("warnings"))
            told = told || warning.get<std::string>().find("shorter than 20 units") != std::string::npos;
        CHECK(told == (shorter > 0));
    }
}

TEST_CASE("wedm: where more decimals keep a block the message says how many", "[wedm]")
{
    TemporaryFolder const folder;
    std::string const drafted =
        "--tilt 1.2 --set tilt.kind=draft --set wedm.surface_limit=0.005 --set wedm.wire_diameter=0.07 --dialect "
        "xyuv-face --quiet -o a ";
    auto const few = wedm(drafted, folder);
    CHECK(few.status == 1);
    CHECK_THAT(few.err, ContainsSubstring("xyuv-face, pass 1, block ") &&
                            ContainsSubstring("rounded to 0.0001 mm; write wedm.decimals = 5, or another dialect"));
    CHECK(folder.names().empty());
    CHECK(wedm(drafted + "--decimals 5", folder).status == 0);
    // of several dialects the message says how many keep the blocks of all
    std::string const all =
        "--tilt 0.8 --set tilt.kind=draft --set wedm.surface_limit=0.005 --set wedm.wire_diameter=0.05 --set "
        "wedm.tolerance=2e-4 --quiet -o b ";
    std::string const named = all + "--dialect xyuv-guide,xyuv-face ";
    CHECK_THAT(wedm(named, folder).err, ContainsSubstring("xyuv-guide, pass 1, block ") &&
                                            ContainsSubstring("write wedm.decimals = 6, or another dialect"));
    CHECK(wedm(named + "--decimals 5", folder).status == 1);
    CHECK(wedm(named + "--decimals 6", folder).status == 0);
    // where none was named the others are written, and these are told
    auto const rest = wedm(all.substr(0, all.find("--quiet")) + "-o c", folder);
    CHECK(rest.status == 0);
    CHECK_THAT(rest.out, ContainsSubstring("left out: dialect xyuv-face: pass 1, block ") &&
                             ContainsSubstring("with wedm.decimals = 6 it is written"));
    CHECK(std::filesystem::exists(folder / "c" / "type-50_path.csv"));
}

TEST_CASE("wedm that fails leaves the folder as it was", "[wedm]")
{
    TemporaryFolder const folder;
    REQUIRE(wedm("--tilt 0.2 --dialect csv --quiet -o a", folder).status == 0);
    auto const before = content(folder / "a" / "type-50_path.csv");
    // no file may grow beyond 100 blocks of 1024 bytes: the disk is full, as far as the program can tell
    auto const full =
        hdconj::test::run("ulimit -f 100; " + hdconj::test::program + " wedm --quiet -o a", folder.path());
    CHECK(full.status == 1);
    CHECK_THAT(full.err, ContainsSubstring("type-50_planes.dxf") && ContainsSubstring("File too large"));
    CHECK(wedm("--tilt 0.2 --set wedm.largest_travel=20 -o a", folder).status == 1);
    CHECK(content(folder / "a" / "type-50_path.csv") == before);
    CHECK(folder.names() == std::vector<std::string>{"a"});
}

TEST_CASE("a killed process leaves the old folder of wire files or the new one", "[wedm]")
{
    TemporaryFolder const folder;
    auto const one = hdconj::sample::wire_ring(hdconj::sample::wire_tilt, 16, {0});
    auto const other = hdconj::sample::wire_ring(hdconj::sample::wire_tilt, 20, {0});
    auto const target = folder / "out";
    hdconj::write_wire_files({one}, folder / "one");
    hdconj::write_wire_files({other}, folder / "other");
    hdconj::write_wire_files({one}, target);
    auto const same = [&](std::string const& with) {
        for (auto const& entry : std::filesystem::directory_iterator(folder / with)) {
            auto const name = entry.path().filename().string();
            if (!std::filesystem::exists(target / name) || content(target / name) != content(folder / with / name))
                return false;
        }
        return true;
    };
    std::mt19937 random(1);
    std::uniform_int_distribution<long> wait(0, 30000);
    constexpr int times = 40;
    for (int i = 0; i < times; ++i) {
        pid_t const child = ::fork();
        if (child == 0) {
            for (;;) {
                hdconj::write_wire_files({other}, target);
                hdconj::write_wire_files({one}, target);
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(wait(random)));
        ::kill(child, SIGKILL);
        int waited = 0;
        ::waitpid(child, &waited, 0);
        REQUIRE(hdconj::test::status_of_wait(waited) == 128 + SIGKILL);
        REQUIRE((same("one") || same("other")));
    }
    // what is left besides is hidden
    for (auto const& name : folder.names())
        CHECK((name == "one" || name == "other" || name == "out" || name.front() == '.'));
}

}  // namespace hdconj::test::wedm_output_cases
