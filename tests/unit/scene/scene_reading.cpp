// SPDX-License-Identifier: GPL-3.0-or-later
// What a right scene becomes.
#include "hdconj/read_scene.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::scene_reading_cases {

namespace {

std::string with(std::string const& more)
{
    return std::string(builtin_scene_text()) + more;
}

/// The smallest scene: nothing but what is required.
constexpr char const* smallest = R"([drive]
module = 0.25
flexspline_teeth = 200
circular_spline_teeth = 202
[flexspline]
wall = 0.7
[flexspline.profile]
family = "straight"
addendum = 0.2
dedendum = 0.3
thickness = 0.35
pressure_angle_deg = 20
[wave_generator]
family = "cosine"
radial_deformation = 0.25
)";

}  // namespace

TEST_CASE("the built-in scene is the type-50 drive", "[scene]")
{
    Scene const scene = builtin_scene();
    CHECK(scene.drive.name == "type-50");
    CHECK(scene.drive.module == 0.25);
    CHECK(scene.drive.flexspline_teeth == 200);
    CHECK(scene.drive.circular_spline_teeth == 202);
    CHECK(scene.flexspline.wall == 0.7);
    CHECK_FALSE(scene.flexspline.inner_radius.has_value());
    CHECK(scene.flexspline.profile.family == "double-circular-arc");
    CHECK(scene.flexspline.profile.path == "flexspline.profile");
    CHECK(scene.flexspline.profile.number("convex_radius") == 0.2701);
    CHECK(scene.flexspline.profile.word("concave_offset") == "tangent");
    CHECK(scene.flexspline.profile.text_of("concave_offset") == "\"tangent\"");
    CHECK_FALSE(scene.flexspline.profile.number("concave_offset").has_value());
    CHECK(scene.flexspline.profile.number_or("convex_rise", -1) == -1);
    CHECK(scene.wave_generator.shape.path == "wave_generator");
    CHECK(scene.wave_generator.shape.number("radial_deformation") == 0.25);
    CHECK(scene.wave_generator.waves == 2);
    CHECK(scene.circular_spline.inner_radius == 25.025);
    CHECK(scene.solver.kinematics == Kinematics::exact);
    CHECK(scene.solver.tolerance == 1e-6);
    CHECK_FALSE((scene.coning || scene.tilt || scene.slices));
    CHECK(scene.text == builtin_scene_text());
}

TEST_CASE("what a scene leaves out has its default", "[scene]")
{
    Scene const scene = parse_scene(smallest, "smallest");
    CHECK(scene.drive.name == "unnamed");
    CHECK(scene.flexspline.neutral_offset == 0);
    CHECK(scene.wave_generator.waves == 2);
    CHECK_FALSE(scene.circular_spline.width.has_value());
    CHECK_FALSE(scene.circular_spline.inner_radius.has_value());
    CHECK(scene.circular_spline.backlash_offset == 0);
    CHECK(scene.solver.kinematics == Kinematics::exact);
    CHECK(scene.solver.tolerance == 1e-6);
    CHECK(scene.solver.threads == 0);
}

TEST_CASE("defaults of the schema are those of an empty Scene", "[scene]")
{
    Scene const given = parse_scene(smallest, "smallest");
    Scene const empty;
    CHECK(given.solver.tolerance == empty.solver.tolerance);
    CHECK(given.solver.kinematics == empty.solver.kinematics);
    CHECK(given.solver.threads == empty.solver.threads);
    CHECK(given.wave_generator.waves == empty.wave_generator.waves);
    CHECK(given.flexspline.neutral_offset == empty.flexspline.neutral_offset);
    CHECK(given.circular_spline.backlash_offset == empty.circular_spline.backlash_offset);
    CHECK(given.circular_spline.root_clearance == empty.circular_spline.root_clearance);
}

TEST_CASE("lines of keys are those of the file", "[scene]")
{
    Scene const scene = parse_scene(smallest, "smallest");
    CHECK(scene.given.at("drive.module").line == 2);
    CHECK(scene.given.at("flexspline.profile.thickness").line == 11);
    CHECK(scene.given.at("flexspline.profile.thickness").written == "0.35");
    CHECK(scene.flexspline.profile.line == 8);
    CHECK(scene.flexspline.profile.line_of("dedendum") == 10);
    CHECK(scene.flexspline.profile.line_of("not_given") == 8);
    CHECK_FALSE(scene.given.contains("solver.tolerance"));
}

TEST_CASE("a byte order mark, CRLF and columns beyond ASCII change nothing", "[scene]")
{
    std::string text = "\xef\xbb\xbf# gr\xc3\xbc\xc3\x9f\n" + std::string(smallest);
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
        text.insert(at, "\r");
    Scene const scene = parse_scene(text, "scene");
    CHECK(scene.drive.module == 0.25);
    CHECK(scene.given.at("drive.module").line == 3);
    CHECK(scene.given.at("drive.module").written == "0.25");
}

