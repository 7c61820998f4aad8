// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a wire program, read back here without the program's own readers; tests/cli/wire_readers.cpp has other
// people's.
#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "hdconj/accuracy_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/wire_files.hpp"
#include "support/catch.hpp"
#include "support/sample_wire_program.hpp"
#include "support/temporary_folder.hpp"
#include "wedm/planes.hpp"
#include "wedm/posts/file_checks.hpp"

namespace hdconj::test::wire_files_cases {

using test::content;
using test::TemporaryFolder;

namespace {

/// Texts of all files by name.
std::map<std::string, std::string> texts_of(WireProgram const& program, std::vector<std::string> const& dialects = {})
{
    TemporaryFolder const folder;
    auto const files = write_wire_files({program}, folder / "out", dialects);
    std::map<std::string, std::string> texts;
    for (auto const& file : files) {
        texts[file.name] = content(folder / "out" / file.name);
        CHECK(texts[file.name].size() == file.bytes);
    }
    return texts;
}

std::vector<std::string> lines_with(std::string const& text, std::string const& part)
{
    std::vector<std::string> found;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        if (line.find(part) != std::string::npos)
            found.push_back(line);
    }
    return found;
}

/// Lines that begin with N: the blocks of RS274.
std::vector<std::string> numbered(std::string const& text)
{
    auto found = lines_with(text, "N");
    std::erase_if(found, [](std::string const& line) { return line.front() != 'N'; });
    return found;
}

void check_refused(WireProgram const& program, std::string const& cause, std::vector<std::string> const& dialects = {})
{
    TemporaryFolder const folder;
    try {
        write_wire_files({program}, folder / "out", dialects);
        FAIL("not refused: " << cause);
    } catch (NumericalError const& error) {
        CHECK_THAT(error.what(), ContainsSubstring(cause));
    }
    CHECK(folder.names().empty());
}

}  // namespace

TEST_CASE("the square hole gives the blocks of the notes in every dialect", "[wire]")
{
    auto const texts = texts_of(sample::square_hole());
    CHECK(numbered(texts.at("square_xyuv_guide_pass1.ngc")) ==
          std::vector<std::string>{
              "N10 G0 X0.0000 Y0.0000 U0.0000 V0.0000", "N20 G1 X0.0000 Y-5.0078 U0.0000 V-4.8088",
              "N30 G1 X5.0078 Y-5.0078 U4.8088 V-4.8088", "N40 G1 X5.0078 Y5.0078 U4.8088 V4.8088",
              "N50 G1 X-5.0078 Y5.0078 U-4.8088 V4.8088", "N60 G1 X-5.0078 Y-5.0078 U-4.8088 V-4.8088",
              "N70 G1 X0.0000 Y-5.0078 U0.0000 V-4.8088", "N80 G1 X0.0000 Y0.0000 U0.0000 V0.0000"});
    auto const& guide = texts.at("square_xyuv_guide_pass1.ngc");
    CHECK(guide.find("%\n(hdconj guide-plane XYUV absolute mm)\n") == 0);
    CHECK(guide.find("\n(AXIS,XY_Z_POS,-20.000)\n(AXIS,UV_Z_POS,37.000)\nG17 G21 G90 G40 G49 G61 G94\nF2.0\nN10 ") !=
          std::string::npos);
    CHECK(guide.find("V0.0000\nM2\n%\n") + 13 == guide.size());
    auto const& face = texts.at("square_xyuv_face_pass1.ngc");
    CHECK(face.find("\n(AXIS,XY_Z_POS,0.000)\n(AXIS,UV_Z_POS,7.000)\n") != std::string::npos);
    CHECK(face.find("\nN30 G1 X4.9380 Y-4.9380 U4.9136 V-4.9136\n") != std::string::npos);
    CHECK(texts.at("square_rel_pass1.iso")
              .find("%\nO0001\nG90 G21\nG92 X0.0000 Y0.0000\nG01 X0.0000 Y-4.9380 U0.0000 V0.0244\n"
                    "G01 X4.9380 Y-4.9380 U-0.0244 V0.0244\n") == 0);
    CHECK(texts.at("square_twoplane_pass1.nc")
              .find("G91;\nG92 X0.0000 Y0.0000;\nG01 X0.0000 Y-4.9380:G01 X0.0000 Y-4.9136;\n"
                    "G01 X4.9380 Y0.0000:G01 X4.9136 Y0.0000;\n") == 0);
    CHECK(texts.at("square_lower_pass1.3b") ==
          "B0 B4938 B4938 GY L4\nB4938 B0 B4938 GX L1\nB0 B9876 B9876 GY L2\nB9876 B0 B9876 GX L3\n"
          "B0 B9876 B9876 GY L4\nB4938 B0 B4938 GX L1\nB0 B4938 B4938 GY L2\nDD\n");
    CHECK(texts.count("square_2d_pass1.iso") == 0);
}

