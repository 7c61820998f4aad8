// SPDX-License-Identifier: GPL-3.0-or-later
// A drive beside the design of its wishes: its steel, and ranges by its own dimensions.
#include <algorithm>
#include <cmath>

#include "design/wall_search.hpp"
#include "design/wishes.hpp"
#include "hdconj/design.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"

namespace hdconj::test::design_beside_cases {
namespace {

/// A drive whose body has other shares than any rule proposes.
Scene drawn_body(std::string text, designs::Draws& draws)
{
    double const wall = draws.between(0.3, 0.6), width = draws.between(6, 9);
    for (auto const& [key, value] :
         {std::pair{"wall", wall}, std::pair{"barrel_wall", draws.between(0.4, 0.8) * wall},
          std::pair{"bottom", draws.between(0.4, 0.8) * wall}, std::pair{"corner_radius", draws.between(3, 6) * wall},
          std::pair{"tooth_width", width}, std::pair{"front_land", draws.between(0.15, 0.35) * width}}) {
        std::size_t const at = text.find("\n" + std::string(key) + " ") + 1, end = text.find('\n', at);
        REQUIRE(at > 0);
        text.replace(at, end - at, std::string(key) + " = " + std::to_string(value));
    }
    return parse_scene(text, "drawn");
}

}  // namespace

TEST_CASE("a drive stands within a rule by its own dimensions, not by those that are proposed", "[design]")
{
    DesignWishes wishes;
    wishes.diameter = 40;
    wishes.length_ratio = 0.6;
    std::string const text = scene_text(design_drive(wishes));
    designs::Draws draws(7);
    int within = 0, outside = 0;
    for (int i = 0; i < 2; ++i) {
        Scene const scene = drawn_body(text, draws);
        Cup const& cup = *scene.flexspline.cup;
        double const wall = scene.flexspline.wall;
        SceneDesign const made = design_beside(solve(scene));
        auto const stands = [&](char const* symbol, double share, double low, double high) {
            auto const row = std::ranges::find(made.design.rows, symbol, &DesignRow::symbol);
            ComparedRow const& here = made.here.at(static_cast<std::size_t>(row - made.design.rows.begin()));
            bool const is_inside = share >= low && share <= high;
            CAPTURE(symbol, share, here.here, range_text(here.range), row->range_text());
            CHECK(here.standing == (is_inside ? RuleStanding::within : RuleStanding::outside));
            ++(is_inside ? within : outside);
            CHECK(std::abs(here.range->high / here.range->low - high / low) < 1e-4);
        };
        stands("delta_1", cup.barrel_wall / wall, 0.5, 0.7);
        stands("delta_2", cup.bottom / wall, 0.5, 0.7);
        stands("R_3", cup.corner_radius / wall, 4, 10);
        stands("L_1", cup.front_land / cup.tooth_width, 0.2, 0.3);
    }
    CHECK(within >= 2);
    CHECK(outside >= 2);
}

TEST_CASE("the wishes of a scene have the steel of its cup, and say so", "[design]")
{
    for (double const fatigue : {670., 550., 450.})
        for (double const youngs_modulus : {206e3, 114e3})
            for (double const poissons_ratio : {0.3, 0.34}) {
                Scene scene = builtin_scene();
                Cup& cup = *scene.flexspline.cup;
                cup.fatigue_strength = fatigue;
                cup.youngs_modulus = youngs_modulus;
                cup.poissons_ratio = poissons_ratio;
                std::vector<DerivedWish> derived;
                DesignWishes const wishes = wishes_of(scene, &derived);
                design::Material const steel = design::material_of(wishes);
                CAPTURE(fatigue, youngs_modulus, poissons_ratio);
                CHECK(steel.fatigue == fatigue);
                CHECK(steel.youngs_modulus == youngs_modulus);
                CHECK(steel.poissons_ratio == poissons_ratio);
                auto const tells = [&](char const* option) {
                    return std::ranges::count(derived, option, &DerivedWish::option) == 1;
                };
                CHECK(tells("--fatigue") == wishes.fatigue.has_value());
                CHECK(tells("--youngs-modulus") == (youngs_modulus != 206e3));
                CHECK(tells("--poissons-ratio") == (poissons_ratio != 0.3));
            }
}

TEST_CASE("a drive for a torque has the mesh that its side clearance alone makes", "[design]")
{
    DesignWishes wishes;
    wishes.ratio = 40;
    wishes.diameter = 46;
    wishes.length_ratio = 1;
    wishes.family = "s-tooth";
    wishes.fatigue = 1500;  // with which the first wall is taken
    wishes.torque = 5 * newton_metre;
    design::MeshedSheet const made = design::WallSearch(wishes, {}).best(false);
    REQUIRE(made.works());
    wishes.clearance = design::scene_of(made.rows()).circular_spline.backlash_offset;
    CHECK(wishes.clearance > 0);
    double const wall = made.sheet["delta"] / made.sheet["d_r"];
    design::MeshChoice const alone = design::search_mesh(design::sheet_of(wishes, wall), wishes, 0);
    REQUIRE(alone.best);
    CHECK(alone.trials[*alone.best].tip_radius == made.mesh.trials[*made.mesh.best].tip_radius);
    CHECK(alone.trials[*alone.best].w0 == made.mesh.trials[*made.mesh.best].w0);
}

TEST_CASE("the command in a scene has every wish that is given", "[design]")
{
    Design made;
    auto const command = [&] {
        std::string const text = scene_text(made);
        std::size_t const from = text.find("hdconj design");
        return text.substr(from, text.find('\n', from) - from);
    };
    CHECK(command() ==
          "hdconj design --ratio 100 --length-ratio 0.25 --family double-circular-arc --land 0.4 "
          "--clearance 0 --safety 1.2");
    made.wishes = {80, 40, 0.25, 0.5, 8300, "involute", "it's", 450.5, 114e3, 0.34, 0.3, 0.01, 1.5, "a"};
    CHECK(command() ==
          "hdconj design --ratio 80 --diameter 40 --module 0.25 --length-ratio 0.5 --torque 8.3 "
          "--family involute --material 'it'\\''s' --fatigue 450.5 --youngs-modulus 114000 "
          "--poissons-ratio 0.34 --land 0.3 --clearance 0.01 --safety 1.5");
}

}  // namespace hdconj::test::design_beside_cases
