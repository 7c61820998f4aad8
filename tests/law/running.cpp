// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of a drive while it turns.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/design.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/running.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::running_cases {

namespace {

using Keys = std::vector<std::string>;
using std::numbers::pi;

constexpr double pitch_radius = 25;  // of the flexspline [mm]
constexpr int z_f = 200, z_c = 202;

/// First contacts in the shape that the scene prescribes, in one plane.
RunStudy unloaded(Keys const& more, int positions = 4)
{
    Keys keys{"contact.flank_points=60"};
    keys.insert(keys.end(), more.begin(), more.end());
    RunOptions options;
    options.torque = 0;
    options.positions = positions;
    return study_run(builtin_scene(keys), options);
}

/// A balance in a fraction of a second: one slice.
RunStudy loaded(Keys const& more, int positions = 4)
{
    Keys keys{"slices.count=1", "contact.flank_points=80", "circular_spline.backlash_offset=0.09", "bearing.circles=5",
              "load.harmonics=50"};
    keys.insert(keys.end(), more.begin(), more.end());
    RunOptions options;
    options.positions = positions;
    options.errors = false;
    return study_run(builtin_scene(keys), options);
}

RunSequence const& sequence(RunStudy const& study, RunSpan span, bool under_torque)
{
    auto const found = std::ranges::find_if(study.sequences, [&](RunSequence const& each) {
        return each.span == span && (each.torque != 0) == under_torque;
    });
    REQUIRE(found != study.sequences.end());
    return *found;
}

/// Places of all teeth of a ring: amplitude cos(2 pi order number/teeth).
std::string wave(char const* ring, int teeth, int order, double amplitude)
{
    std::string text;
    for (int i = 0; i < teeth; ++i)
        text += (i == 0 ? "[" : ", ") + std::to_string(amplitude * std::cos(2 * pi * order * i / teeth));
    return std::string("errors.") + ring + ".pitch=" + text + "]";
}

/// Amplitude at @p per_input periods in a turn of the wave generator.
double amplitude_at(RunSequence const& of, double per_input)
{
    for (RunOrder const& each : of.orders)
        if (std::abs(each.per_input - per_input) < 1e-9)
            return each.amplitude;
    return 0;
}

RunOrder largest(RunSequence const& of)
{
    return *std::ranges::max_element(of.orders, {}, &RunOrder::amplitude);
}

}  // namespace

TEST_CASE("a conjugate pair without errors in one plane has no transmission error", "[running]")
{
    for (char const* output : {"flexspline", "circular-spline"}) {
        CAPTURE(output);
        RunStudy const study = unloaded({std::string("running.output=") + output}, 16);
        REQUIRE(study.sequences.size() == 1);
        CHECK(study.ratio == (std::string(output) == "flexspline" ? 100 : 101));
        RunSequence const& found = study.sequences.front();
        CHECK(found.positions.size() == 16);
        CHECK(found.peak_to_peak < 2 * 1e-6 / pitch_radius);  // the tolerance of the flanks
        CHECK(found.peak_to_peak_error > 0);
    }
}

TEST_CASE("a coned drive runs with the teeth that contact finds to clear, and says so", "[running]")
{
    std::string const file = HDCONJ_SOURCE_DIR "/data/scenes/type-50-coned.toml";
    Keys const keys{"slices.surface=tilted", "slices.count=5", "contact.flank_points=60"};
    auto const run = [&](Keys more) {
        more.insert(more.begin(), keys.begin(), keys.end());
        RunOptions options;
        options.torque = 0;
        options.positions = 8;
        return study_run(read_scene(file, more), options);
    };
    RunStudy const given = run({}), automatic = run({"circular_spline.backlash_offset=auto"});
    ContactCase const contact = study_contact(read_scene(file, keys)).cases.front();
    CHECK(given.side_clearance_increased);
    CHECK(given.backlash_offset == Approx(contact.backlash_offset));
    CHECK(given.tip_radius_increase == Approx(contact.least_tip_radius - 25.025));
    CHECK_FALSE(automatic.side_clearance_increased);
    CHECK(automatic.tip_radius_increase == 0);
    // teeth that enter each other would jump from one contact to the next by 56 arcsec
    double const arcsec = pi / 180 / 3600, far = given.sequences.front().peak_to_peak;
    CHECK(far < 2 * arcsec);
    CHECK(far == Approx(automatic.sequences.front().peak_to_peak).margin(1e-3 * arcsec));
    RunStudy const wide = run({"circular_spline.backlash_offset=0.08", "circular_spline.inner_radius=25.15"});
    CHECK_FALSE(wide.side_clearance_increased);
    CHECK(wide.tip_radius_increase == 0);
    CHECK(wide.backlash_offset == 0.08);
}