TEST_CASE("without a tilt U is X and V is Y, byte for byte, and the 2-D dialect is written", "[wire]")
{
    auto const texts = texts_of(sample::wire_ring(0));
    for (char const* const name : {"ring_xyuv_guide_pass3.ngc", "ring_xyuv_face_pass3.ngc"}) {
        auto const rows = numbered(texts.at(name));
        REQUIRE(rows.size() > 1000);
        for (auto const& row : rows) {
            std::string const lower = row.substr(row.find(" X") + 2, row.find(" U") - row.find(" X") - 2);
            std::string upper = row.substr(row.find(" U") + 2);
            upper.replace(upper.find('V'), 1, "Y");
            REQUIRE(lower == upper);
        }
    }
    CHECK(lines_with(texts.at("ring_lower_pass1.3b"), "B") == lines_with(texts.at("ring_upper_pass1.3b"), "B"));
    auto const& flat = texts.at("ring_2d_pass1.iso");
    CHECK(lines_with(flat, "G41 D1 G01 X").size() ==
          1);  // the wire is left of the part's contour, going counter-clockwise
    CHECK(lines_with(texts.at("ring_2d_pass2.iso"), "G42 D2 G01 X").size() == 1);
    CHECK(lines_with(flat, "G40 G01 X").size() == 1);
    CHECK(lines_with(flat, "(set D1 to 0.076000 mm").size() == 1);
    CHECK_THROWS_AS(texts_of(sample::wire_ring(), {"iso-2d"}), InputError);
}

TEST_CASE("every dialect stops before the slug drops, and reads that back", "[wire]")
{
    auto program = sample::wire_ring(0);
    for (WireStop const stop : {WireStop::always, WireStop::optional}) {
        program.stop = stop;
        auto const texts = texts_of(program);
        bool const always = stop == WireStop::always;
        auto const count = [&](std::string const& name, std::string const& word) {
            auto const lines = lines_with(texts.at(name), word);
            return std::ranges::count(lines, word);
        };
        for (auto const& [name, word] :
             std::map<std::string, std::string>{{"ring_xyuv_guide_pass", always ? "M0" : "M1"},
                                                {"ring_xyuv_face_pass", always ? "M0" : "M1"},
                                                {"ring_rel_pass", always ? "M00" : "M01"},
                                                {"ring_2d_pass", always ? "M00" : "M01"},
                                                {"ring_twoplane_pass", always ? "M00;" : "M01;"},
                                                {"ring_lower_pass", "D"},
                                                {"ring_upper_pass", "D"}}) {
            INFO(name << " " << word);
            std::string const ending = texts.contains(name + "1.ngc")   ? ".ngc"
                                       : texts.contains(name + "1.iso") ? ".iso"
                                       : texts.contains(name + "1.nc")  ? ".nc"
                                                                        : ".3b";
            CHECK(count(name + "1" + ending, word) == 1);
            CHECK(count(name + "2" + ending, word) == 0);  // the slug has dropped
        }
        CHECK(lines_with(texts.at("ring_planes.dxf"), "STOP").size() == 2);  // the layer, and a line on it
        CHECK(lines_with(texts.at("ring_path.csv"), ",stop,").size() == 1);
    }
}

