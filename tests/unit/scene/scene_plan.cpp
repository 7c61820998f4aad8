// SPDX-License-Identifier: GPL-3.0-or-later
// The plan: only what a scene calls for.
#include "hdconj/plan.hpp"

#include <algorithm>

#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::scene_plan_cases {

namespace {

std::vector<Stage> stages_of(Plan const& plan)
{
    std::vector<Stage> stages;
    for (auto const& planned : plan.stages)
        stages.push_back(planned.stage);
    return stages;
}

std::vector<std::string> absent_in(Plan const& plan)
{
    std::vector<std::string> names;
    for (auto const& effect : plan.absent)
        names.push_back(effect.name);
    return names;
}

}  // namespace

TEST_CASE("the plan of the base case has no effect in it", "[scene]")
{
    auto const plan = make_plan(builtin_scene());
    CHECK(stages_of(plan) == std::vector<Stage>{Stage::profile, Stage::neutral_curve, Stage::motion, Stage::envelope,
                                                Stage::region, Stage::outline, Stage::interference});
    CHECK(absent_in(plan) ==
          std::vector<std::string>{"backlash", "root clearance", "coning", "tilt", "slices", "contact", "load"});
    CHECK_FALSE(plan.has(Stage::backlash));
    CHECK(plan.has(Stage::region));
}

TEST_CASE("clearances come after what they change, with their reason", "[scene]")
{
    auto const plan =
        make_plan(builtin_scene({"circular_spline.backlash_offset=0.02", "circular_spline.root_clearance=0.05"}));
    auto const stages = stages_of(plan);
    auto const region = std::find(stages.begin(), stages.end(), Stage::region);
    REQUIRE(stages.end() - region == 5);
    CHECK(region[1] == Stage::backlash);
    CHECK(region[2] == Stage::outline);
    CHECK(region[3] == Stage::root_clearance);
    auto const& backlash = plan.stages[static_cast<std::size_t>(region - stages.begin()) + 1];
    CHECK(backlash.reason == "circular_spline.backlash_offset = 0.02 mm");
    CHECK(absent_in(plan) == std::vector<std::string>{"coning", "tilt", "slices", "contact", "load"});
}

TEST_CASE("an effect that is there is not absent", "[scene]")
{
    auto const absent = absent_in(make_plan(builtin_scene({"tilt.angle_deg=0"})));
    CHECK(std::find(absent.begin(), absent.end(), "tilt") == absent.end());
}

TEST_CASE("reliefs and errors are effects of a load alone", "[scene]")
{
    std::vector<std::string> const effects{"tip relief", "end relief", "errors", "flow of the flanks"};
    auto const is_absent = [](Plan const& plan, std::string const& name) {
        auto const absent = absent_in(plan);
        return std::find(absent.begin(), absent.end(), name) != absent.end();
    };
    Scene const plain = builtin_scene();
    Scene const made =
        builtin_scene({"tip_relief.amount=0.003", "tip_relief.from_height=0.1", "end_relief.amount=0.002",
                       "end_relief.length=2", "errors.flexspline.pitch_deviation=0.002", "flow.pressure=2700"});
    Plan const load = make_plan(made, Verb::load);
    for (Stage const stage : {Stage::tip_relief, Stage::end_relief, Stage::errors}) {
        CHECK(load.has(stage));
        CHECK_FALSE(make_plan(made, Verb::contact).has(stage));
        CHECK_FALSE(make_plan(plain, Verb::load).has(stage));
    }
    for (std::string const& name : effects) {
        CHECK_FALSE(is_absent(load, name));
        CHECK(is_absent(make_plan(plain, Verb::load), name));
        CHECK(is_absent(make_plan(made, Verb::contact), name));
        CHECK_FALSE(is_absent(make_plan(plain, Verb::contact), name));
        Plan const contact = make_plan(made, Verb::contact);
        CHECK(std::ranges::find(contact.absent, name, &AbsentEffect::name)->remedy == "the verbs load and run");
    }
    CHECK(describe(load).find("flow.pressure = 2700 MPa") != std::string::npos);
    CHECK(describe(load).find("flexspline: pitch_deviation = 0.002 mm") != std::string::npos);
}

TEST_CASE("the plan says every stage and every absent effect in words", "[scene]")
{
    auto const plan = make_plan(builtin_scene({"circular_spline.backlash_offset=0.02"}));
    auto const text = describe(plan);
    auto const json = check_json("scene", {{"a", 1, "\xff", "bad", "write b"}}, &plan);
    CHECK(json.find("\"format\": \"hdconj-check\"") != std::string::npos);
    for (auto const& planned : plan.stages) {
        CHECK_FALSE(planned.reason.empty());
        CHECK(text.find(to_string(planned.stage)) != std::string::npos);
        CHECK(text.find(planned.reason) != std::string::npos);
        CHECK(json.find(to_string(planned.stage)) != std::string::npos);
    }
    for (auto const& effect : plan.absent) {
        CHECK_FALSE(effect.remedy.empty());
        CHECK(text.find(effect.name) != std::string::npos);
        CHECK(json.find(effect.name) != std::string::npos);
    }
}

}  // namespace hdconj::test::scene_plan_cases
