// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of the reverse problem that must be refused: the sound one with an edit, and what must be said about it.
#include "bad_scene_checks.hpp"
#include "hdconj/read_scene.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::bad_reverse_scenes_cases {

namespace {

using test::BadScene;
using test::faults_of;

std::string sound()
{
    return test::content(HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml");
}

std::string const flexspline_tooth =
    "[flexspline.profile]\nfamily = \"straight\"\naddendum = 0.2\ndedendum = 0.3\nthickness = 0.35\n"
    "pressure_angle_deg = 20\n[wave_generator]";

std::vector<BadScene> const& reverse_rows()
{
    static std::vector<BadScene> const table{
        {"both teeth", "[wave_generator]", flexspline_tooth, "circular_spline.profile", "both teeth are given",
         "remove [flexspline.profile] or [circular_spline.profile]"},
        {"no addendum", "addendum = 0.2250", "", "flexspline.addendum", "missing", "addendum = 0.225"},
        {"no dedendum", "dedendum = 0.3030", "", "flexspline.dedendum", "missing", "dedendum = 0.303"},
        {"addendum in quotes", "addendum = 0.2250", "addendum = \"0.225\"", "flexspline.addendum", "text where",
         "without quotes"},
        {"negative dedendum", "dedendum = 0.3030", "dedendum = -0.3", "flexspline.dedendum", "above 0", "above 0"},
        {"misspelt addendum", "addendum = 0.2250", "adendum = 0.2250", "flexspline.adendum", "unknown key",
         "write addendum"},
        {"root clearance", "backlash_offset = 0.0", "root_clearance = 0.02", "circular_spline.root_clearance",
         "told by its given tooth", "circular_spline.profile.dedendum"},
        {"unknown family", "family = \"double-circular-arc\"", "family = \"gothic\"", "circular_spline.profile.family",
         "unknown word", "\"double-circular-arc\""},
        {"no family", "family = \"double-circular-arc\"", "", "circular_spline.profile.family", "missing", "family"},
        {"key of another family", "convex_rise = -0.1500", "pressure_angle_deg = 20",
         "circular_spline.profile.pressure_angle_deg", "unknown key", "family"},
        {"family key missing", "convex_radius = 0.6000", "", "circular_spline.profile.convex_radius", "missing",
         "convex_radius"},
        {"family key not finite", "convex_radius = 0.6000", "convex_radius = nan",
         "circular_spline.profile.convex_radius", "finite", "above 0"},
        {"misspelt table", "[circular_spline.profile]", "[circular_spline.profil]", "circular_spline.profil",
         "unknown table", "[circular_spline.profile]"},
        {"arcs that do not meet", "concave_offset = \"tangent\"", "concave_offset = 0.3",
         "circular_spline.profile.concave_offset", "do not meet", "tangent"},
        {"given tooth wider than its pitch", "convex_offset = 0.3660", "convex_offset = 0.2", "circular_spline.profile",
         "wider than its pitch", "thinner"},
        {"tips in the rim", "dedendum = 0.3030", "dedendum = 0.1900", "flexspline.dedendum",
         "cut into the flexspline's rim", "write more than 0.2"},
        {"tips in the bottom", "addendum = 0.2250", "addendum = 0.2950", "flexspline.addendum",
         "cut into the bottom of the given tooth spaces, at a radius of", "write less than 0.29"},
        {"tip circle in the rim", "backlash_offset = 0.0", "inner_radius = 24.9", "circular_spline.inner_radius",
         "cut into the flexspline's rim", "between", 0},
        {"tip circle out of reach", "backlash_offset = 0.0", "inner_radius = 26.0", "circular_spline.inner_radius",
         "no tooth enters", "between", 0},
        {"no hole", "wall = 0.7 ", "wall = 24.8 ", "flexspline.wall", "leaves no hole", "thinner"},
        {"inner radius of another drive", "wall = 0.7 ", "inner_radius = 12.0\nwall = 0.7 ", "flexspline.inner_radius",
         "contradicts module and teeth", "write about that radius"},
    };
    return table;
}

}  // namespace

TEST_CASE("the reverse scene has no fault", "[scene][reverse]")
{
    INFO(describe(faults_of(sound())));
    CHECK(faults_of(sound()).empty());
}

TEST_CASE("wrong reverse scenes are refused", "[scene][reverse]")
{
    for (auto const& row : reverse_rows()) {
        SECTION(row.name)
        {
            test::check_row(row, test::edited(sound(), row));
        }
    }
}

TEST_CASE("heights are advised by the module", "[scene][reverse]")
{
    std::string text = sound();
    for (auto const& [from, to] : {std::pair("module = 0.25", "module = 1.2"), std::pair("addendum = 0.2250", ""),
                                   std::pair("dedendum = 0.3030", "")})
        text.replace(text.find(from), std::string_view(from).size(), to);
    auto const faults = faults_of(text);
    INFO(describe(faults));
    for (auto const& [key, value] :
         {std::pair("addendum", "addendum = 1.08"), std::pair("dedendum", "dedendum = 1.45")}) {
        auto const* const fault = test::find_fault(faults, std::string("flexspline.") + key);
        REQUIRE(fault != nullptr);
        CHECK_THAT(fault->remedy, ContainsSubstring(value));
    }
}

TEST_CASE("heights of the solved tooth have no place where the flexspline's tooth is given", "[scene][reverse]")
{
    std::string text(builtin_scene_text());
    text.replace(text.find("wall = 0.7"), 10, "addendum = 0.2\nwall = 0.7");
    auto const faults = faults_of(text);
    INFO(describe(faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().path == "flexspline.addendum");
    CHECK(faults.front().line > 0);
    CHECK(faults.front().remedy.find("flexspline.profile.addendum") != std::string::npos);
}

TEST_CASE("a scene without any tooth says how to give either", "[scene][reverse]")
{
    std::string text = sound();
    std::size_t const from = text.find("[circular_spline.profile]");
    text.erase(from, text.find("[solver]") - from);
    auto const faults = faults_of(text);
    INFO(describe(faults));
    auto const* const fault = test::find_fault(faults, "flexspline.profile");
    REQUIRE(fault != nullptr);
    CHECK(fault->remedy.find("[circular_spline.profile]") != std::string::npos);
}

}  // namespace hdconj::test::bad_reverse_scenes_cases
