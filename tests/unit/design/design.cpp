// SPDX-License-Identifier: GPL-3.0-or-later
// A drive from wishes: rules, the scene, what is printed.
#include "hdconj/design.hpp"
#include "hdconj/units.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/text.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::design_cases {
namespace {

DesignWishes type_50()
{
    DesignWishes wishes;
    wishes.ratio = 100;
    wishes.diameter = 50;
    wishes.length_ratio = 0.3;
    return wishes;
}

Design const& designed_50()
{
    static Design const design = design_drive(type_50());
    return design;
}

/// The value called @p symbol.
double value(Design const& design, std::string_view symbol)
{
    for (auto const& row : design.rows)
        if (row.symbol == symbol)
            return row.number();
    FAIL("no row is called " << symbol);
    return 0;
}

/// Whether @p design says that the assembled cup was not looked at, for want of a torque.
bool says_without_torque(Design const& design)
{
    return std::ranges::any_of(design.remarks,
                               [](std::string const& each) { return each.starts_with("without --torque"); });
}

}  // namespace

TEST_CASE("the wishes of type-50 make its teeth, its wave generator and its tip circle", "[design]")
{
    Scene const& scene = designed_50().scene;
    Scene const there = builtin_scene();
    CHECK(scene.drive.module == there.drive.module);
    CHECK(scene.drive.flexspline_teeth == there.drive.flexspline_teeth);
    CHECK(scene.drive.circular_spline_teeth == there.drive.circular_spline_teeth);
    for (auto const& [key, parameter] : there.flexspline.profile.given)
        CHECK(scene.flexspline.profile.given.at(key).value == parameter.value);
    CHECK(scene.wave_generator.shape.number("radial_deformation") ==
          there.wave_generator.shape.number("radial_deformation"));
    CHECK(scene.circular_spline.inner_radius == there.circular_spline.inner_radius);
    CHECK(scene.flexspline.wall == there.flexspline.wall);
    CHECK(scene.flexspline.cup->length == there.flexspline.cup->length);
    CHECK(scene.flexspline.cup->tooth_width == there.flexspline.cup->tooth_width);
}

TEST_CASE("what a design differs in from type-50 is named with its rule", "[design]")
{
    std::vector<std::string> keys;
    for (auto const& each : differences(designed_50(), builtin_scene())) {
        CHECK_FALSE(each.why.empty());
        keys.push_back(each.key);
    }
    CHECK(keys == std::vector<std::string>{"flexspline.cup.bottom", "flexspline.cup.front_fillet",
                                           "flexspline.cup.rear_fillet", "flexspline.cup.corner_radius",
                                           "flexspline.cup.front_ramp", "flexspline.cup.rear_ramp", "load.torque",
                                           "wedm.spark_gap", "wedm.wire_diameter"});
    CHECK(differences(designed_50(), designed_50().scene).empty());
}

TEST_CASE("a scene stands for wishes, and each says where it comes from", "[design]")
{
    std::vector<DerivedWish> derived;
    DesignWishes const wishes = wishes_of(builtin_scene(), &derived);
    CHECK(wishes.ratio == 100);
    CHECK(wishes.module == 0.25);
    CHECK(wishes.length_ratio == 0.3);
    CHECK(wishes.torque == 28000);
    CHECK(wishes.family == "double-circular-arc");
    CHECK(check_design(wishes).empty());
    CHECK(derived.size() == 9);
    for (DerivedWish const& wish : derived)
        CHECK_FALSE(wish.from.empty());

    // the steel: one of the table, or one with a strength of its own
    Scene steel = builtin_scene();
    steel.flexspline.cup->fatigue_strength = 550;
    CHECK(wishes_of(steel).material == "42CrMo4");
    CHECK_FALSE(wishes_of(steel).fatigue);
    steel.flexspline.cup->fatigue_strength = 500;
    derived.clear();
    CHECK(wishes_of(steel, &derived).fatigue == 500);
    CHECK(derived.size() == 10);

    Scene ring = builtin_scene();
    ring.flexspline.cup.reset();
    ring.load.reset();
    CHECK_FALSE(wishes_of(ring).torque.has_value());
    CHECK(wishes_of(ring).length_ratio == DesignWishes().length_ratio);

    Scene three = builtin_scene();
    three.wave_generator.waves = 3;
    three.drive.circular_spline_teeth = 203;
    three.flexspline.profile.family = "points";
    try {
        (void)wishes_of(three);
        FAIL("three waves have no wishes");
    } catch (InputError const& error) {
        CHECK(error.faults().size() == 3);
    }
}