TEST_CASE("a stop that is lost, moved or another one than asked for is noticed when a file is read back", "[wire]")
{
    auto const program = sample::wire_ring(0);
    auto optional = program;
    optional.stop = WireStop::optional;
    for (auto const& post : wedm::wire_posts()) {
        INFO(post.dialect.name);
        auto texts = post.write(program, "ring");
        CHECK_NOTHROW(wedm::check_paths(post, program, post.read(texts, program)));
        std::string const name(post.dialect.name);
        bool const has_words = name != "dxf" && name != "csv" && name != "3b";
        if (has_words)
            CHECK_THROWS_WITH(post.read(texts, optional), ContainsSubstring("another stop than asked for"));
        for (auto& file : texts)
            for (std::string const stop : {"\nM0\n", "\nM00\n", "\nM00;\n", "\nD\n", "LINE\n8\nSTOP\n", ",stop,"})
                if (auto const at = file.text.find(stop); at != std::string::npos)
                    file.text.replace(at, stop.size(),
                                      stop == ",stop," ? ",contour,"
                                      : stop[0] == 'L' ? "LINE\n8\nSYNC\n"
                                                       : "\n");
        CHECK_THROWS_WITH(wedm::check_paths(post, program, post.read(texts, program)), ContainsSubstring("stops"));
    }
}

TEST_CASE("no dialect is written whose last digit is too coarse for the tolerance, and all say it alike", "[wire]")
{
    auto program = sample::wire_ring();
    program.tolerance = 0.0005;
    std::string const cause =
        "rounding to 3 decimals moves a point by up to 0.000707107 mm, more than the tolerance of 0.0005 mm";
    auto const unfit = unfit_dialects({program});
    REQUIRE(unfit.size() == 1);
    CHECK(unfit[0].name == "3b");
    CHECK(unfit[0].cause == cause);
    CHECK_FALSE(texts_of(program).contains("ring_lower_pass1.3b"));
    CHECK_THROWS_WITH(texts_of(program, {"3b"}), ContainsSubstring(cause) && ContainsSubstring("wedm.tolerance"));
    program.decimals = 3;
    for (std::string const dialect : {"xyuv-guide", "xyuv-face", "relative-uv", "two-plane"}) {
        INFO(dialect);
        CHECK_THROWS_WITH(texts_of(program, {dialect}),
                          ContainsSubstring(cause) && ContainsSubstring("write wedm.decimals = 4"));
    }
    CHECK_NOTHROW(texts_of(program, {"csv", "dxf"}));
    try {
        (void)builtin_scene({"wedm.decimals=3"});
        FAIL("not refused");
    } catch (InputError const& error) {
        CHECK_THAT(describe(error.faults()), ContainsSubstring(cause));
    }
    program.tolerance = 0.0008;
    CHECK(texts_of(program).contains("ring_lower_pass1.3b"));
}

TEST_CASE("what the cut of a rounded file may be off the faces holds the path's error and the drift, in all outputs",
          "[wire]")
{
    TemporaryFolder const folder;
    auto program = sample::wire_ring();
    program.tolerance = 0.0008;
    program.figures.face_error = 0.00064;
    auto const files = write_wire_files({program}, folder / "out", {"csv", "3b"});
    auto const rounded = std::find_if(files.begin(), files.end(), [](WireFile const& f) { return f.dialect == "3b"; });
    REQUIRE(rounded != files.end());
    CHECK(rounded->drift > 0.0003);
    for (auto const& file : files)
        CHECK(file.cut_error == program.figures.face_error + file.drift);
    auto const summary = nlohmann::json::parse(summary_json(WireSetUps{program}, files));
    REQUIRE(summary.at("warnings").size() == 1);  // csv is not rounded and keeps the tolerance
    auto const warning = summary.at("warnings")[0].get<std::string>();
    CHECK_THAT(warning, ContainsSubstring("dialect 3b") && ContainsSubstring("wedm.tolerance = 0.8 um"));
    CHECK(summary.at("files").back().at("cut_error_um") == Approx(1000 * rounded->cut_error));
    CHECK_THAT(content(folder / "out" / "ring_summary.txt"), ContainsSubstring("WARNING: " + warning));
    for (std::string const sheet : {"ring_setup.txt", "ring_setup.svg"}) {
        auto const text = content(folder / "out" / sheet);
        CHECK_THAT(text, ContainsSubstring("dialect 3b") && ContainsSubstring("WARNING"));
        CHECK_THAT(text, ContainsSubstring("at most 0.64 um off the faces, corners apart; 1.") &&
                             ContainsSubstring(" um with the drift of files; tolerance 0.8 um"));
    }
}