TEST_CASE("a value behind letters beyond ASCII is cut out right", "[scene]")
{
    auto const reading = examine_scene("[drive]\n\"gr\xc3\xbc\xc3\x9f\" = 0.5 # \xc3\xbc\n", "scene");
    auto const fault =
        std::find_if(reading.faults.begin(), reading.faults.end(), [](Fault const& f) { return f.line == 2; });
    REQUIRE(fault != reading.faults.end());
    CHECK(fault->value == "0.5");
}

TEST_CASE("a whole number is a length, inline tables and dotted keys are tables", "[scene]")
{
    Scene const scene = parse_scene(R"(
drive = { module = 1, flexspline_teeth = 0xC8, circular_spline_teeth = 2_02 }
flexspline.wall = 3
flexspline.profile = { family = "straight", addendum = 1, dedendum = 1, thickness = 1.4, pressure_angle_deg = 20 }
wave_generator = { family = "cosine", radial_deformation = 1 }
)",
                                    "scene");
    CHECK(scene.drive.module == 1);
    CHECK(scene.drive.flexspline_teeth == 200);
    CHECK(scene.drive.circular_spline_teeth == 202);
    CHECK(scene.flexspline.wall == 3);
}

TEST_CASE("effects exist when their table does", "[scene]")
{
    Scene const scene =
        parse_scene(with("[coning]\nmodel = \"linear\"\nbottom_to_middle = 9.0\n[tilt]\nangle_deg = -0.2\n"
                         "[slices]\ncount = 9\nsurface = \"ruled\"\n"),
                    "scene");
    REQUIRE((scene.coning && scene.tilt && scene.slices));
    CHECK(scene.coning->model == ConingModel::linear);
    CHECK(scene.coning->bottom_to_middle == 9.0);
    CHECK(scene.tilt->angle == -0.2 * (std::numbers::pi / 180));
    CHECK(scene.tilt->kind == TiltKind::radial);
    CHECK(scene.slices->count == 9);
    CHECK(scene.slices->surface == ToothSurface::ruled);
    CHECK(scene.slices->line == scene.given.at("slices").line);
}

namespace {

// the built-in scene has a cup and a bearing
constexpr auto elastic = "[coning]\nmodel = \"elastic\"\nbottom_to_middle = 9\n";

}  // namespace

TEST_CASE("effects that are allowed together are", "[scene]")
{
    CHECK_NOTHROW(parse_scene(with("[slices]\ncount = 9\nsurface = \"tilted\"\n"), "no tilt"));
    CHECK_NOTHROW(parse_scene(with("[slices]\ncount = 1\n"), "one slice"));
    CHECK_NOTHROW(parse_scene(with("[tilt]\nangle_deg = 0\nkind = \"draft\"\n"), "draft without slices"));
    CHECK_NOTHROW(parse_scene(with("[tilt]\nangle_deg = 44.9\nkind = \"draft\"\n[slices]\ncount = 3\n"), "draft"));
    CHECK_NOTHROW(parse_scene(with(elastic), "elastic"));
}

TEST_CASE("tables of an elastic scene are read with what they leave out", "[scene]")
{
    Scene const scene = parse_scene(with(elastic), "scene");
    CHECK(scene.is_elastic());
    REQUIRE(scene.bearing);
    CHECK(scene.bearing->elastic);
    CHECK(scene.bearing->axially_held);
    CHECK(scene.bearing->angles == 48);
    CHECK_FALSE(scene.bearing->radial_stiffness);
    REQUIRE(scene.flexspline.cup);
    CHECK(scene.flexspline.cup->youngs_modulus == 206000);
    CHECK(scene.flexspline.cup->fatigue_strength == 670);
    CHECK(scene.flexspline.cup->rear_ramp == 0.4);
    CHECK_FALSE(scene.flexspline.cup->rear_fillet);
    CHECK_FALSE(scene.flexspline.cup->tooth_layer);
    std::vector<std::string> const keys{"!flexspline.cup.rear_ramp", "flexspline.cup.rear_fillet=0.5",
                                        "flexspline.cup.tooth_layer=0.53", "flexspline.cup.fatigue_strength=550"};
    Scene const detailed = parse_scene(with(elastic), "scene", {}, keys);
    CHECK(detailed.flexspline.cup->rear_fillet == 0.5);
    CHECK(detailed.flexspline.cup->tooth_layer == 0.53);
    CHECK(detailed.flexspline.cup->tooth_share == 0.5);
    CHECK(detailed.flexspline.cup->fatigue_strength == 550);
}