TEST_CASE("a drive beside the design of its wishes", "[design]")
{
    Scene const scene = parse_scene(scene_text(designed_50()), "designed.toml");
    SceneDesign const own = design_beside(solve(scene));
    CHECK(own.design.differences.empty());
    for (std::size_t i = 0; i < own.here.size(); ++i) {
        INFO(own.design.rows[i].name);
        CHECK((own.here[i].standing == RuleStanding::as_proposed || own.here[i].standing == RuleStanding::limited ||
               own.here[i].standing == RuleStanding::no_key));
    }

    SceneDesign const made = design_beside(solve(builtin_scene()));
    auto const standing = [&](std::string_view symbol) {
        for (std::size_t i = 0; i < made.here.size(); ++i)
            if (made.design.rows[i].symbol == symbol)
                return to_string(made.here[i].standing);
        return std::string_view();
    };
    CHECK(standing("delta") == "as proposed");
    CHECK(standing("delta_2") == "outside the range");  // 0.5 mm, at most 0.7 * 0.7 mm
    CHECK(standing("L_2") == "as proposed, outside the range");
    CHECK(standing("R_1") == "not stated");
    CHECK(standing("d_rn") == "as proposed");
    CHECK(standing("t") == "not in a scene");
    auto const clearance = std::ranges::find(made.design.rows, "side clearance", &DesignRow::name);
    CHECK(to_string(made.here[static_cast<std::size_t>(clearance - made.design.rows.begin())].standing) ==
          "outside the range");  // none, and the cone needs some
    CHECK(made.design.other == "type-50");
    CHECK_FALSE(made.design.differences.empty());
}

TEST_CASE("a design under torque keeps its land with the clearances that its cone needs", "[design]")
{
    std::vector<DesignWishes> all(3, type_50());
    all[0].torque = 28 * newton_metre;
    all[0].length_ratio = 0.25;
    all[1].ratio = 160;
    all[1].diameter = 40;
    all[1].torque = 8 * newton_metre;
    all[1].clearance = 0.01;
    all[2].torque = 15 * newton_metre;
    all[2].family = "involute";
    if (!full_run())
        all.pop_back();  // one whose walls are nearly all tried, for half a minute
    for (DesignWishes const& wishes : all) {
        Design const made = design_drive(wishes);
        CHECK_FALSE(says_without_torque(made));
        Scene const& scene = made.scene;
        INFO(wishes.family << " " << wishes.ratio);
        CHECK(scene.circular_spline.backlash_offset > wishes.clearance);
        CHECK(std::ranges::count(made.remarks, "side clearance: the coned cup needs " +
                                                   short_number(scene.circular_spline.backlash_offset) +
                                                   " mm to clear, more than --clearance") == 1);
        Solution const solved = solve(scene);
        CHECK(2 * solved.geometry.land_half_angle * solved.geometry.circular_spline_inner_radius >=
              wishes.land * scene.drive.module);
        LoadOptions load;
        load.curve = load.errors = false;
        LoadCase const loaded = study_load(scene, load).cases.front();
        CHECK_FALSE(loaded.side_clearance_increased);
        CHECK(loaded.tip_radius_increase == 0);
        ContactOptions contact;
        contact.errors = false;
        ContactCase const coned = study_contact(scene, contact).cases.front();
        CHECK_FALSE(coned.side_clearance_increased);
        CHECK(coned.closest_flank().clearance >= 0);
        CHECK(coned.tip == scene.circular_spline.inner_radius);
        CHECK(scene.circular_spline.root_clearance > 0);
        CHECK(coned.least_root_clearance == 0);
        // load has the same cup and slices of a scene without them
        Scene bare = scene;
        bare.coning.reset();
        bare.slices.reset();
        Scene const completed = loaded_scene(bare);
        CHECK(completed.coning->model == scene.coning->model);
        CHECK(*completed.coning->bottom_to_middle == Approx(*scene.coning->bottom_to_middle).margin(1e-5));
        CHECK(completed.slices->count == scene.slices->count);
        CHECK(completed.slices->surface == scene.slices->surface);
    }
}

TEST_CASE("the rules that the thesis breaks are named", "[design]")
{
    std::string all;
    for (auto const& remark : designed_50().remarks)
        all += remark + "\n";
    for (char const* const symbol : {"l_f:", "delta_2:", "L_2:", "R_3:", "t:", "d_2:", "d_rn:", "b_g:"})
        CHECK_THAT(all, ContainsSubstring(symbol));
}