TEST_CASE("a setup sheet says in text and picture what is clamped and cut", "[wire]")
{
    TemporaryFolder const folder;
    auto program = sample::wire_ring();
    program.start_hole_radius = 0.5;
    write_wire_files({program}, folder / "out");
    auto const text = content(folder / "out" / "ring_setup.txt");
    auto const picture = content(folder / "out" / "ring_setup.svg");
    for (std::string const words :
         {"ring: wire setup sheet", "0.1 mm, spark gap 0.006 mm", "SMALLER than the lower face",
          "20 mm below the lower face", "30 mm above the upper face", "radius 0.5 mm, wire vertical",
          "pass 1 counter-clockwise, seen from above", "M0 in pass 1 at x ", "0.076000", "reversed", "ring_planes.dxf",
          "ezdxf, GDAL", "not verified on hardware: run it dry first"}) {
        INFO(words);
        CHECK_THAT(text, ContainsSubstring(words));
        CHECK_THAT(picture, ContainsSubstring(words));
    }
    std::istringstream lines(text);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        CHECK(line.size() <= 110);
    CHECK(count < 60);  // one page
    CHECK(lines_with(content(folder / "out" / "files.txt"), "ring_setup").size() == 2);
    program.name = "a<b & c";
    CHECK_THAT(setup_sheet_svg({program}), ContainsSubstring("a&lt;b &amp; c"));
}

TEST_CASE("coordinates have no exponent, no negative zero and all their decimals", "[wire]")
{
    auto program = sample::square_hole();
    for (auto& move : program.passes[0].moves) {
        move.lower.x() += 1e-17;
        move.upper.x() -= 4.9e-5;
    }
    program.passes[0].moves.front().upper = program.passes[0].moves.front().lower;
    program.passes[0].moves.back().upper = program.passes[0].moves.back().lower = program.passes[0].moves.front().lower;
    auto const texts = texts_of(program);
    for (auto const& [name, text] : texts) {
        INFO(name);
        CHECK(text.find("-0.0000 ") == std::string::npos);
        CHECK(text.find("1e-") == std::string::npos);
    }
    CHECK(texts.at("square_xyuv_face_pass1.ngc").find("N20 G1 X0.0000 Y-4.9380 U0.0000 V-4.9136") != std::string::npos);
    program.decimals = 3;
    CHECK(texts_of(program, {"xyuv-face"})
              .at("square_xyuv_face_pass1.ngc")
              .find("N20 G1 X0.000 Y-4.938 U0.000 V-4.914") != std::string::npos);
}

TEST_CASE("block numbers stay within five digits", "[wire]")
{
    auto const coarse = texts_of(sample::wire_ring(), {"xyuv-face"}).at("ring_xyuv_face_pass1.ngc");
    CHECK(lines_with(coarse, "N10 ").size() == 1);
    auto const fine =
        texts_of(sample::wire_ring(sample::wire_tilt, 480, {0}), {"xyuv-face"}).at("ring_xyuv_face_pass1.ngc");
    CHECK(lines_with(fine, "N11520 ").size() == 1);
    CHECK(lines_with(fine, "N100000 ").empty());
}

