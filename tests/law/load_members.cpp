// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of what yields beside teeth and cup: members in series, and balls in their grooves.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "load/study/twist_members.hpp"
#include "support/catch.hpp"

namespace hdconj::test::load_member_cases {

namespace {

using Keys = std::vector<std::string>;

/// Few enough slices and points that a torque takes a fraction of a second.
Scene quick(Keys const& more = {})
{
    Keys keys{"slices.count=3", "contact.flank_points=80", "circular_spline.backlash_offset=0.09", "bearing.circles=5",
              "load.torque=20"};
    keys.insert(keys.end(), more.begin(), more.end());
    return builtin_scene(keys);
}

LoadStudy at_rated(Keys const& more)
{
    LoadOptions options;
    options.curve = options.errors = false;
    return study_load(quick(more), options);
}

LoadedState const& only(LoadStudy const& study)
{
    return study.cases.front().curve.front();
}

double sum_of_twists(LoadCase const& each)
{
    double sum = 0;
    for (TwistMember const& member : each.members)
        sum += member.twist;
    return sum;
}

}  // namespace

TEST_CASE("forces of single teeth and balls and twists of members are within their errors", "[load][errors]")
{
    LoadOptions options;
    options.curve = false;
    auto const on = [&](char const* slices, char const* points, bool errors) {
        options.errors = errors;
        Keys keys{"compliance.hub=300000", "bearing.balls=23"};
        keys.insert(keys.end(), {std::string("slices.count=") + slices, "contact.flank_points=" + std::string(points)});
        return study_load(quick(keys), options).cases.front();
    };
    LoadCase const each = on("5", "80", true), finer = on("17", "320", false);
    REQUIRE(each.estimated);
    REQUIRE(each.map.tooth_force_error.size() == finer.map.tooth_force.size());
    for (std::size_t s = 0; s < each.map.tooth_force.size(); ++s) {
        CAPTURE(s, each.map.tooth_force[s]);
        CHECK(std::abs(each.map.tooth_force[s] - finer.map.tooth_force[s]) <= each.map.tooth_force_error[s]);
    }
    BearingMap const &balls = each.bearing, &of_finer = finer.bearing;
    REQUIRE(balls.ball_force_error.size() == balls.ball_force.size());
    for (std::size_t b = 0; balls.ball_force.size() == of_finer.ball_force.size() && b < balls.ball_force.size(); ++b)
        CHECK(std::abs(balls.ball_force[b] - of_finer.ball_force[b]) <= balls.ball_force_error[b]);
    REQUIRE(each.members.size() == finer.members.size());
    for (std::size_t m = 0; m < each.members.size(); ++m) {
        CAPTURE(each.members[m].name);
        CHECK(std::abs(each.members[m].twist - finer.members[m].twist) <=
              each.members[m].twist_error + 1e-15 * std::abs(each.members[m].twist));
    }
    options.errors = false;
    LoadCase const bare = study_load(quick(), options).cases.front();
    CHECK(bare.map.tooth_force_error.empty());
    CHECK(bare.bearing.ball_force_error.empty());
    CHECK(bare.members[1].twist_error == 0);
}

TEST_CASE("members in series add their compliance to every figure of the curve", "[load][compliance]")
{
    LoadOptions options;
    options.points = 2;
    std::vector<std::string> stages;
    auto const told = [&](Stage stage) { stages.push_back(to_string(stage)); };
    LoadCase const stiff = study_load(quick(), options, told).cases.front();
    CHECK(std::count(stages.begin(), stages.end(), "compliance") == 0);
    LoadStudy const study = study_load(quick({"compliance.flange=200000", "compliance.hub=300000",
                                              "compliance.shaft=60000", "compliance.outer_radius=35"}),
                                       options, told);
    CHECK(std::count(stages.begin(), stages.end(), "compliance") == 1);
    LoadCase const& soft = study.cases.front();
    LoadOptions one = options;
    one.curve = one.errors = false;
    PairGeometry const g = study_load(quick({"circular_spline.backlash_offset=0"}), one).solution.geometry,
                       stated = study.solution.geometry;
    double const root = g.circular_spline_inner_radius + g.space_depth + 0.09;  // with the side clearance
    CHECK(std::abs(stated.circular_spline_inner_radius + stated.space_depth - root) <=
          study.solution.scene.solver.tolerance);
    double const body = load::disc_in_torsion(root, 35, 7, {210e3, 0.31});
    double const c = (1 / 200e3 + 1 / 300e3 + 1 / 60e3) / newton_metre + 1 / body;
    constexpr double same = 1e-12;
    auto const softened = [&](double stiffness) { return 1 / (1 / stiffness + c); };
    REQUIRE(soft.curve.size() == stiff.curve.size());
    for (std::size_t i = 0; i < soft.curve.size(); ++i) {
        LoadedState const &a = stiff.curve[i], &b = soft.curve[i];
        CAPTURE(a.torque);
        CHECK(b.twist == Approx(a.twist + c * a.torque).epsilon(same).margin(1e-15));
        CHECK(b.largest_pressure == a.largest_pressure);
        CHECK(b.wave_generator_torque == a.wave_generator_torque);
        if (a.torque == 0)
            continue;
        CHECK(b.stiffness == Approx(softened(a.stiffness)).epsilon(same));
        REQUIRE(soft.curve_error[i]);
        CHECK(soft.curve_error[i]->twist == stiff.curve_error[i]->twist);
        CHECK(soft.curve_error[i]->stiffness ==
              Approx(stiff.curve_error[i]->stiffness * std::pow(b.stiffness / a.stiffness, 2)).epsilon(same));
    }
    REQUIRE((soft.catalogue && stiff.catalogue));
    for (Stiffness CatalogueFigures::*const k : {&CatalogueFigures::k1, &CatalogueFigures::k2, &CatalogueFigures::k3})
        CHECK(((*soft.catalogue).*k).value == Approx(softened(((*stiff.catalogue).*k).value)).epsilon(same));
    CHECK(soft.catalogue->lost_motion ==
          Approx(stiff.catalogue->lost_motion + 2 * 0.04 * 20 * newton_metre * c).epsilon(same));
    CHECK(soft.stages.second < stiff.stages.second);
    CHECK(soft.backlash == stiff.backlash);
    // the members are the whole, with and without the table
    CHECK(stiff.members.size() == 3);
    REQUIRE(soft.members.size() == 7);
    CHECK(sum_of_twists(stiff) == Approx(stiff.curve[stiff.rated].twist).epsilon(same));
    CHECK(sum_of_twists(soft) == Approx(soft.curve[soft.rated].twist).epsilon(same));
    CHECK(soft.members[1].twist == Approx(stiff.members[1].twist).epsilon(same));
    CHECK(soft.members[3].stiffness == Approx(body).epsilon(same));
    CHECK(soft.members[4].twist == Approx(20 / 200e3).epsilon(same));
    // 28 N m over the twist of the cup alone, by the solid of its own: tests/unit/elastic/elastic_solid.cpp
    CHECK(soft.members[2].stiffness * per_newton_metre_per_deg == Approx(1678).epsilon(0.02));
}

TEST_CASE("a disc in torsion turns as its rings do one after the other", "[load][compliance]")
{
    constexpr double inner = 25.5, outer = 35, width = 7, modulus = 210e3, ratio = 0.31, torque = 28e3;
    constexpr int rings = 2000;
    double turn = 0;
    for (int i = 0; i < rings; ++i) {
        double const thick = (outer - inner) / rings, r = inner + (i + 0.5) * thick;
        double const shear = torque / (2 * std::numbers::pi * r * r * width) / (modulus / (2 * (1 + ratio)));
        turn += shear * thick / r;
    }
    CHECK(load::disc_in_torsion(inner, outer, width, {modulus, ratio}) == Approx(torque / turn).epsilon(1e-6));
}

TEST_CASE("balls by Hertz soften the drive, and hard ones do not", "[load][balls]")
{
    Keys const balls{"bearing.balls=22"};
    auto const with = [&](std::string const& modulus) {
        Keys keys = balls;
        for (std::string const& key :
             {std::string("bearing.ball_diameter=3"), "bearing.ball_youngs_modulus=" + modulus})
            keys.push_back(key);
        return at_rated(keys);
    };
    LoadStudy const rigid = at_rated(balls), steel = with("206000"), soft = with("50000");
    CHECK(rigid.ball_constant == 0);
    CHECK(soft.ball_constant < steel.ball_constant);
    CHECK(only(steel).twist > only(rigid).twist);
    CHECK(only(soft).twist > only(steel).twist);
    CHECK(only(steel).wave_generator_force < only(rigid).wave_generator_force);
    CHECK(only(soft).wave_generator_force < only(steel).wave_generator_force);
    CHECK(steel.cup.ball_force < rigid.cup.ball_force);
    for (LoadStudy const* study : {&rigid, &steel, &soft}) {
        CHECK(only(*study).gap_mismatch < 1e-6);
        CHECK(only(*study).complementarity < 1e-10);
    }
    // its approach is some micrometres: force and way of the balls are those of the law, for balls that press alike
    double const way = std::pow(steel.cup.ball_force / steel.ball_constant, 2.0 / 3);
    CHECK(way > 0.5e-3);
    CHECK(way < 20e-3);
}

TEST_CASE("a bearing's clearance unloads balls, and none is that of no key", "[load][balls]")
{
    Keys const balls{"bearing.balls=23", "bearing.ball_diameter=3", "circular_spline.inner_radius=25.06"};
    auto const with = [&](std::string const& clearance) {
        Keys keys = balls;
        keys.push_back("bearing.clearance=" + clearance);
        return at_rated(keys);
    };
    LoadStudy const none = at_rated(balls), zero = with("0"), least = with("1e-9"), loose = with("0.03");
    CHECK(only(zero).twist == only(none).twist);
    CHECK(only(zero).ball_force == only(none).ball_force);
    CHECK(only(least).twist == Approx(only(none).twist).epsilon(1e-5));
    CHECK(only(least).ball_force == Approx(only(none).ball_force).epsilon(1e-5));
    CHECK(only(loose).balls < only(none).balls);
    CHECK(only(loose).wave_generator_force < only(none).wave_generator_force);
    BearingMap const& map = loose.cases.front().bearing;
    CHECK(*std::min_element(map.ball_force.begin(), map.ball_force.end()) == 0);
    // the outer ring is in balance between balls and cup, whose forces act over a step of the grid
    REQUIRE(loose.sectors == 1);
    Vec2 balance = Vec2::Zero();
    double size = 0;
    auto const add = [&](double force, double angle) {
        balance += force * Vec2(std::cos(angle), std::sin(angle));
        size += std::abs(force);
    };
    for (std::size_t b = 0; b < map.ball_angle.size(); ++b)
        add(map.ball_force[b], map.ball_angle[b]);
    double const step = map.angle[1] - map.angle[0], mean = std::sin(step / 2) / (step / 2);
    for (std::size_t i = 0; i < map.angle.size(); ++i)
        for (std::size_t j = 0; j < map.z.size(); ++j)
            add(-mean * map.force[i * map.z.size() + j], map.angle[i]);
    CHECK(balance.norm() < 1e-4 * size);
}

}  // namespace hdconj::test::load_member_cases