TEST_CASE("dimensions of a design obey the thesis' equations", "[design]")
{
    Design const& made = designed_50();
    // (4-1), (4-2), Table 4-1 by hand
    CHECK(value(made, "z_f") == 100 * 2);
    CHECK(value(made, "z_c") == 200 * (1 + 1. / 100));
    CHECK(value(made, "d_r") == 0.25 * 200);
    CHECK(value(made, "d_rn") == 47.994);  // 50 - 2 * 0.303 - 2 * 0.7
    CHECK(value(made, "d_gw") >= 1.4 * 50);
    for (auto const& row : made.rows)
        if (row.range && row.origin == DesignOrigin::rule) {
            INFO(row.symbol);
            CHECK(row.range->contains(row.number()));
        }
}

TEST_CASE("the page of design rules states the rules of the program", "[design]")
{
    std::ifstream file(HDCONJ_SOURCE_DIR "/docs/reference/design.md");
    std::string const page{std::istreambuf_iterator<char>(file), {}};
    int stated = 0;
    for (auto const& row : designed_50().rows)
        if (row.range && row.origin != DesignOrigin::figure && row.source.starts_with("thesis")) {
            INFO(row.symbol);
            std::string const rule = row.symbol == "d_gw" ? "at least 1.4 d_r" : row.rule;
            CHECK_THAT(page, ContainsSubstring("| " + row.symbol + " | " + row.name + " | " + rule + " |"));
            ++stated;
        }
    CHECK(stated == 12);
}

TEST_CASE("ready drives keep the rules and solve without a note", "[design]")
{
    std::vector<ReadyDrive> const& all = ready_drives();
    for (auto const& each : full_run() ? all : std::vector{all.front(), all.back()}) {
        Design const made = design_drive(ready_wishes(each.name));
        INFO(each.name);
        CHECK(made.scene.drive.name == each.name);
        CHECK(solve(made.scene).judgement.empty());
        for (auto const& row : made.rows)
            if (row.origin == DesignOrigin::limited)  // a cup half as long as its diameter leaves the rules alone
                CHECK(row.key == "flexspline.profile.concave_offset");
    }
    CHECK_THROWS_AS(ready_wishes("size-21"), std::logic_error);
}

TEST_CASE("the scene of a design read back is the same scene", "[design]")
{
    Scene const again = parse_scene(scene_text(designed_50()), "designed");
    Design other = designed_50();
    CHECK(differences(other, again).empty());
    CHECK(again.given.size() == designed_50().scene.given.size());
    // every key has a comment
    std::istringstream lines(scene_text(designed_50()));
    for (std::string line; std::getline(lines, line);)
        CHECK((line.find(" = ") == std::string::npos || line.find('#') != std::string::npos));
}

TEST_CASE("every family's tooth is read back to the last digit", "[design]")
{
    for (char const* const family : {"straight", "cycloid", "s-tooth", "arc-chain", "bezier", "b-spline"}) {
        DesignWishes wishes = type_50();
        wishes.family = family;
        wishes.module = 0.23;
        wishes.diameter.reset();
        Design const made = design_drive(wishes);
        Scene const again = parse_scene(scene_text(made), "designed");
        INFO(family);
        CHECK(differences(made, again).empty());
        for (auto const& [key, parameter] : made.scene.flexspline.profile.given)
            CHECK(again.flexspline.profile.given.at(key).value == parameter.value);
    }
}

TEST_CASE("text and JSON of a design say the same", "[design]")
{
    Design const& made = designed_50();
    std::string const text = summary_text(made);
    auto const json = nlohmann::json::parse(summary_json(made));
    REQUIRE(json["rows"].size() == made.rows.size());
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        auto const& row = json["rows"][i];
        CHECK_THAT(text, ContainsSubstring(row["name"].get<std::string>()) &&
                             ContainsSubstring(row["rule"].get<std::string>()));
        if (row["value"].is_number())
            CHECK(row["value"].get<double>() == made.rows[i].number());
    }
    CHECK(json["mesh"].size() == made.mesh.size());
}

TEST_CASE("a design without a torque says that the assembled cup was not looked at", "[design]")
{
    DesignWishes wishes = type_50();
    wishes.torque.reset();
    CHECK(says_without_torque(design_drive(wishes)));
}

