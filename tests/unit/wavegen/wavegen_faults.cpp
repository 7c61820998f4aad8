// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Bad parameters of the wave generators: each is refused with its key, the reason and a remedy.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "hdconj/check.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wavegen/four_roller.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::wavegen_faults_cases {

namespace {

struct Bad
{
    std::vector<std::string> overrides;
    std::string key;
    std::string reason;
};

Faults faults_of(std::vector<std::string> const& overrides)
{
    try {
        return check_scene(builtin_scene(overrides));
    } catch (InputError const& error) {
        return error.faults();
    }
}

std::string const family = "wave_generator.family=";

std::vector<Bad> const table{
    {{family + "elipse"}, "wave_generator.family", "ellipse"},
    {{family + "ellipse", "!wave_generator.radial_deformation"}, "wave_generator.radial_deformation", "missing"},
    {{family + "ellipse", "wave_generator.waves=3", "drive.circular_spline_teeth=203"},
     "wave_generator.waves",
     "two waves"},
    {{family + "ellipse", "wave_generator.radial_deformation=0"}, "wave_generator.radial_deformation", ""},
    {{family + "ellipse", "wave_generator.radial_deformation=-0.25"}, "wave_generator.radial_deformation", ""},
    {{family + "ellipse", "wave_generator.radial_deformation=nan"}, "wave_generator.radial_deformation", ""},
    {{family + "ellipse", "wave_generator.roller_angle_deg=30"}, "wave_generator.roller_angle_deg", "unknown"},
    {{family + "four-roller"}, "wave_generator.roller_angle_deg", "missing"},
    {{family + "four-roller", "wave_generator.roller_angle_deg=-1"}, "wave_generator.roller_angle_deg", ""},
    {{family + "four-roller", "wave_generator.roller_angle_deg=45"}, "wave_generator.roller_angle_deg", "at most 40.7"},
    {{family + "four-roller", "wave_generator.roller_angle_deg=40.8"}, "wave_generator.roller_angle_deg", "sinks in"},
    {{family + "four-roller", "wave_generator.roller_angle_deg=26.2", "wave_generator.waves=3",
      "drive.circular_spline_teeth=203"},
     "wave_generator.roller_angle_deg",
     "at most 26.1"},
    {{family + "four-roller", "wave_generator.roller_angle_deg=30", "wave_generator.waves=1"},
     "wave_generator.waves",
     "as a whole"},
    {{family + "four-roller", "wave_generator.roller_angle_deg=\"30\""}, "wave_generator.roller_angle_deg", ""},
    {{family + "two-disc"}, "wave_generator.wrap_angle_deg", "missing"},
    {{family + "two-disc", "wave_generator.wrap_angle_deg=0"}, "wave_generator.wrap_angle_deg", ""},
    {{family + "two-disc", "wave_generator.wrap_angle_deg=45"}, "wave_generator.wrap_angle_deg", "beyond the middle"},
    {{family + "two-disc", "wave_generator.wrap_angle_deg=20", "wave_generator.waves=1"},
     "wave_generator.waves",
     "single disc"},
    {{family + "ring-on-cosine-cam"}, "wave_generator.ring_thickness", "missing"},
    {{family + "ring-on-cosine-cam", "wave_generator.ring_thickness=0"}, "wave_generator.ring_thickness", ""},
    {{family + "ring-on-cosine-cam", "wave_generator.ring_thickness=24.2"},
     "wave_generator.ring_thickness",
     "leaves no cam"},
    {{family + "table", "!wave_generator.radial_deformation"}, "wave_generator.file", "missing"},
    {{family + "table", "!wave_generator.radial_deformation", "wave_generator.file=nowhere.csv"},
     "wave_generator.file",
     "cannot be read"},
    {{family + "table", "wave_generator.file=nowhere.csv"}, "wave_generator.radial_deformation", "unknown"},
};

struct BadTable
{
    std::string content;
    std::string reason;
    std::string remedy = "";
};

std::vector<BadTable> const tables{
    {"", "holds 0 rows"},
    {"angle,w\n0,1\n45,0\n90,-1\n", "holds 3 rows"},
    {"0,1\n45,x\n90,-1\n135,0\n", "line 2"},
    {"0,1\n45,0\n90,nan\n135,0\n", "line 3"},
    {"0,1\n45,0\n45,-1\n135,0\n", "does not increase"},
    {"0,1\n90,-1\n45,0\n135,0\n", "does not increase"},
    {"0,1\n45,0\n90,-1\n135,0\n190,1\n", "longer than one wave of 180", "give one wave of 180 degrees"},
    {"0,1\n45,0\n90,-1\n135,0\n180,1\n225,0\n270,-1\n315,0\n", "longer than one wave of 180 degrees",
     "waves = 1, of which"},
    {"angle [rad],w [mm]\n0,1\n45,0\n90,-1\n135,0\n", "longer than one wave of 180", "angle [deg]"},
    {"0,1\n0.785,0\n1.571,-1\n2.356,0\n", "no row lies", "angle [rad]"},
    {"0,1\n0.393,0.7\n0.785,0\n1.178,-0.7\n1.571,-1\n", "no row lies", "angle [rad]"},
    {"angle_deg,w\n0,250\n45,0\n90,-250\n135,0\n", "not smaller than the neutral radius", "[um]"},
    {"0,1\n10,0.9\n20,0.8\n30,0.5\n40,0.2\n", "no row lies in the 140 degrees after 40, of a wave of 180"},
    {"-40,0.2\n-30,0.5\n-20,0.8\n-10,0.9\n0,1\n", "no row lies in the 140 degrees after 0"},
    {"0,1\n45,0\n90,-1\n135,0\n180,0.9\n", "closing row differs"},
    {"0,1\n45,1\n90,1\n135,1\n", "all values are equal"},
    {"0,-0.25\n45,0\n90,0.25\n135,0\n", "not at the major axis"},
    {"0,1e308\n45,0\n90,-1e308\n135,0\n", "larger than any drive"},
    {"0,0.25\n45,0\n90,-0.25\n91,0.25\n135,0\n", "hollow"},
};

}  // namespace

