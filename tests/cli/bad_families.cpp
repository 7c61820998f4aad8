// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that make no tooth are refused for the right reason, family by family.
#include <filesystem>
#include <set>

#include "bad_families_table.hpp"
#include "bad_scene_checks.hpp"
#include "hdconj/profile/registry.hpp"
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