TEST_CASE("the first contact is the least of gap and displacement over all pairs", "[running]")
{
    // gaps of the right flanks without errors, from the verb contact; corners of tips touch between few points
    Scene const plain = builtin_scene({"contact.flank_points=2000"});
    ContactOptions options;
    options.errors = false;
    ContactStudy const contact = study_contact(plain, options);
    GapMap const& map = contact.map;
    std::vector<double> gap;
    for (std::size_t s = 0; s < map.angle.size(); ++s) {
        double const* const first = map.gap.data() + map.index(s, GapMap::right, 0, 0);
        gap.push_back(*std::min_element(first, first + map.station.size()));
    }
    constexpr double amplitude = 2e-3, radius = 0.25 * z_c / 2;
    // of a pair with a gap: its flank stands between straight outward and 32 degrees from that
    constexpr double least_lever = 0.85 * pitch_radius, largest_lever = 1.02 * pitch_radius;
    for (int const order : {2, 4, 7}) {
        CAPTURE(order);
        RunStudy const study = unloaded({wave("circular_spline", z_c, order, amplitude)});
        for (RunPosition const& each : sequence(study, RunSpan::input_turn, false).positions) {
            double early = 1, late = 1;
            for (std::size_t s = 0; s < gap.size(); ++s) {
                double const number = (map.angle[s] + each.angle) * z_c / (2 * pi);
                double const place = amplitude * std::cos(2 * pi * order * number / z_c) / radius;
                early = std::min(early, gap[s] / largest_lever + place);
                late = std::min(late, gap[s] / least_lever + place);
            }
            double const turn = -each.error * z_f / z_c, rounding = 0.01 * amplitude / radius;
            CHECK(turn > early - rounding);
            CHECK(turn < late + rounding);
        }
    }
}

TEST_CASE("pitch errors of the held ring come back at their order where both zones of mesh see the same", "[running]")
{
    RunSequence const found = sequence(unloaded({wave("circular_spline", z_c, 2, 2e-3)}), RunSpan::input_turn, false);
    CHECK(largest(found).per_input == Approx(2));
    CHECK(amplitude_at(found, 3) < 1e-6 * largest(found).amplitude);
}

TEST_CASE("pitch errors of the cup that turns come back at their order against the wave generator", "[running]")
{
    RunStudy const study = unloaded({wave("flexspline", z_f, 2, 2e-3)});
    RunSequence const& found = sequence(study, RunSpan::input_turn, false);
    CHECK(largest(found).per_input == Approx(2.0 * z_c / z_f));
    // where the circular spline turns, the cup is held
    RunStudy const held = unloaded({wave("flexspline", z_f, 2, 2e-3), "running.output=circular-spline"});
    CHECK(largest(sequence(held, RunSpan::input_turn, false)).per_input == Approx(2.0));
}

TEST_CASE("half a turn of the wave generator leaves no odd order of errors of the held ring", "[running]")
{
    // two lobes: after half a turn the same wave generator stands before the same ring
    for (std::string const& error :
         {wave("circular_spline", z_c, 3, 2e-3), std::string("errors.circular_spline.eccentricity=0.005")}) {
        RunStudy const study = unloaded({error, "circular_spline.backlash_offset=0.02"});
        RunSequence const& found = sequence(study, RunSpan::input_turn, false);
        double odd = 0;
        for (RunOrder const& each : found.orders)
            if (std::lround(each.per_input) % 2 == 1)
                odd = std::max(odd, each.amplitude);
        CHECK(odd < 1e-6 * largest(found).amplitude);
        CHECK(std::lround(largest(found).per_input) % 2 == 0);
    }
}