TEST_CASE("drift along the path is below a unit and reported for every file", "[wire]")
{
    TemporaryFolder const folder;
    auto const files = write_wire_files({sample::wire_ring()}, folder / "out");
    REQUIRE(files.size() == 1 + 3 + 3 + 2 + 3 + 3 + 6);
    for (auto const& file : files) {
        INFO(file.name << " " << file.drift);
        CHECK(file.blocks >= 24 * 48);
        if (file.dialect == "csv") {
            CHECK(file.drift < 1e-12);
            CHECK(file.unit == 0);
        } else {
            CHECK(file.drift > 0);
            CHECK(file.drift <= 0.7072 * file.unit + 1e-12);
        }
    }
}

TEST_CASE("what may not reach a machine is refused and nothing is written", "[wire]")
{
    auto const broken = [](auto change) {
        auto program = sample::wire_ring();
        change(program);
        return program;
    };
    check_refused(broken([](auto& p) { p.nominal.upper.pop_back(); }), "different numbers of points");
    check_refused(broken([](auto& p) { p.nominal.lower[5].x() = std::numeric_limits<double>::quiet_NaN(); }),
                  "not finite");
    check_refused(broken([](auto& p) { p.nominal.sync = {4, 3}; }), "sync marks");
    check_refused(broken([](auto& p) { p.passes[1].moves[7].upper.y() = std::numeric_limits<double>::infinity(); }),
                  "not finite");
    check_refused(broken([](auto& p) { p.passes[0].moves.front().upper.x() += 0.1; }), "leans at the start hole");
    check_refused(broken([](auto& p) {
                      p.passes[0].moves.back().lower.x() += 0.1;
                      p.passes[0].moves.back().upper.x() += 0.1;
                  }),
                  "where it began");
    check_refused(broken([](auto& p) { p.passes[2].offset += 0.001; }), "offset");
    check_refused(broken([](auto& p) { p.passes[2].number = 7; }), "numbered");
    check_refused(broken([](auto& p) { p.passes.clear(); }), "no pass leaves the nominal part");
    check_refused(broken([](auto& p) { p.wire_diameter = 0; }), "wire diameter is 0 mm");
    check_refused(broken([](auto& p) { p.spark_gap = -0.001; }), "spark gap");
    check_refused(broken([](auto& p) { p.machine.thickness = 0; }), "thickness");
    check_refused(broken([](auto& p) { p.machine.upper_guide = -1; }), "guide");
    check_refused(broken([](auto& p) { p.passes[0].moves.resize(3); }), "goes nowhere");
    check_refused(broken([](auto& p) { p.passes[1].moves[9] = p.passes[1].moves[8]; }), "no length in the lower plane");
    check_refused(broken([](auto& p) { p.passes[1].moves[9].upper = p.passes[1].moves[8].upper; }),
                  "no length in the upper plane");
    // a grid that is too coarse leaves a dialect out that nobody named
    check_refused(broken([](auto& p) { p.decimals = 1; }), "no length", {"xyuv-face"});
    check_refused(broken([](auto& p) { p.passes[0].moves[3].lower.x() = 1e9; }), "no machine reaches so far");
}

TEST_CASE("a file longer than its controllers take is left out, and refused where it is asked for by name", "[wire]")
{
    // 24 spaces of 4000 blocks, each with four words: more than 5 000 000 bytes
    auto const long_ring = sample::wire_ring(sample::wire_tilt, 6000, {0});
    auto const unfit = unfit_dialects({long_ring});
    CHECK(std::any_of(unfit.begin(), unfit.end(), [](auto const& each) { return each.name == "two-plane"; }));
    CHECK(unfit_dialects({long_ring}, {"csv", "xyuv-face"}).empty());
    auto const texts = texts_of(long_ring);
    CHECK(texts.count("ring_twoplane_pass1.nc") == 0);
    CHECK(texts.count("ring_rel_pass1.iso") == 1);
    CHECK_THROWS_WITH(
        texts_of(long_ring, {"two-plane"}),
        ContainsSubstring("two-plane, ring_twoplane_pass1.nc: ") &&
            ContainsSubstring("take 200000 and 5000000; take a coarser wedm.tolerance, or another dialect"));
    CHECK(unfit_dialects({sample::wire_ring()}).empty());
}