TEST_CASE("bad wave generators are refused by key and reason", "[wavegen][scene]")
{
    for (Bad const& bad : table) {
        INFO(bad.overrides.back() << " of " << bad.overrides.front());
        Faults const faults = faults_of(bad.overrides);
        bool found = false;
        std::string all;
        for (Fault const& fault : faults) {
            std::string const text = fault.reason + " " + fault.remedy;
            all += fault.path + ": " + text + "\n";
            found = found || (fault.path == bad.key && !fault.reason.empty() && !fault.remedy.empty() &&
                              text.find(bad.reason) != std::string::npos);
        }
        INFO(all);
        CHECK(found);
    }
}

TEST_CASE("rollers are refused from where their largest displacement leaves the major axis", "[wavegen][scene]")
{
    constexpr double half_turn = 180;
    for (int const waves : {2, 3}) {
        std::vector<std::string> const drive{family + "four-roller", "wave_generator.waves=" + std::to_string(waves),
                                             "drive.circular_spline_teeth=" + std::to_string(200 + waves)};
        for (double angle = 0; angle < half_turn / waves / 2; angle += 0.25) {
            std::vector<std::string> keys = drive;
            keys.push_back("wave_generator.roller_angle_deg=" + std::to_string(angle));
            Faults const faults = faults_of(keys);
            wavegen::FourRoller const shape(1, from_deg(angle), waves);
            double largest = 0;
            for (double u = 0; u < half_turn / waves; u += 0.1)
                largest = std::max(largest, shape(from_deg(u)).w);
            CAPTURE(waves, angle, largest);
            REQUIRE(faults.empty() == (largest < 1 + 1e-9));
            if (faults.empty())
                continue;
            REQUIRE(faults.front().path == "wave_generator.roller_angle_deg");
            keys.insert(keys.end(), faults.front().set.begin(), faults.front().set.end());
            CHECK(faults_of(keys).empty());
        }
    }
}