TEST_CASE("over a tooth pitch the slope of an eccentricity is no order of the mesh", "[running]")
{
    auto const pitch_orders = [](Keys keys) {
        keys.push_back("circular_spline.backlash_offset=0.02");
        return sequence(unloaded(keys, full_run() ? 16 : 8), RunSpan::tooth_pitch, false).orders;
    };
    std::vector<RunOrder> const alone = pitch_orders({});
    for (int const phase : {0, 60, 120}) {
        INFO(phase);
        std::vector<RunOrder> const found =
            pitch_orders({"errors.circular_spline.eccentricity=0.005",
                          "errors.circular_spline.eccentricity_phase_deg=" + std::to_string(phase)});
        REQUIRE(found.size() == alone.size());
        for (std::size_t k = 1; k < found.size(); ++k)
            CHECK(found[k].amplitude < alone[k].amplitude + 0.04 * arcsec);
    }
}

TEST_CASE("an eccentricity shows once where both zones are at odds, with less than itself", "[running]")
{
    constexpr double eccentricity = 0.005;
    RunStudy const study = unloaded({"errors.circular_spline.eccentricity=0.005"});
    RunSequence const& found = sequence(study, RunSpan::input_turn, false);
    CHECK(largest(found).per_input == Approx(2));
    // the larger of A cos and -A cos lies between 0 and A; the normal of a flank has a part of it along the shift
    CHECK(found.peak_to_peak < 1.2 * eccentricity / pitch_radius);
    CHECK(found.peak_to_peak > 0.1 * eccentricity / pitch_radius);
}

TEST_CASE("errors of both rings are followed until they meet as before", "[running]")
{
    RunStudy const study =
        unloaded({"drive.flexspline_teeth=60", "drive.circular_spline_teeth=62", "flexspline.wall=0.2",
                  "circular_spline.inner_radius=7.525", "errors.circular_spline.eccentricity=0.002",
                  "errors.flexspline.eccentricity=0.002"});
    RunSequence const& whole = sequence(study, RunSpan::output_turn, false);
    CHECK(whole.positions.size() == 30 * 16);
    CHECK(whole.positions.back().angle < 30 * 2 * pi);
    CHECK(whole.positions.back().angle > 29.9 * 2 * pi);
    CHECK(whole.peak_to_peak >= 0.9 * sequence(study, RunSpan::input_turn, false).peak_to_peak);
}

TEST_CASE("tips that pass each other do not move the first contact", "[running]")
{
    // at half a pitch two tips interfere by 0.3 um along the radius
    RunOptions options;
    options.torque = 10 * newton_metre;
    options.positions = 4;
    options.errors = false;
    int asked = 0;
    options.stop = [&asked] { return ++asked > 4; };
    RunStudy const study = study_run(read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50-elastic.toml",
                                                {"slices.count=3", "errors.flexspline.pitch_deviation=0.002"}),
                                     options);
    RunSequence const& contacts = sequence(study, RunSpan::tooth_pitch, false);
    REQUIRE(contacts.positions.size() == 4);
    CHECK(contacts.peak_to_peak < arcsec);
    REQUIRE_FALSE(study.missing.empty());
    CHECK(study.solution.notes.back() == study.missing.back());
}

TEST_CASE("a running drive is in the balance of load, and its wave generator carries T/i", "[running]")
{
    Keys const keys{"slices.count=1", "contact.flank_points=80", "circular_spline.backlash_offset=0.09",
                    "bearing.circles=5", "load.harmonics=50"};
    RunStudy const study = loaded({}, 8);
    CHECK(study.missing.empty());
    RunSequence const& found = sequence(study, RunSpan::tooth_pitch, true);
    REQUIRE(found.positions.size() == 8);
    LoadOptions options;
    options.curve = false;
    options.errors = false;
    LoadStudy const load = study_load(builtin_scene(keys), options);
    LoadedState const& state = load.cases.front().curve.front();
    CHECK(study.spline_torque == Approx(state.torque));
    CHECK(found.positions[4].angle == Approx(0).margin(1e-12));
    CHECK(found.positions[4].wave_generator_torque == Approx(state.wave_generator_torque).epsilon(1e-4));
    double const unloaded_error = sequence(study, RunSpan::tooth_pitch, false).positions[4].error;
    CHECK(-(found.positions[4].error - unloaded_error) * z_f / z_c ==
          Approx(state.twist - load.cases.front().backlash / 2).epsilon(1e-4));
    double const mean = study.torque / study.ratio;
    CHECK(found.mean_torque == Approx(mean).epsilon(5e-3));
    double by_teeth = 0;
    for (RunPosition const& each : found.positions) {
        CHECK(each.torque_by_teeth == Approx(each.wave_generator_torque).epsilon(0.02));
        by_teeth += each.torque_by_teeth / 8;
    }
    CHECK(by_teeth == Approx(mean).epsilon(5e-3));
}

