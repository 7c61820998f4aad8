// SPDX-License-Identifier: GPL-3.0-or-later
// Files of numbers that a scene names: what their headings say of units is what is computed.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "hdconj_run.hpp"
#include "support/catch.hpp"

namespace hdconj::test::input_files_cases {

namespace {

namespace fs = std::filesystem;
using hdconj::test::hdconj_run;
using hdconj::test::TemporaryFolder;

std::string const scenes = HDCONJ_SOURCE_DIR "/data/scenes/";

/// The rows of a data file, each number times a factor, under another heading.
void rewrite(fs::path const& from, fs::path const& to, std::string const& heading, double first, double second)
{
    std::ifstream in(from);
    std::ofstream out(to);
    out.precision(17);
    out << heading << '\n';
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields(line);
        double x = 0, y = 0;
        char comma = 0;
        if (fields >> x >> comma >> y)
            out << x * first << ',' << y * second << '\n';
    }
}

/// Depth of the tooth space and land of @p scene with the file written anew.
nlohmann::json geometry_of(std::string const& scene, std::string const& file, std::string const& heading, double first,
                           double second)
{
    TemporaryFolder const folder;
    fs::copy_file(scenes + scene, folder / scene);
    rewrite(scenes + file, folder / file, heading, first, second);
    auto const done = hdconj_run("solve " + scene + " -o a.h5 --json", folder.path());
    INFO(heading << "\n" << done.err);
    REQUIRE(done.status == 0);
    return nlohmann::json::parse(done.out).at("geometry");
}

void check_same(nlohmann::json const& a, nlohmann::json const& b)
{
    // the numbers themselves are rounded anew
    constexpr double rounding = 1e-10;
    for (char const* const key : {"space_depth_mm", "land_width_mm", "w0_mm"}) {
        INFO(key);
        CHECK(std::abs(a.at(key).get<double>() - b.at(key).get<double>()) < rounding);
    }
}

}  // namespace

TEST_CASE("points of a tooth are the same tooth in any unit that their heading names", "[scene][units]")
{
    auto const in_mm = geometry_of("points.toml", "points-flank.csv", "x,y", 1, 1);
    auto const [heading, factor] = GENERATE(table<std::string, double>({
        {"x [mm],y [mm]", 1},
        {"x [inch],y [inch]", 1 / 25.4},
        {"x (um);y (\xc2\xb5m)", 1e3},
        {"x_m,y_m", 1e-3},
        {"\"x in\",\"y in\"", 1 / 25.4},
        {"x [mil] y [mil]", 1000 / 25.4},
        {"\xef\xbb\xbfx [cm],y [cm]", 0.1},
    }));
    INFO(heading);
    check_same(in_mm, geometry_of("points.toml", "points-flank.csv", heading, factor, factor));
}

TEST_CASE("a cam table is the same cam in any units that its heading names", "[scene][units]")
{
    auto const plain = geometry_of("cam-table.toml", "cam-table.csv", "angle,w", 1, 1);
    auto const [heading, angle, length] = GENERATE(table<std::string, double, double>({
        {"angle_deg,radial_displacement_mm", 1, 1},
        {"angle [rad],w [um]", std::numbers::pi / 180, 1e3},
        {"angle [rad],w [inch]", std::numbers::pi / 180, 1 / 25.4},
        {"angle [arcmin],w", 60, 1},
        {"deg,um", 1, 1e3},
    }));
    INFO(heading);
    check_same(plain, geometry_of("cam-table.toml", "cam-table.csv", heading, angle, length));
}

TEST_CASE("a heading whose unit is not known, or is of another quantity, is refused with those that are",
          "[scene][units]")
{
    struct Row
    {
        std::string scene, file, heading, reason, remedy;
    };
    for (Row const& row :
         {Row{"points.toml", "points-flank.csv", "x [foot],y [foot]", "column 1, x [foot]: the unit is not known",
              "[inch]"},
          Row{"points.toml", "points-flank.csv", "x [mm],y [deg]", "column 2, y [deg]: the unit is not known", "[mm]"},
          Row{"points.toml", "points-flank.csv", "flank of 1998 (inch)", "names the unit [inch]", "x [mm],y [mm]"},
          Row{"cam-table.toml", "cam-table.csv", "angle [gon],w [mm]", "column 1, angle [gon]: the unit is not known",
              "[rad]"},
          Row{"cam-table.toml", "cam-table.csv", "w [mm],angle [deg]", "column 1, w [mm]: the unit is not known",
              "[deg]"}}) {
        TemporaryFolder const folder;
        fs::copy_file(scenes + row.scene, folder / row.scene);
        rewrite(scenes + row.file, folder / row.file, row.heading, 1, 1);
        auto const refused = hdconj_run("check " + row.scene, folder.path());
        INFO(row.heading << "\n" << refused.err);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.err, ContainsSubstring(".file") && ContainsSubstring("line 1 of") &&
                                    ContainsSubstring(row.reason) && ContainsSubstring(row.remedy));
    }
}

TEST_CASE("a row that cannot be a point is refused with its line", "[scene]")
{
    auto const [row, reason, remedy] = GENERATE(table<std::string, std::string, std::string>({
        {"-1e300,0.12", "a length larger than any drive", "write two numbers"},
        {"nan,0.12", "not a pair of finite numbers", "write two numbers"},
        {"0,1323;0,14", "decimal commas", "write decimal points: 0.1323;0.14"},
        {"0,1323 0,14", "decimal commas", "write decimal points: 0.1323 0.14"},
    }));
    TemporaryFolder const folder;
    fs::copy_file(scenes + "points.toml", folder / "points.toml");
    std::ofstream(folder / "points-flank.csv") << "x,y\n0.084,0.2\n" << row << "\n0.157,0.1\n";
    auto const refused = hdconj_run("check points.toml", folder.path());
    INFO(row << "\n" << refused.err);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring("line 3 of") && ContainsSubstring(reason) && ContainsSubstring(remedy));
}

TEST_CASE("a hollow neutral curve names its key, and the limit that it tells is one", "[scene]")
{
    auto const [family, large] = GENERATE(table<std::string, double>({
        {"--set drive.module=2 --set drive.flexspline_teeth=60 --set drive.circular_spline_teeth=66 --set "
         "flexspline.wall=10 --set wave_generator.waves=3 --set '!circular_spline.inner_radius'",
         5.9},
        {"--set wave_generator.family=four-roller --set wave_generator.roller_angle_deg=25 --set "
         "'!circular_spline.inner_radius'",
         4.99},
        {"--set wave_generator.family=two-disc --set wave_generator.wrap_angle_deg=30 --set "
         "'!circular_spline.inner_radius'",
         4.99},
    }));
    std::string const keys = family;
    auto const checked = [&keys](double w0) {
        std::ostringstream text;
        text.precision(17);
        text << "check " << keys << " --set wave_generator.radial_deformation=" << w0;
        return hdconj_run(text.str()).err;
    };
    std::string const said = checked(large);
    INFO(said);
    CHECK_THAT(said, ContainsSubstring("wave_generator.radial_deformation = ") && ContainsSubstring("hollow at"));
    CHECK(said.find("table") == std::string::npos);
    auto const at = said.find("write at most ");
    REQUIRE(at != std::string::npos);
    double const limit = std::stod(said.substr(at + std::string("write at most ").size()));
    CHECK(limit < large);
    CHECK(checked(limit).find("hollow") == std::string::npos);
    CHECK(checked(1.002 * limit).find("hollow") != std::string::npos);
}

}  // namespace hdconj::test::input_files_cases