TEST_CASE("a text of a part's name cannot break out of its comment", "[wire]")
{
    auto program = sample::square_hole();
    program.name = "a) G0 X99 (\n;\xc3\xa9 %../b";
    auto const texts = texts_of(program);
    for (auto const& [name, text] : texts) {
        INFO(name);
        CHECK(name.find('/') == std::string::npos);
        CHECK(lines_with(text, "X99").size() <= 1);
        CHECK(lines_with(text, ") G0 X99").empty());
        if (!name.ends_with(".dxf") && !name.ends_with(".csv"))
            for (auto const& line : lines_with(text, "%"))
                CHECK(line == "%");  // the end of a file, wherever it stands
    }
}

TEST_CASE("a folder of wire files appears whole and is replaced whole", "[wire]")
{
    TemporaryFolder const folder;
    auto const out = folder / "out";
    auto const first = write_wire_files({sample::wire_ring()}, out);
    REQUIRE(std::filesystem::exists(out / "ring_rel_pass3.iso"));
    CHECK(folder.names() == std::vector<std::string>{"out"});
    write_wire_files({sample::wire_ring(sample::wire_tilt, 48, {0})}, out);
    CHECK_FALSE(std::filesystem::exists(out / "ring_rel_pass3.iso"));
    CHECK(std::filesystem::exists(out / "ring_rel_pass1.iso"));
    CHECK(folder.names() == std::vector<std::string>{"out"});
    auto broken = sample::wire_ring();
    broken.passes[2].moves[50].lower = broken.passes[2].moves[49].lower;
    CHECK_THROWS_AS(write_wire_files({broken}, out), NumericalError);
    CHECK(std::filesystem::exists(out / "ring_rel_pass1.iso"));
    CHECK(folder.names() == std::vector<std::string>{"out"});
    CHECK_THROWS_WITH(check_accuracy_folder(out, "drive"),
                      ContainsSubstring("another kind of result, \"hdconj wire program"));
    std::ofstream(out / "mine.txt") << "notes\n";
    CHECK_THROWS_WITH(write_wire_files({sample::wire_ring()}, out),
                      ContainsSubstring("mine.txt, which hdconj did not write there"));
    CHECK(content(out / "mine.txt") == "notes\n");
    std::ofstream(folder / "file") << "x";
    CHECK_THROWS_WITH(write_wire_files({sample::wire_ring()}, folder / "file"),
                      ContainsSubstring("is a file, not a folder"));
    CHECK_THROWS_AS(write_wire_files({sample::wire_ring()}, folder / "no" / "where"), FileError);
    CHECK_THROWS_AS(check_wire_files(""), FileError);
    CHECK_THROWS_AS(check_wire_files("/"), FileError);
    std::filesystem::create_directory(folder / "empty");
    write_wire_files({sample::wire_ring()}, (folder / "empty").string() + "/", {"csv"});
    CHECK(std::filesystem::exists(folder / "empty" / "ring_path.csv"));
    auto const list = content(folder / "empty" / "files.txt");
    CHECK(lines_with(list, "ring_path.csv ").size() == 1);
}

TEST_CASE("an unknown dialect is named with the one that was meant", "[wire]")
{
    TemporaryFolder const folder;
    try {
        write_wire_files({sample::wire_ring()}, folder / "out", {"csv", "xyuv-guid"});
        FAIL("not refused");
    } catch (InputError const& error) {
        CHECK_THAT(describe(error.faults()), ContainsSubstring("xyuv-guide"));
    }
    CHECK(folder.names().empty());
}