TEST_CASE("the plan of run names the stages that run enters, and no balance without torque", "[running]")
{
    RunOptions options;
    options.torque = 0;
    options.positions = 4;
    Scene const scene = builtin_scene({"contact.flank_points=60"});
    std::vector<Stage> entered;
    RunStudy const study = study_run(scene, options, [&](Stage stage) { entered.push_back(stage); });
    CHECK(std::ranges::count(entered, Stage::run) == 1);
    for (Stage const balance : {Stage::load, Stage::cup, Stage::influence, Stage::assembly}) {
        CHECK(std::ranges::count(entered, balance) == 0);
        CHECK_FALSE(study.solution.plan.has(balance));
    }
    CHECK(study.solution.plan.has(Stage::run));
    CHECK(study.solution.timing.back().stage == "run");
}

TEST_CASE("friction takes what flanks and bearing rub, and nothing without a table of it", "[running]")
{
    CHECK_FALSE(loaded({}).losses);
    RunStudy const none = loaded({"friction.flanks=0", "running.torques=[20]"});
    REQUIRE(none.losses);
    for (EfficiencyRow const& each : none.losses->efficiency)
        CHECK((each.torque == 0 ? std::isnan(each.efficiency) : each.efficiency == 1));
    CHECK(none.losses->starting_torque == 0);
    RunStudy const study =
        loaded({"friction.flanks=0.1", "friction.seal=0.01", "running.speeds=[1000]", "running.torques=[5, 20]"});
    REQUIRE(study.losses);
    auto const& rows = study.losses->efficiency;
    REQUIRE(rows.size() == 3);
    CHECK(rows.front().torque == 0);
    CHECK(rows.front().efficiency == 0);
    CHECK(rows.front().input_torque == Approx(0.01 * newton_metre));
    for (std::size_t i = 1; i < rows.size(); ++i) {
        CHECK(rows[i].efficiency > rows[i - 1].efficiency);
        CHECK(rows[i].flanks > rows[i - 1].flanks);
        CHECK(rows[i].input_torque == Approx(rows[i].torque / study.ratio + rows[i].flanks + rows[i].seal));
    }
    RunStudy const half = loaded({"friction.flanks=0.05", "running.speeds=[1000]", "running.torques=[5, 20]"});
    CHECK(half.losses->efficiency.back().flanks == Approx(rows.back().flanks / 2));
    REQUIRE(study.losses->back_driving);
    CHECK(*study.losses->back_driving > 0.01 * newton_metre * study.ratio);
}

TEST_CASE("the back-driving torque does not depend on the torques of the efficiency", "[running]")
{
    std::vector<double> found;
    for (char const* const torques : {"[27.7]", "[100]", "[3, 6, 7.5, 9, 10, 12]"}) {
        RunStudy const study =
            loaded({"friction.flanks=0.1", "friction.seal=0.01", std::string("running.torques=") + torques});
        REQUIRE(study.losses);
        REQUIRE(study.losses->back_driving);
        found.push_back(*study.losses->back_driving);
    }
    CHECK(found[1] == Approx(found[0]).epsilon(2e-3));
    CHECK(found[2] == Approx(found[0]).epsilon(2e-3));
}

TEST_CASE("a torque under which the teeth slip leaves what is known without it", "[running]")
{
    RunStudy const study = loaded({"load.torque=4000", "friction.flanks=0.1"});
    REQUIRE(study.sequences.size() == 1);
    CHECK(study.sequences.front().torque == 0);
    CHECK_FALSE(study.losses);
    REQUIRE(study.missing.size() == 5);  // three of four positions, that the last was not tried, and the losses
    CHECK_THAT(study.missing.front(), ContainsSubstring("they slip over each other"));
    CHECK_THAT(study.missing[3], ContainsSubstring("the others were not tried"));
    CHECK_THAT(study.missing.back(), ContainsSubstring("no losses: no position has a result"));
}

