// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose neutral curve is wanted and that must be refused: the sound one with an edit, and what must be said.
#include "bad_scene_checks.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::bad_wanted_scenes_cases {

namespace {

using test::BadScene;

std::filesystem::path const scenes = std::filesystem::path(HDCONJ_SOURCE_DIR) / "data/scenes";

std::string sound()
{
    return test::content((scenes / "type-50-wanted.toml").string());
}

std::string const flexspline_head = "[flexspline.profile]\n";
std::string const spline_tail = "[circular_spline.profile]";

std::vector<BadScene> const& wrong_keys()
{
    static std::vector<BadScene> const table{
        {"another family with both teeth", "family = \"wanted\"", "family = \"cosine\"\nradial_deformation = 0.25",
         "circular_spline.profile", "both teeth are given", "wave_generator.family = \"wanted\"", 0},
        {"misspelt family", "family = \"wanted\"", "family = \"wantet\"", "wave_generator.family", "unknown word",
         "wanted", 0},
        {"displacement in quotes", "major_displacement = 0.24743281327", "major_displacement = \"0.247\"",
         "wave_generator.major_displacement", "text where", "without quotes"},
        {"displacement 0", "major_displacement = 0.24743281327", "major_displacement = 0.0",
         "wave_generator.major_displacement", "above 0", "above 0"},
        {"displacement negative", "major_displacement = 0.24743281327", "major_displacement = -0.2",
         "wave_generator.major_displacement", "above 0", "above 0"},
        {"displacement not finite", "major_displacement = 0.24743281327", "major_displacement = inf",
         "wave_generator.major_displacement", "finite", "above 0"},
        {"displacement a list", "major_displacement = 0.24743281327", "major_displacement = [0.2]",
         "wave_generator.major_displacement", "list", "length"},
        {"displacement that bends no ring", "major_displacement = 0.24743281327", "major_displacement = 7.0",
         "wave_generator.major_displacement", "bends no ring", "one module", 0},
        {"displacement into the rim", "major_displacement = 0.24743281327", "major_displacement = 0.5",
         "wave_generator.major_displacement", "cut into the flexspline's rim", "write less than"},
        {"misspelt displacement", "major_displacement = 0.24743281327", "major_displacment = 0.24",
         "wave_generator.major_displacment", "unknown key", "major_displacement"},
        {"deformation of another family", "major_displacement = 0.24743281327", "radial_deformation = 0.25",
         "wave_generator.radial_deformation", "unknown key", "family"},
        {"distance negative", "inner_distance = 4.85", "inner_distance = -1.0", "wave_generator.inner_distance",
         "must not be negative", "0 or more"},
        {"distance beyond the axis", "inner_distance = 4.85", "inner_distance = 30.0", "wave_generator.inner_distance",
         "leaves no cam", "half the wall"},
        {"distance in quotes", "inner_distance = 4.85", "inner_distance = \"4.85\"", "wave_generator.inner_distance",
         "text where", "without quotes"},
        {"file of another family", "inner_distance = 4.85", "file = \"cam-table.csv\"", "wave_generator.file",
         "unknown key", "family"},
        {"waves a fraction", "waves = 2", "waves = 2.5", "wave_generator.waves", "whole number", "whole number", 0},
        {"waves that do not divide", "waves = 2", "waves = 3", "drive.circular_spline_teeth", "multiple of", "203", 0},
        {"heights told twice", "wall = 0.7 ", "addendum = 0.2\nwall = 0.7 ", "flexspline.addendum",
         "told in [flexspline.profile]", "flexspline.profile.addendum"},
        {"depth told twice", "wall = 0.7 ", "dedendum = 0.3\nwall = 0.7 ", "flexspline.dedendum",
         "told in [flexspline.profile]", "flexspline.profile.dedendum"},
        {"material motion", "kinematics = \"exact\"", "kinematics = \"material\"", "solver.kinematics",
         "Fourier series", "first-order"},
        {"unknown motion", "kinematics = \"exact\"", "kinematics = \"second-order\"", "solver.kinematics",
         "unknown word", "exact"},
        {"tolerance of a module", "tolerance = 1e-8", "tolerance = 0.2", "solver.tolerance", "too coarse for a tooth",
         "write at most", 0},
    };
    return table;
}

std::vector<BadScene> const& wrong_pairs()
{
    static std::vector<BadScene> const table{
        {"no tip circle", "inner_radius = 25", "# 25", "circular_spline.inner_radius",
         "the radius at which the given teeth", "tip circle in mm", 0},
        {"tip circle in quotes", "inner_radius = 25.0495388005933", "inner_radius = \"25\"",
         "circular_spline.inner_radius", "text where", "without quotes", 0},
        {"tip circle out of reach", "inner_radius = 25.0495388005933", "inner_radius = 27.0",
         "circular_spline.inner_radius", "no tooth enters", "write less than"},
        {"tip circle inside the tips", "inner_radius = 25.0495388005933", "inner_radius = 24.5",
         "circular_spline.inner_radius", "tips would meet roots", "write more than"},
        {"side clearance", "width = 7.0", "width = 7.0\nbacklash_offset = 0.01", "circular_spline.backlash_offset",
         "no side clearance is looked for", "remove this key"},
        {"automatic side clearance", "width = 7.0", "width = 7.0\nbacklash_offset = \"auto\"",
         "circular_spline.backlash_offset", "no side clearance is looked for", "remove this key", 0},
        {"root clearance", "width = 7.0", "width = 7.0\nroot_clearance = 0.02", "circular_spline.root_clearance",
         "told by its given tooth", "a tooth in [circular_spline.profile] with a larger dedendum and remove this key"},
        {"slices", "[solver]", "[slices]\ncount = 5\n[solver]", "slices", "in one plane", "remove [slices]"},
        {"coning", "[solver]", "[coning]\nmodel = \"linear\"\nbottom_to_middle = 9.0\n[solver]", "coning",
         "in one plane", "remove [coning]", 0},
        {"tilt", "[solver]", "[tilt]\nangle_deg = 0.2\nkind = \"radial\"\n[solver]", "tilt", "in one plane",
         "remove [tilt]", 0},
        {"contact", "[solver]", "[contact]\n[solver]", "contact", "neutral curve is known", "remove [contact]", 0},
        {"load", "[solver]", "[load]\ntorque = 28.0\n[solver]", "load", "neutral curve is known", "remove [load]", 0},
        {"wire", "[solver]", "[wedm]\nwire_diameter = 0.1\nspark_gap = 0.006\n[solver]", "wedm",
         "neutral curve is known", "remove [wedm]", 0},
        {"missing file", "type-50-wanted-tooth.csv", "nowhere.csv", "circular_spline.profile.file", "cannot be read",
         "relative to the scene file"},
        {"the cam for a tooth", "type-50-wanted-tooth.csv", "cam-table.csv", "circular_spline.profile.file", "", ""},
        {"no file", "file = \"type-50-wanted-tooth.csv\"", "", "circular_spline.profile.file", "missing", "file"},
        {"both flanks of one", "side = \"right\"", "side = \"middle\"", "circular_spline.profile.side", "unknown word",
         "right"},
        {"flexspline's arcs do not meet", "concave_offset = \"tangent\"", "concave_offset = 0.3",
         "flexspline.profile.concave_offset", "do not meet", "tangent"},
        {"flexspline's tooth wider than its pitch", "convex_offset = 0.0982", "convex_offset = -0.2",
         "flexspline.profile", "", ""},
        {"family of the flexspline's tooth", flexspline_head + "family = \"double-circular-arc\"",
         flexspline_head + "family = \"gothic\"", "flexspline.profile.family", "unknown word", "double-circular-arc",
         0},
        {"misspelt table of the other tooth", spline_tail, "[circular_spline.profil]", "circular_spline.profil",
         "unknown table", "[circular_spline.profile]", 0},
        {"no hole", "wall = 0.7 ", "wall = 24.8 ", "flexspline.wall", "leaves no hole", "thinner", 0},
        {"inner radius of another drive", "wall = 0.7 ", "inner_radius = 12.0\nwall = 0.7 ", "flexspline.inner_radius",
         "contradicts module and teeth", "write about that radius", 0},
    };
    return table;
}

void refused(std::vector<BadScene> const& rows)
{
    for (auto const& row : rows) {
        SECTION(row.name)
        {
            auto const faults = test::faults_of(test::edited(sound(), row), scenes);
            INFO(row.name << "\n" << describe(faults));
            auto const* const fault = test::find_fault(faults, row.path);
            REQUIRE(fault != nullptr);
            CHECK_THAT(fault->reason, ContainsSubstring(row.reason));
            CHECK_THAT(fault->remedy, ContainsSubstring(row.remedy));
            test::check_all(faults, row);
        }
    }
}

/// The sound scene without the lines from @p from up to @p to.
std::string without(std::string const& from, std::string const& to)
{
    std::string text = sound();
    std::size_t const first = text.find(from);
    text.erase(first, text.find(to, first) - first);
    return text;
}

}  // namespace