TEST_CASE("a module that no standard has is taken where it is asked for", "[design]")
{
    DesignWishes wishes = type_50();
    wishes.diameter = 46.9;  // the quotient of 0.2345 mm is nearer to 0.25 mm, the difference to 0.22 mm
    Design const nearest = design_drive(wishes);
    CHECK(nearest.scene.drive.module == 0.22);
    REQUIRE_FALSE(nearest.remarks.empty());
    CHECK_THAT(nearest.remarks.front(), ContainsSubstring("--module 0.2345"));
    wishes.module = 0.2345;
    CHECK(design_drive(wishes).scene.drive.module == 0.2345);
}

TEST_CASE("wishes that no design meets are all named with the nearest that works", "[design]")
{
    DesignWishes wishes = type_50();
    wishes.ratio = 100.4;
    wishes.length_ratio = 0.1;
    wishes.family = "involut";
    Faults const faults = check_design(wishes);
    REQUIRE(faults.size() == 3);
    CHECK_THAT(faults[0].remedy, ContainsSubstring("100"));
    CHECK_THAT(faults[1].remedy, ContainsSubstring("0.2"));
    CHECK_THAT(faults[2].remedy, ContainsSubstring("involute"));
    wishes = type_50();
    wishes.name = "a\nb";
    Faults const of_name = check_design(wishes);
    REQUIRE(of_name.size() == 1);
    CHECK(of_name.front().path == "name");
    CHECK_THAT(of_name.front().reason, ContainsSubstring("control characters"));
    wishes = type_50();
    wishes.clearance = 0.2;  // nearly a module: no land is left
    try {
        (void)design_drive(wishes);
        FAIL("such a side clearance leaves no land");
    } catch (InputError const& error) {
        REQUIRE(error.faults().size() == 1);
        CHECK(error.faults().front().path == "--clearance");
    }
}

TEST_CASE("a module that is named as the nearest is within the rules", "[design]")
{
    for (auto const& [ratio, module] : {std::pair(31, 0.08), {31, 0.16129}, {45, 0.111111}, {241, 0.829876}}) {
        DesignWishes wishes;
        wishes.ratio = ratio;
        wishes.module = module;
        Faults const faults = check_design(wishes);
        CAPTURE(ratio, module);
        REQUIRE(faults.size() == 1);
        wishes.module = std::stod(faults.front().remedy.substr(faults.front().remedy.rfind(' ')));
        CHECK(check_design(wishes).empty());
    }
}

TEST_CASE("the figures of another steel have ranges of their own", "[design]")
{
    DesignWishes wishes = type_50();
    wishes.fatigue = 0.5;           // a unit of GPa
    wishes.youngs_modulus = 206.0;  // likewise
    Faults const faults = check_design(wishes);
    REQUIRE(faults.size() == 2);
    CHECK(faults[0].path == "--fatigue");
    CHECK(faults[1].path == "--youngs-modulus");
}

TEST_CASE("the nearest side clearance that is named is the same from far and from near", "[design]")
{
    for (double const asked : full_run() ? std::vector{1.0, 0.2, 0.16} : std::vector{1.0, 0.16}) {
        DesignWishes wishes = type_50();
        wishes.clearance = asked;
        CAPTURE(asked);
        try {
            (void)design_drive(wishes);
            FAIL("such a side clearance leaves no land");
        } catch (InputError const& error) {
            auto const fault = std::ranges::find(error.faults(), "--clearance", &Fault::path);
            REQUIRE(fault != error.faults().end());
            std::string const& remedy = fault->remedy;
            wishes.clearance = std::stod(remedy.substr(remedy.rfind(' ')));
        }
        CHECK_NOTHROW(design_drive(wishes));
        wishes.clearance *= 1.02;
        CHECK_THROWS_AS(design_drive(wishes), InputError);
    }
}

TEST_CASE("the nearest torque that is named works, and is named for the next larger one too", "[design]")
{
    if (!full_run())  // a minute: unit/design/torque_search does it with walls whose stress is a formula,
        return;       // law/design_wishes with one drive whose named torque works
    DesignWishes wishes = type_50();
    auto const nearest_to = [&](double torque) {
        wishes.torque = torque * newton_metre;
        try {
            (void)design_drive(wishes);
        } catch (InputError const& error) {
            REQUIRE(error.faults().front().path == "--torque");
            std::string const remedy = error.faults().front().remedy;
            REQUIRE(remedy.starts_with("the nearest that works is "));
            return std::stod(remedy.substr(remedy.rfind(' ')));
        }
        return torque;
    };
    double const nearest = nearest_to(200);
    REQUIRE((nearest >= 10 && nearest < 99));  // its second digit is 1 N m
    CHECK(nearest_to(nearest) == nearest);
    CHECK(nearest_to(nearest + 1) == nearest);
}

}  // namespace hdconj::test::design_cases