TEST_CASE("torque and friction of a designed drive are within their errors of a finer grid", "[running]")
{
    DesignWishes wishes;
    wishes.ratio = 100;
    wishes.diameter = 50;
    wishes.torque = 28 * newton_metre;
    std::string const text = scene_text(design_drive(wishes));
    auto const run_with = [&](char const* slices, bool errors) {
        RunOptions options;
        options.torque = 28 * newton_metre;
        options.positions = 6;
        options.errors = errors;
        return study_run(parse_scene(text, "designed", {},
                                     {std::string("slices.count=") + slices, "friction.flanks=0.08",
                                      "friction.bearing_load=0.0005", "running.torques=[27.7]"}),
                         options);
    };
    // nine planes against 17, or 33
    RunStudy const told = run_with("9", true), finer = run_with(full_run() ? "33" : "17", false);
    RunSequence const &here = sequence(told, RunSpan::tooth_pitch, true),
                      &there = sequence(finer, RunSpan::tooth_pitch, true);
    CHECK(std::abs(here.torque_ripple - there.torque_ripple) <= here.torque_ripple_error);
    CHECK(std::abs(here.mean_torque - there.mean_torque) <= here.mean_torque_error);
    CHECK(std::abs(here.peak_to_peak - there.peak_to_peak) <= here.peak_to_peak_error);
    REQUIRE(told.losses);
    RunLosses const &losses = *told.losses, &others = *finer.losses;
    CHECK(losses.estimated);
    CHECK_FALSE(others.estimated);
    CHECK(std::abs(losses.ball_load - others.ball_load) <= losses.ball_load_error);
    CHECK(std::abs(losses.largest_sliding - others.largest_sliding) <= losses.largest_sliding_error);
    CHECK(std::abs(*losses.back_driving - *others.back_driving) <= losses.back_driving_error);
    CHECK(std::abs(losses.efficiency.back().efficiency - others.efficiency.back().efficiency) <=
          losses.efficiency.back().efficiency_error);
}

TEST_CASE("both outputs have the same positions, in their own angles", "[running]")
{
    RunStudy const cup = loaded({}), spline = loaded({"running.output=circular-spline"});
    CHECK(spline.spline_torque == Approx(cup.spline_torque));
    auto const& a = sequence(cup, RunSpan::tooth_pitch, true);
    auto const& b = sequence(spline, RunSpan::tooth_pitch, true);
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
        CHECK(a.positions[i].error * z_f / z_c == Approx(b.positions[i].error).epsilon(1e-5));
        CHECK(a.positions[i].wave_generator_torque == Approx(b.positions[i].wave_generator_torque).epsilon(1e-4));
    }
}

TEST_CASE("what cannot run is told at once, with what to write", "[running]")
{
    RunOptions options;
    options.torque = -1;
    CHECK(check_run(builtin_scene(), options).front().path == "--torque");
    options.torque = 0;
    Faults const faults = check_run(builtin_scene({"friction.flanks=0.1"}), options);
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().path == "friction");
    CHECK_THAT(faults.front().reason, ContainsSubstring("--torque is 0"));
    options.torque.reset();
    CHECK(check_run(builtin_scene({"friction.flanks=0.1"}), options).empty());
}

TEST_CASE("an error of the wave generator that moves nothing without a torque is told", "[law][running]")
{
    auto const notes_of = [](Keys const& more) {
        Keys keys{"slices.count=1", "contact.flank_points=80", "circular_spline.backlash_offset=0.03",
                  "errors.wave_generator.eccentricity=0.01"};
        keys.insert(keys.end(), more.begin(), more.end());
        RunOptions options;
        options.torque = 0;
        options.positions = 4;
        return study_run(builtin_scene(keys), options).solution.notes;
    };
    auto const tells = [](std::string const& note) { return note.starts_with("errors.wave_generator has no effect"); };
    CHECK(std::ranges::count_if(notes_of({}), tells) == 1);
    CHECK(std::ranges::count_if(notes_of({"!errors.wave_generator", "errors.flexspline.eccentricity=0.01"}), tells) ==
          0);
}

}  // namespace hdconj::test::running_cases
