// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that make no tooth are refused for the right reason, family by family.
#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "bad_families_table.hpp"
#include "bad_scene_checks.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj_run.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::bad_families_cases {

namespace {

std::filesystem::path const scenes = std::filesystem::path(HDCONJ_SOURCE_DIR) / "data/scenes";

std::string text_of_scene(std::string const& name)
{
    return content(scenes / (name + ".toml"));
}

}  // namespace

TEST_CASE("bad parameters of tooth families are refused", "[scene][family]")
{
    for (auto const& [scene, row] : bad_families()) {
        SECTION(row.name)
        {
            auto const faults = faults_of(edited(text_of_scene(scene), row), scenes);
            INFO(describe(faults));
            // one of several faults of the same key may be meant
            CHECK(std::any_of(faults.begin(), faults.end(), [&row = row](Fault const& fault) {
                return fault.path == row.path && contains(fault.reason, row.reason) &&
                       contains(fault.remedy, row.remedy);
            }));
            check_all(faults, row);
        }
    }
}

TEST_CASE("every tooth family has bad scenes, and its good one has no fault", "[scene][family]")
{
    std::set<std::string> covered;
    for (auto const& [scene, row] : bad_families()) {
        INFO(scene << "\n" << describe(faults_of(text_of_scene(scene), scenes)));
        CHECK(faults_of(text_of_scene(scene), scenes).empty());
        covered.insert(scene);
    }
    for (auto const& family : profile::profile_families()) {
        bool const is_builtin = family.name == "double-circular-arc";  // its rows are those of bad_scenes_table
        CHECK((is_builtin || covered.count(std::string(family.name)) == 1));
    }
}

TEST_CASE("points of a left flank, and those in another unit, are told what to write", "[scene][family]")
{
    TemporaryFolder const folder;
    std::vector<std::array<double, 2>> const flank{
        {0.07, 0.2}, {0.12, 0.13}, {0.172, 0}, {0.232, -0.17}, {0.29, -0.28}};
    auto const faults_with = [&](double x_factor, double y_factor, std::string const& side) {
        std::ofstream file(folder / "points-flank.csv");
        for (auto const& [x, y] : flank)
            file << x * x_factor << "," << y * y_factor << "\n";
        file.close();
        std::string text = text_of_scene("points");
        text.replace(text.find("side = \"right\""), 14, "side = \"" + side + "\"");
        return faults_of(text, folder.path());
    };
    CHECK(faults_with(1, 1, "right").empty());
    for (std::string const side : {"right", "full"}) {
        auto const left = faults_with(-1, 1, side);
        INFO(describe(left));
        REQUIRE(left.size() == 1);
        CHECK_THAT(left[0].remedy, ContainsSubstring("change the sign of each x"));
        CHECK_THAT(left[0].remedy, !ContainsSubstring("side = \"full\""));
    }
    auto const micrometres = faults_with(1000, 1000, "right");
    INFO(describe(micrometres));
    REQUIRE(micrometres.size() == 1);
    CHECK(micrometres[0].path == "flexspline.profile.file");
    CHECK_THAT(micrometres[0].reason, ContainsSubstring("1920 modules"));
    CHECK_THAT(micrometres[0].remedy, ContainsSubstring("x [um],y [um]"));
}

TEST_CASE("a whole tooth is as high as its curve", "[scene][family]")
{
    // the highest point of a round tip is left out: the points end at 0.194
    std::string text = text_of_scene("b-spline");
    std::size_t const from = text.find("points = ["), to = text.find("[wave_generator]");
    std::string rows;
    for (int i = -9; i <= 9; i += 2)
        rows += "[" + std::to_string(0.032 * i) + ", " + std::to_string(0.2 - 0.006 * i * i) + "],";
    text.replace(from, to - from, "side = \"full\"\npoints = [" + rows + "]\n");
    Scene const scene = parse_scene(text, "round", scenes);
    CHECK(solve(scene).geometry.addendum == Approx(0.2).margin(0.002));
}

TEST_CASE("a list with thousands of bad rows is refused in a screenful", "[scene][family]")
{
    std::string rows;
    for (int i = 0; i < 5000; ++i)
        rows += "[nan, 1],";
    std::string text = text_of_scene("b-spline");
    text.replace(text.find("points = ["), 10, "points = [" + rows);
    CHECK(faults_of(text, scenes).size() == 21);

    std::string many;
    for (int i = 0; i < 200000; ++i)
        many += "[1,1],";
    text = text_of_scene("b-spline");
    text.replace(text.find("points = ["), 10, "points = [" + many);
    auto const faults = faults_of(text, scenes);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0].reason, ContainsSubstring("more than 20000 rows"));
}

}  // namespace hdconj::test::bad_families_cases
