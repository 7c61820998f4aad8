// SPDX-License-Identifier: GPL-3.0-or-later
// Other people's programs, and parsers in another language, read wire files.
#include <array>
#include <fstream>

#include "hdconj/wire_files.hpp"
#include "support/catch.hpp"
#include "support/not_tried.hpp"
#include "support/run_program.hpp"
#include "support/sample_wire_program.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::wire_readers_cases {

using test::run;
using test::TemporaryFolder;

namespace {

std::string const reader = "'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR "/tests/cli/readers/read_wire.py' ";

bool no_python()
{
    if (std::string(HDCONJ_PYTHON).empty()) {
        not_tried("python with numpy");
        return true;
    }
    return false;
}

/// Replaces the first @p from in a file.
void change(std::filesystem::path const& file, std::string const& from, std::string const& to)
{
    auto text = test::content(file);
    auto const at = text.find(from);
    REQUIRE(at != std::string::npos);
    std::ofstream(file, std::ios::binary) << text.replace(at, from.size(), to);
}

/// What the wire and the contour may be off between points of 96 in a tooth space of the sample: the sagitta of a chord
/// of 0.04 mm at its least radius of curvature, 0.5 mm, of each.
constexpr char const* chord = "0.0008";

}  // namespace

TEST_CASE("every dialect of a toothed ring is read back to both faces and its wire sweeps the ring", "[wire]")
{
    if (no_python())
        return;
    TemporaryFolder const folder;
    write_wire_files({sample::wire_ring(sample::wire_tilt, 96)}, folder / "out");
    auto const read = run(reader + "out ring 7 20 30 4 " + chord + " 0.0002", folder.path());
    INFO(read.out);
    CHECK(read.err.empty());
    CHECK_THAT(read.out, ContainsSubstring(", 0 faults\n"));
    CHECK(read.status == 0);
    for (std::string const missing : {"LinuxCNC", "GDAL", "ezdxf", "shapely"}) {
        if (read.out.find(missing + " is not installed") != std::string::npos)
            not_tried(missing);
    }
    for (auto const& [file, from, to] :
         {std::array<std::string, 3>{"ring_xyuv_guide_pass2.ngc", "\nN40 G1 X", "\nN40 G1 X1"},
          {"ring_rel_pass1.iso", " U", " U-"},
          {"ring_lower_pass3.3b", " L", " L4\nB1 B0 B1 GX L"},
          {"ring_planes.dxf", "\n8\nWIRE_UPPER\n10\n", "\n8\nWIRE_UPPER\n10\n1"}}) {
        TemporaryFolder const broken;
        write_wire_files({sample::wire_ring(sample::wire_tilt, 24)}, broken / "out");
        if (test::content(broken / "out" / file).find(from) == std::string::npos)
            FAIL(file << " has no " << from);
        change(broken / "out" / file, from, to);
        auto const noticed = run(reader + "out ring 7 20 30 4 1 1", broken.path());  // sweeping is not what is tried
        INFO(file << "\n" << noticed.out << noticed.err);
        CHECK(noticed.status != 0);
    }
}

TEST_CASE("the built-in drive's files are read back to both faces, the flexspline's of both set-ups too", "[wire]")
{
    if (no_python())
        return;
    TemporaryFolder const folder;
    std::string const wedm = "'" HDCONJ_PROGRAM "' wedm --quiet --set wedm.tolerance=0.002 ";
    REQUIRE(run(wedm + "--tilt 0.2 -o ring", folder.path()).status == 0);
    REQUIRE(run(wedm + "--part flexspline --set wedm.overlap=0.1 -o gear", folder.path()).status == 0);
    // 0.007 mm: chords of contour and wire, and what is left in the corners of the root
    for (std::string const files :
         {"ring type-50 7", "gear type-50-flexspline_setup1 8", "gear type-50-flexspline_setup2 8"}) {
        auto const read = run(reader + files + " 20 30 4 0.007 0.002", folder.path());
        INFO(files << "\n" << read.out << read.err);
        CHECK_THAT(read.out, ContainsSubstring(", 0 faults\n"));
        CHECK(read.status == 0);
    }
}

TEST_CASE("the square hole is read back in three decimals too", "[wire]")
{
    if (no_python())
        return;
    for (int const decimals : {3, 4, 5}) {
        TemporaryFolder const folder;
        auto program = sample::square_hole();
        program.decimals = decimals;
        write_wire_files({program}, folder / "out");
        // No chord error, but round wire makes round corners: offset (sqrt 2 - 1) of them is left.
        auto const read =
            run(reader + "out square 7 20 30 " + std::to_string(decimals) + " 0.0258 0.002", folder.path());
        INFO(read.out << read.err);
        CHECK(read.status == 0);
    }
}

TEST_CASE("a control makes the wire's path again of every contour with G41 or G42: a simulation, and LinuxCNC's own",
          "[wire]")
{
    if (no_python())
        return;
    struct Case
    {
        std::string arguments;
        std::vector<std::string> stems;
        std::string decimals = "4", tolerance = "0.0005";
    };
    for (auto const& [arguments, stems, decimals, tolerance] : std::vector<Case>{
             {"", {"type-50"}},
             {"--set 'wedm.passes=[0.02, 0]' --set wedm.direction=alternating --set wedm.overlap=0.3", {"type-50"}},
             {"--set wedm.wire_diameter=0.2 --set wedm.residual_limit=0.05", {"type-50"}},
             {"--set circular_spline.root_clearance=0.03 --set wedm.residual_limit=0.05", {"type-50"}},
             {"--set wedm.tolerance=1e-4 --decimals 5", {"type-50"}, "5", "0.0001"},
             {"--set wedm.tolerance=0.002 --decimals 3", {"type-50"}, "3", "0.002"},
             {"--part flexspline --set wedm.overlap=0.05",
              {"type-50-flexspline_setup1", "type-50-flexspline_setup2"}}}) {
        std::string const thickness = arguments.starts_with("--part flexspline") ? " 8" : " 7";
        TemporaryFolder const folder;
        REQUIRE(run("'" HDCONJ_PROGRAM "' wedm --quiet --dialect csv,xyuv-guide,xyuv-face,relative-uv,two-plane,"
                    "iso-2d -o out " +
                        arguments,
                    folder.path())
                    .status == 0);
        for (auto const& stem : stems) {
            auto const read =
                run(reader + "out " + stem + thickness + " 20 30 " + decimals + " 0 " + tolerance, folder.path());
            INFO(arguments << "\n" << read.out << read.err);
            CHECK(read.status == 0);
            CHECK_THAT(read.out, ContainsSubstring(stem + "_2d_pass1.iso, offset by "));
            if (read.out.find("LinuxCNC is not installed") != std::string::npos)
                not_tried("LinuxCNC");
            else
                CHECK_THAT(read.out, ContainsSubstring("LinuxCNC, " + stem + "_2d_pass1.iso: "));
        }
    }
}

}  // namespace hdconj::test::wire_readers_cases