TEST_CASE("guides move with the part and faces come back from them", "[wire]")
{
    auto const machine = sample::wire_machine();
    for (int i = 0; i < 200; ++i) {
        Vec2 const lower = 25 * direction(0.37 * i), upper = lower + 0.3 * direction(1.1 * i), moved(100, -40);
        auto const guides = wedm::guides_of(machine, {lower, upper});
        auto const far = wedm::guides_of(machine, {lower + moved, upper + moved});
        auto const back = wedm::faces_of(machine, guides);
        constexpr double rounding = 1e-13;
        REQUIRE((back.lower - lower).norm() < rounding);
        REQUIRE((back.upper - upper).norm() < rounding);
        REQUIRE((far.lower - guides.lower - moved).norm() < rounding);
        REQUIRE((far.upper - guides.upper - moved).norm() < rounding);
        REQUIRE((guides.upper - guides.lower - machine.guide_distance() / machine.thickness * (upper - lower)).norm() <
                rounding);
        auto const upright = wedm::guides_of(machine, {lower, lower});
        REQUIRE((upright.lower == lower && upright.upper == lower));
    }
}

TEST_CASE("the summary of a wire program repeats wire and gap and says which face is larger", "[wire]")
{
    auto program = sample::square_hole();
    auto const text = summary_text(WireSetUps{program});
    CHECK_THAT(text, ContainsSubstring("0.1 mm") && ContainsSubstring("0.012 mm"));
    CHECK_THAT(text, ContainsSubstring("SMALLER than the lower face"));
    auto const json = summary_json(WireSetUps{program});
    CHECK_THAT(json, ContainsSubstring("\"wire_diameter_mm\": 0.1,") && ContainsSubstring("\"spark_gap_mm\": 0.012,"));
    auto const ring = summary_json(WireSetUps{sample::wire_ring()});
    CHECK_THAT(ring, ContainsSubstring("\"face_shift_mm\": 0.02443470"));
    CHECK_THAT(ring,
               ContainsSubstring("\"guide_offset_mm\": 0.1989") || ContainsSubstring("\"guide_offset_mm\": 0.199"));
    program = sample::wire_ring();
    program.residuals = sample::residuals();
    CHECK_THAT(summary_text(WireSetUps{program}),
               ContainsSubstring("residual material at 58 places, 10 of them in a zone that meshes"));
    CHECK_THAT(summary_json(WireSetUps{program}), ContainsSubstring("\"residual_in_meshing_zone\": true"));
    CHECK_THAT(summary_text(WireSetUps{sample::wire_ring(0)}), ContainsSubstring("as the lower face"));
    CHECK_THAT(summary_text(WireSetUps{sample::wire_ring(-sample::wire_tilt)}),
               ContainsSubstring("LARGER than the lower face"));
}

TEST_CASE("docs/reference/json.md names every key of a wire program", "[wire]")
{
    auto const document = content(HDCONJ_SOURCE_DIR "/docs/reference/json.md");
    auto ring = sample::wire_ring();
    ring.residuals = sample::residuals();
    ring.tolerance = 0.0005;
    std::set<std::string> keys;
    auto const collect = [&](auto const& self, nlohmann::json const& json) -> void {
        for (auto const& [key, value] : json.items()) {
            if (json.is_object())
                keys.insert(key);
            if (value.is_structured())
                self(self, value);
        }
    };
    collect(collect,
            nlohmann::json::parse(summary_json(WireSetUps{ring}, {{"3b", "", "a.3b", 1, 1, 1, 1, 0.001, 0}}, "out",
                                               {{"picture_ring1", "a.svg", 0.1}, {"picture_ring2", "b.svg", 0.1}})));
    CHECK(keys.size() > 60);
    for (auto const& key : keys)
        CHECK_THAT(document, ContainsSubstring("`" + key + "`"));
}

TEST_CASE("dialects that no other reader has taken yet are called unverified", "[wire]")
{
    int verified = 0;
    for (auto const& dialect : wire_dialects())
        verified += dialect.verified() ? 1 : 0;
    CHECK(wire_dialects().size() == 8);
    CHECK(verified ==
          5);  // DXF by ezdxf and GDAL, XYUV and iso-2d by LinuxCNC, CSV by NumPy, in tests/cli/wire_readers.cpp
    CHECK_THAT(summary_text(WireSetUps{sample::wire_ring()}, {{"3b", "", "a.3b", 1, 1, 1, 1, 0.001, 0}}),
               ContainsSubstring("not verified on hardware"));
}

}  // namespace hdconj::test::wire_files_cases