TEST_CASE("bad cam tables are refused with the line", "[wavegen][scene]")
{
    test::TemporaryFolder const folder;
    for (BadTable const& bad : tables) {
        INFO(bad.content);
        std::ofstream(folder / "cam.csv") << bad.content;
        Faults const faults = faults_of({family + "table", "!wave_generator.radial_deformation",
                                         "wave_generator.file=" + (folder / "cam.csv").string()});
        REQUIRE(faults.size() == 1);
        CHECK_THAT(faults[0].reason, ContainsSubstring(bad.reason));
        CHECK_FALSE(faults[0].remedy.empty());
        CHECK(faults[0].path == "wave_generator.file");
        CHECK_THAT(faults[0].remedy, ContainsSubstring(bad.remedy));
    }
}

TEST_CASE("a table of another number of waves says so", "[wavegen][scene]")
{
    test::TemporaryFolder const folder;
    std::ofstream(folder / "cam.csv") << "0,0.25\n40,0\n80,-0.25\n120,-0.25\n140,0\n180,0.25\n";
    Faults const faults =
        faults_of({family + "table", "!wave_generator.radial_deformation", "wave_generator.waves=3",
                   "drive.circular_spline_teeth=203", "wave_generator.file=" + (folder / "cam.csv").string()});
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0].reason, ContainsSubstring("longer than one wave of 120 degrees"));
    CHECK_THAT(faults[0].remedy, ContainsSubstring("waves = 2"));
}

TEST_CASE("the closing row of a table is rounded as its angles are", "[wavegen][scene]")
{
    test::TemporaryFolder const folder;
    auto const cam = [&](int digits, bool closing) {
        std::ofstream file(folder / "cam.csv");
        file << std::fixed << "angle [rad],w_microns\n";
        for (int i = 0; i < (closing ? 37 : 36); ++i) {
            file.precision(digits);
            file << from_deg(5 * i);
            file.precision(9);
            file << "," << 250 * std::cos(2 * from_deg(5 * i)) << "\n";
        }
        file.close();
        return std::vector<std::string>{family + "table", "!wave_generator.radial_deformation",
                                        "wave_generator.file=" + (folder / "cam.csv").string()};
    };
    for (int const digits : {3, 4, 6}) {
        INFO(digits << " digits");
        CHECK(faults_of(cam(digits, true)).empty());
        double const closed = solve(builtin_scene(cam(digits, true))).geometry.w0;
        CHECK(closed == solve(builtin_scene(cam(digits, false))).geometry.w0);
        CHECK(closed == Approx(0.25).epsilon(1e-3));
    }
}

TEST_CASE("a table may start anywhere and hold denormal or repeated closing values", "[wavegen][scene]")
{
    test::TemporaryFolder const folder;
    std::ofstream(folder / "cam.csv")
        << "# measured\nangle;w\n-90;-0.25\n-60;-0.125\n-30;0.125\n0;0.25\n30;0.125\n60;-0.125\n90;-0.25\n";
    std::vector<std::string> const cam{family + "table", "!wave_generator.radial_deformation",
                                       "wave_generator.file=" + (folder / "cam.csv").string()};
    CHECK(faults_of(cam).empty());
    Solution const solution = solve(builtin_scene(cam));
    CHECK(solution.check->smallest_clearance > -1e-10);
    CHECK(solution.geometry.w0 == Approx(0.25).epsilon(0.02));
    // the rows of the table leave no trace in the outline: the flank is in as many pieces as under a cosine cam
    CHECK(solution.circular_spline.pieces.size() == solve(builtin_scene()).circular_spline.pieces.size());
    // a radius in place of a displacement, and a value that is next to nothing
    std::ofstream(folder / "cam.csv")
        << "0,20.25\n30,20.125\n45,20\n60,19.875\n90,19.75\n120,19.875\n135,20\n150,20.125\n180,20.25\n";
    CHECK(faults_of(cam).empty());
    std::ofstream(folder / "cam.csv")
        << "0,0.25\n30,0.125\n45,5e-324\n60,-0.125\n90,-0.25\n120,-0.125\n135,-5e-324\n150,0.125\n";
    CHECK(solve(builtin_scene(cam)).check->smallest_clearance > -1e-10);
}

}  // namespace hdconj::test::wavegen_faults_cases