TEST_CASE("an elastic cup with keys that say nothing together is refused with the reason", "[scene]")
{
    auto const refused = [](std::vector<std::string> const& overrides, std::string const& path,
                            std::string const& reason) {
        auto reading = examine_scene(with(elastic), "scene", {}, overrides);
        examine_geometry(reading);
        INFO(describe(reading.faults));
        auto const fault =
            std::find_if(reading.faults.begin(), reading.faults.end(), [&](Fault const& f) { return f.path == path; });
        REQUIRE(fault != reading.faults.end());
        CHECK_THAT(fault->reason, ContainsSubstring(reason));
        CHECK_FALSE(fault->remedy.empty());
    };
    refused({"!bearing"}, "bearing", "needs what pushes");
    refused({"!flexspline.cup"}, "flexspline.cup", "needs the cup's dimensions");
    refused({"!coning.bottom_to_middle"}, "coning.bottom_to_middle", "missing");
    refused({"coning.apex_height=0.4"}, "coning.apex_height", "tells where its apex is");
    refused({"bearing.type=rigid"}, "bearing.ring_thickness", "no outer ring");
    refused({"!bearing.ring_thickness"}, "bearing.ring_thickness", "missing");
    refused({"bearing.width=0"}, "bearing.width", "width above 0");
    refused({"bearing.angles=47"}, "bearing.angles", "odd");
    refused({"bearing.angles=512", "bearing.circles=101"}, "bearing.angles", "51712 points of contact");
    refused({"bearing.width=20"}, "bearing.width", "beyond the straight wall");
    refused({"bearing.ring_thickness=30"}, "bearing.ring_thickness", "inner radius");
    refused({"bearing.radial_stiffness=0"}, "bearing.radial_stiffness", "at least 1");
    refused({"flexspline.cup.corner_radius=0.3"}, "flexspline.cup", "corner at the bottom");
    refused({"flexspline.cup.flange_radius=30"}, "flexspline.cup", "flange");
    refused({"flexspline.cup.tooth_width=14"}, "flexspline.cup", "rear ramp begins");
    refused({"flexspline.cup.rear_fillet=0.5"}, "flexspline.cup.rear_fillet", "takes the place of the ramp");
    refused({"!flexspline.cup.rear_ramp", "flexspline.cup.rear_fillet=0.1"}, "flexspline.cup",
            "less than the wall grows by");
    refused({"flexspline.cup.tooth_share=0.3"}, "flexspline.cup.tooth_share", "no layer of teeth");
    refused({"flexspline.cup.tooth_layer=0.5", "flexspline.cup.tooth_share=0"}, "flexspline.cup.tooth_share",
            "at least");
    refused({"flexspline.cup.poissons_ratio=0.5"}, "flexspline.cup.poissons_ratio", "at most 0.499");
    refused({"flexspline.cup.fatigue_strength=0.5"}, "flexspline.cup.fatigue_strength", "at least 1");
    refused({"flexspline.cup.fatigue_strength=200000"}, "flexspline.cup.fatigue_strength", "at most 100000");
    refused({"bearing.friction=0.08"}, "bearing.friction", "unknown key");
    refused({"circular_spline.width=9", "slices.count=3"}, "circular_spline.width", "beyond the flexspline's teeth");
    refused({"bearing.ball_diameter=3"}, "bearing.ball_diameter", "continuous row");
    refused({"bearing.balls=22", "bearing.inner_conformity=0.52"}, "bearing.inner_conformity", "without ball_diameter");
    refused({"bearing.balls=22", "bearing.ball_youngs_modulus=3e5"}, "bearing.ball_youngs_modulus",
            "without ball_diameter");
    refused({"bearing.balls=22", "bearing.ball_diameter=3", "bearing.radial_stiffness=2000"},
            "bearing.radial_stiffness", "says already how the balls yield");
    refused({"bearing.type=rigid", "!bearing.ring_thickness", "!bearing.axially", "bearing.clearance=0.01"},
            "bearing.clearance", "no outer ring");
    refused({"bearing.balls=23", "bearing.ball_diameter=6"}, "bearing.ball_diameter", "do not fit");
    // the root circle lies further out by the side clearance
    refused({"circular_spline.backlash_offset=0.1", "compliance.outer_radius=25.53"}, "compliance.outer_radius",
            "nothing is left");
}