TEST_CASE("the scene with a wanted neutral curve has no fault", "[scene][wanted]")
{
    auto const faults = test::faults_of(sound(), scenes);
    INFO(describe(faults));
    CHECK(faults.empty());
}

TEST_CASE("wrong keys of a wanted neutral curve are refused", "[scene][wanted]")
{
    refused(wrong_keys());
}

TEST_CASE("wrong pairs around a wanted neutral curve are refused", "[scene][wanted]")
{
    refused(wrong_pairs());
}

TEST_CASE("a tip circle out of reach is refused without a displacement too", "[scene][wanted]")
{
    std::string text = without("major_displacement", "inner_distance");
    std::string const radius = "inner_radius = 25.0495388005933";
    CHECK(test::faults_of(text, scenes).empty());
    text.replace(text.find(radius), radius.size(), "inner_radius = 60.0");
    auto const faults = test::faults_of(text, scenes);
    INFO(describe(faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].path == "circular_spline.inner_radius");
    CHECK_THAT(faults[0].reason, ContainsSubstring("no tooth enters"));
    CHECK_THAT(faults[0].remedy, ContainsSubstring("usually 25"));
}

TEST_CASE("a wanted neutral curve needs both teeth", "[scene][wanted]")
{
    auto const no_outer = test::faults_of(without("[circular_spline.profile]", "[solver]"), scenes);
    INFO(describe(no_outer));
    REQUIRE(test::find_fault(no_outer, "circular_spline.profile") != nullptr);
    CHECK_THAT(test::find_fault(no_outer, "circular_spline.profile")->reason,
               ContainsSubstring("wanted between both teeth"));
    auto const no_inner = test::faults_of(without("[flexspline.profile]", "[wave_generator]"), scenes);
    INFO(describe(no_inner));
    CHECK(test::find_fault(no_inner, "flexspline.profile") != nullptr);
}

}  // namespace hdconj::test::bad_wanted_scenes_cases