TEST_CASE("members in series and balls are read in their units", "[scene]")
{
    Scene const scene = parse_scene(with(elastic), "scene", {},
                                    {"compliance.flange=200000", "compliance.outer_radius=35", "bearing.balls=23",
                                     "bearing.ball_diameter=3", "bearing.clearance=0.005"});
    REQUIRE(scene.compliance);
    CHECK(scene.compliance->flange == 200e6);
    CHECK_FALSE(scene.compliance->hub);
    CHECK_FALSE(scene.compliance->shaft);
    CHECK(scene.compliance->outer_radius == 35);
    REQUIRE(scene.bearing);
    CHECK(scene.bearing->ball_diameter == 3);
    CHECK(scene.bearing->inner_conformity == 0.52);
    CHECK(scene.bearing->outer_conformity == 0.52);
    CHECK(scene.bearing->clearance == 0.005);
    CHECK(scene.bearing->youngs_modulus == 206e3);
    CHECK(scene.bearing->ball_poissons_ratio == 0.3);
}

TEST_CASE("a scene read from a file knows its folder", "[scene]")
{
    test::TemporaryFolder const folder;
    std::ofstream(folder / "scene.toml") << smallest;
    Scene const scene = read_scene(folder / "scene.toml");
    CHECK(scene.folder == folder.path());
    CHECK(scene.text == smallest);
}

TEST_CASE("reading throws what examining reports", "[scene]")
{
    std::string const text = "[drive]\nmodule = -1\n";
    auto const reading = examine_scene(text, "scene");
    try {
        (void)parse_scene(text, "scene");
        FAIL("a bad scene was read");
    } catch (InputError const& error) {
        CHECK(describe(error.faults()) == describe(reading.faults));
        CHECK(error.what() == describe(reading.faults));
    }
}

TEST_CASE("a fault says whether another scene may take what it refuses", "[scene]")
{
    auto const kind_of = [](std::string const& override_text) {
        auto reading = examine_scene(builtin_scene_text(), "scene", {}, {override_text});
        examine_geometry(reading);
        REQUIRE(reading.faults.size() == 1);
        return kind_word(reading.faults.front().kind);
    };
    CHECK(kind_of("flexspline.wal=1") == "unknown");
    CHECK(kind_of("flexspin.wall=1") == "unknown");
    CHECK(kind_of("flexspline.wall=-1") == "value");
    CHECK(kind_of("flexspline.wall=thick") == "value");
    CHECK(kind_of("drive.flexspline_teeth=199.5") == "value");
    CHECK(kind_of("drive=3") == "value");
    CHECK(kind_of("drive.circular_spline_teeth=203") == "other");
    CHECK(kind_of("flexspline.profile.addendum=0.9") == "other");
}

TEST_CASE("faults are sorted by line, those without a line behind, the command line last", "[scene]")
{
    Faults faults{
        {"a", 0, "", "r", "w", "--set"}, {"b", 0, "", "r", "w"}, {"c", 9, "", "r", "w"}, {"d", 3, "", "r", "w"}};
    sort_by_place(faults);
    std::string order;
    for (auto const& fault : faults)
        order += fault.path;
    CHECK(order == "dcba");
}

TEST_CASE("a fault reads as one line", "[scene]")
{
    CHECK(describe({{"flexspline.wall", 12, "-0.7", "must be above 0", "write 0.7"}}) ==
          "line 12: flexspline.wall = -0.7: must be above 0 (write 0.7)");
    CHECK(describe({{"drive", 0, "", "this table is missing", ""}}) == "drive: this table is missing");
    CHECK(describe({{"x", 0, "1", "bad", "write 2", "--set"}}) == "--set: x = 1: bad (write 2)");
    Faults const many(1000, Fault{"x", 1, "", "bad", "write y"});
    auto const text = describe(many);
    CHECK(std::count(text.begin(), text.end(), '\n') == 100);
    CHECK(text.ends_with("and 900 more faults"));
}

TEST_CASE("a bound of a tenth of the module takes the tenth as it is written", "[scene]")
{
    using Written = std::pair<std::string, std::string>;
    for (auto const& [module, tenth] : {Written{"0.35", "0.035"}, {"0.7", "0.07"}, {"1.9", "0.19"}}) {
        auto const reading =
            examine_scene(builtin_scene_text(), "scene", {}, {"drive.module=" + module, "solver.tolerance=" + tenth});
        for (Fault const& fault : reading.faults) {
            INFO(module << ": " << fault.reason);
            CHECK(fault.path != "solver.tolerance");
        }
    }
}

TEST_CASE("a remedy that knows no usual deformation names none", "[scene]")
{
    auto const reading =
        examine_scene(builtin_scene_text(), "scene", {}, {"drive.flexspline_teeth=6", "drive.circular_spline_teeth=8"});
    REQUIRE_FALSE(reading.faults.empty());
    for (Fault const& fault : reading.faults)
        CHECK_THAT(fault.remedy, !ContainsSubstring("usual is"));
}

}  // namespace hdconj::test::scene_reading_cases
