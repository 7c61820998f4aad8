// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of a drive under torque: what must hold whatever the numbers are.
#include "hdconj/load.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::load_cases {

namespace {

using Keys = std::vector<std::string>;

/// Few enough slices and points that a torque takes a fraction of a second; side clearance as large as the thesis'
/// play.
Scene quick(Keys const& more = {})
{
    Keys keys{"slices.count=3", "contact.flank_points=80", "circular_spline.backlash_offset=0.09", "bearing.circles=5"};
    keys.insert(keys.end(), more.begin(), more.end());
    return builtin_scene(keys);
}

/// Without errors, which leave no bit of the figures another one (law/load_pressure), unless they are looked at.
LoadOptions at_torque(double torque, bool errors = false)
{
    LoadOptions options;
    options.torque = torque;
    options.curve = false;
    options.errors = errors;
    return options;
}

LoadedState const& only(LoadStudy const& study)
{
    return study.cases.front().curve.front();
}

}  // namespace

TEST_CASE("torque the other way round loads the other flanks alike", "[load]")
{
    LoadStudy const forth = study_load(quick(), at_torque(20 * newton_metre));
    LoadStudy const back = study_load(quick(), at_torque(-20 * newton_metre));
    LoadedState const& a = only(forth);
    LoadedState const& b = only(back);
    CHECK(a.twist > 0);
    CHECK(b.twist == Approx(-a.twist).epsilon(1e-5));
    CHECK(b.largest_pressure == Approx(a.largest_pressure).epsilon(1e-3));
    CHECK(b.wave_generator_torque == Approx(-a.wave_generator_torque).epsilon(1e-3));
    CHECK(a.teeth == b.teeth);
    // mirror image of the map: the spaces in the other order, the other flanks
    LoadMap const& m = forth.cases.front().map;
    LoadMap const& n = back.cases.front().map;
    double const largest = *std::max_element(m.force.begin(), m.force.end());
    REQUIRE(m.angle.size() == n.angle.size());
    std::size_t const spaces = m.angle.size();
    for (std::size_t s = 0; s < spaces; ++s)
        for (std::size_t k = 0; k < m.z.size(); ++k) {
            // the space at -angle, of the sector that repeats
            double const mirrored = -m.angle[s];
            double const pitch = m.angle[1] - m.angle[0];
            auto const i = static_cast<std::size_t>(std::lround((mirrored - n.angle.front()) / pitch) +
                                                    static_cast<long>(spaces)) %
                           spaces;
            CHECK(n.force[n.index(i, 0, k)] == Approx(m.force[m.index(s, 1, k)]).margin(1e-3 * largest));
        }
}

TEST_CASE("a torque that goes to zero leaves the play, and grows the twist", "[load]")
{
    double last = 0;
    for (double torque : {1e-3, 1.0, 10.0, 28.0}) {
        LoadStudy const study = study_load(quick(), at_torque(torque * newton_metre));
        double const half = study.cases.front().backlash / 2;
        CHECK(half > 0);
        CHECK(only(study).twist > half);
        CHECK(only(study).twist > last);
        if (torque < 1e-2)
            CHECK(only(study).twist == Approx(half).epsilon(1e-2));
        last = only(study).twist;
        CHECK(only(study).gap_mismatch < 1e-6);
        CHECK(only(study).complementarity < 1e-10);
        CHECK(only(study).stiffness > 0);
    }
    LoadStudy const none = study_load(quick(), at_torque(0));
    CHECK(only(none).twist == 0);
    CHECK(only(none).teeth == 0);
    CHECK(only(none).largest_pressure == 0);
}

TEST_CASE("the wave generator's torque does the work of the drive's", "[load]")
{
    // Turning the wave generator by a turns the circular spline by a (z_c - z_f)/z_c: without friction the mean over a
    // pitch is T times that.
    constexpr double torque = 28 * newton_metre;
    double mean = 0;
    constexpr int angles = 4;
    double const pitch_deg = 360.0 / 202 * 202 / 2 / 101;  // after which the same teeth come again
    for (int i = 0; i < angles; ++i) {
        Scene const scene = quick({"contact.wave_generator_angle_deg=" + std::to_string(pitch_deg * i / angles)});
        mean += only(study_load(scene, at_torque(torque))).wave_generator_torque / angles;
    }
    CHECK(mean == Approx(torque / 101).epsilon(0.05));
}

TEST_CASE("a drive under torque has the same bits for any number of threads", "[load]")
{
    LoadStudy const one = study_load(quick({"solver.threads=1"}), at_torque(15 * newton_metre));
    for (int threads : {2, 3}) {
        LoadStudy const more =
            study_load(quick({"solver.threads=" + std::to_string(threads)}), at_torque(15 * newton_metre));
        CHECK(only(one).twist == only(more).twist);
        CHECK(only(one).largest_pressure == only(more).largest_pressure);
        CHECK(one.cases.front().map.force == more.cases.front().map.force);
        CHECK(one.shape.stress == more.shape.stress);
        CHECK(one.cup.coning_major == more.cup.coning_major);
    }
}

TEST_CASE("two lines do not depend on the torques that a curve is computed at", "[load]")
{
    // Both polygons are the same curve, which they follow to a few per cent.
    LoadOptions options;
    options.torque = 20 * newton_metre;
    LoadCase const refined = study_load(quick(), options).cases.front();
    options.points = 25;
    options.errors = false;
    LoadCase const even = study_load(quick(), options).cases.front();
    CHECK(refined.stages.first == Approx(even.stages.first).epsilon(0.05));
    CHECK(refined.stages.second == Approx(even.stages.second).epsilon(0.05));
    CHECK(refined.curve.size() < even.curve.size());
    CHECK(refined.stages.first_error > 0);
}

TEST_CASE("a run that is stopped keeps the torques that it has", "[load]")
{
    Scene const scene = quick();
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.points = 4;
    options.surfaces = {ToothSurface::tilted, ToothSurface::ruled};
    LoadStudy const whole = study_load(scene, options);
    std::vector<LoadedState> const& curve = whole.cases.front().curve;
    int asked = 0;
    options.stop = [&] { return ++asked > 6; };  // once for the surface, then before each torque
    LoadStudy const part = study_load(scene, options);
    REQUIRE(part.cases.size() == 1);
    LoadCase const& kept = part.cases.front();
    REQUIRE(kept.curve.size() > 1);
    REQUIRE(kept.curve.size() < curve.size());
    for (LoadedState const& state : kept.curve) {
        auto const same = std::ranges::find(curve, state.torque, &LoadedState::torque);
        REQUIRE(same != curve.end());
        CHECK(same->twist == state.twist);
    }
    CHECK_FALSE(kept.catalogue);
    CHECK(kept.unsettled.size() + kept.curve.size() == curve.size());
    CHECK(part.missing.size() == kept.unsettled.size() + 1);  // and the other surface
    for (std::string const& missing : part.missing)
        CHECK(missing.find("the run was stopped before") != std::string::npos);
    options.stop = [] { return true; };
    try {
        (void)study_load(scene, options);
        FAIL("a stopped run has a result");
    } catch (NumericalError const& error) {
        CHECK(error.code() == ErrorCode::stopped);
    }
}

TEST_CASE("the stiffness is the slope of the curve where contacts move too", "[load]")
{
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.points = 40;
    options.errors = false;
    std::vector<LoadedState> const curve = study_load(quick(), options).cases.front().curve;
    LoadOptions alone;
    alone.torque = 15 * newton_metre;
    alone.curve = alone.errors = false;
    double const single = only(study_load(quick(), alone)).stiffness;
    auto const at = std::find_if(curve.begin(), curve.end(),
                                 [&](LoadedState const& state) { return state.torque == *alone.torque; });
    REQUIRE(at != curve.end());
    CHECK(at->stiffness == Approx((at[1].torque - at[-1].torque) / (at[1].twist - at[-1].twist)).epsilon(1e-6));
    CHECK(single == Approx((at->torque - at[-1].torque) / (at->twist - at[-1].twist)).epsilon(0.03));
}

TEST_CASE("a drive that is its own mirror image is solved for one sign of torque only", "[load]")
{
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.points = 2;
    options.errors = false;
    auto const curve_of = [&](char const* angle) {
        return study_load(quick({std::string("contact.wave_generator_angle_deg=") + angle}), options)
            .cases.front()
            .curve;
    };
    // 1e-9 degrees leave the drive as it is, but not its own mirror image.
    std::vector<LoadedState> const mirrored = curve_of("0"), solved = curve_of("1e-9");
    REQUIRE(mirrored.size() == solved.size());
    for (std::size_t i = 0; i < mirrored.size(); ++i) {
        INFO(i);
        CHECK(mirrored[i].torque == solved[i].torque);
        CHECK(mirrored[i].twist == Approx(solved[i].twist).epsilon(1e-4).margin(1e-12));
        CHECK(mirrored[i].wave_generator_torque == Approx(solved[i].wave_generator_torque).epsilon(1e-3).margin(1e-6));
        CHECK(mirrored[i].lobe_force_across == Approx(solved[i].lobe_force_across).epsilon(1e-3).margin(1e-3));
        CHECK(mirrored[i].pressure_z == solved[i].pressure_z);
        CHECK(mirrored[i].pressure_space == solved[i].pressure_space);
        CHECK(mirrored[i].teeth == solved[i].teeth);
    }
}

TEST_CASE("a drive that is turned the other way under the opposite torque is the mirror image", "[load]")
{
    // lobes of 50 and 60 teeth are parted evenly by the bearing's contacts, one of 53 is not
    for (int ratio : {50, 53, 60}) {
        INFO("ratio " << ratio);
        DesignWishes wishes;
        wishes.ratio = ratio;
        wishes.diameter = 0.8 * ratio;
        wishes.length_ratio = 0.5;
        std::string const text = scene_text(design_drive(wishes));
        auto const turned = [&](double side) {
            std::string const angle = std::to_string(side * 0.7);
            return study_load(parse_scene(text, "turned", {},
                                          {"slices.count=3", "contact.flank_points=60", "bearing.circles=3",
                                           "contact.wave_generator_angle_deg=" + angle}),
                              at_torque(side * 5 * newton_metre));
        };
        LoadStudy const forth = turned(1), back = turned(-1);
        LoadedState const &a = only(forth), &b = only(back);
        CHECK(b.twist == Approx(-a.twist).epsilon(1e-6));
        CHECK(b.largest_force == Approx(a.largest_force).epsilon(1e-5));
        CHECK(b.wave_generator_torque == Approx(-a.wave_generator_torque).epsilon(1e-5));
        CHECK(b.lobe_force == Approx(a.lobe_force).epsilon(1e-6));
        CHECK(b.lobe_force_across == Approx(-a.lobe_force_across).epsilon(1e-5));
        CHECK(b.largest_stress == Approx(a.largest_stress).epsilon(1e-5));
        CHECK(back.cases.front().backlash == Approx(forth.cases.front().backlash).epsilon(1e-6).margin(1e-9));
    }
}

TEST_CASE("the stiffness at the rated torque does not depend on the other torques", "[load]")
{
    auto const rated = [](int points, bool curve) {
        LoadOptions options;
        options.errors = false;
        options.curve = curve;
        if (points > 0)
            options.points = points;
        LoadCase const found = study_load(quick(), options).cases.at(0);
        return found.curve.at(found.rated).stiffness;
    };
    double const alone = rated(0, false);
    for (int const points : {0, 1, 2, 5})
        CHECK(rated(points, true) == Approx(alone).epsilon(1e-3));
}

TEST_CASE("a widened tip circle is told against that of the scene, and no draft of slices is left out in silence",
          "[load]")
{
    LoadOptions options;
    options.errors = options.curve = false;
    options.surfaces = {ToothSurface::tilted, ToothSurface::per_slice};
    options.kinds = {TiltKind::radial, TiltKind::draft};
    LoadStudy const study = study_load(quick({"circular_spline.inner_radius=25.08"}), options);
    REQUIRE(study.cases.size() == 3);
    for (LoadCase const& each : study.cases)
        CHECK(each.tip_radius_increase == Approx(each.tip - 25.08).margin(1e-9));
    CHECK(study.cases.back().tip_radius_increase > 0);
    REQUIRE(study.missing.size() == 1);
    CHECK_THAT(study.missing.front(), ContainsSubstring("a draft needs one outline"));
}

TEST_CASE("stiffness and lost motion of a catalogue are those of the curve's own torques", "[load]")
{
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.points = 4;  // 5, 10, 15 and 20 N m
    LoadCase const found =
        study_load(quick({"load.torque=20", "load.first_torque=5", "load.second_torque=15"}), options).cases.front();
    REQUIRE(found.catalogue);
    CatalogueFigures const& c = *found.catalogue;
    auto const twist = [&](int steps) {
        auto const at = std::find_if(found.curve.begin(), found.curve.end(), [&](LoadedState const& state) {
            return state.torque == 5.0 * steps * newton_metre;
        });
        REQUIRE(at != found.curve.end());
        return at->twist;
    };
    constexpr double same = 1e-12;
    CHECK(c.torque.lost_motion == Approx(0.04 * 20 * newton_metre));
    CHECK(c.k1.value == Approx(5 * newton_metre / (twist(1) - found.backlash / 2)).epsilon(same));
    CHECK(c.k2.value == Approx(10 * newton_metre / (twist(3) - twist(1))).epsilon(same));
    CHECK(c.k3.value == Approx(5 * newton_metre / (twist(4) - twist(3))).epsilon(same));
    CHECK(c.lost_motion > found.backlash);
    CHECK(c.lost_motion < found.backlash + 2 * (twist(1) - found.backlash / 2));
    CHECK(c.estimated);
    CHECK(c.k1.error > 0);
    options.curve = false;
    CHECK_FALSE(study_load(quick(), options).cases.front().catalogue);
    for (char const* key : {"load.first_torque=25", "load.second_torque=25"})
        CHECK_FALSE(check_load(builtin_scene({"load.torque=20", key}), {}).empty());
}

TEST_CASE("only the verb load enters the stages of a load", "[load]")
{
    std::map<Stage, int> count;
    (void)solve(builtin_scene(), [&](Stage stage) { ++count[stage]; });
    CHECK(count[Stage::cup] + count[Stage::influence] + count[Stage::assembly] + count[Stage::load] == 0);
    (void)study_load(quick(), at_torque(newton_metre), [&](Stage stage) { ++count[stage]; });
    CHECK(count[Stage::influence] == 1);
    CHECK(count[Stage::assembly] == 1);
    CHECK(count[Stage::load] == 1);
}

TEST_CASE("more than the teeth can carry is said", "[load]")
{
    // a torque that lifts the teeth over each other, or presses them flat: an error that names the torque
    try {
        (void)study_load(quick(), at_torque(1e5 * newton_metre));
        FAIL("teeth of type-50 carry 100 kN m");
    } catch (NumericalError const& error) {
        CHECK(std::string(error.what()).find("N m") != std::string::npos);
        CHECK(error.remedy() == "write a smaller torque");
    }
}

TEST_CASE("torques beyond what the teeth can carry are marked, and the others stay", "[load]")
{
    LoadOptions options;
    options.torque = 4000 * newton_metre;
    options.points = 4;
    options.errors = false;
    LoadStudy const study = study_load(quick(), options);
    LoadCase const& found = study.cases.front();
    REQUIRE_FALSE(found.unsettled.empty());
    // 0, quarters of T, and those of the catalogue, of both signs
    CHECK(found.curve.size() + found.unsettled.size() == 15);
    CHECK(study.missing.size() == found.unsettled.size());
    for (auto const& each : found.unsettled) {
        CHECK(std::abs(each.torque) > found.curve[found.rated].torque);
        CHECK_FALSE(each.cause.empty());
    }
    // the text says which torque the figures are of
    std::string const text = summary_text(study, {}, nullptr);
    std::string const torque = short_number(found.curve[found.rated].torque / newton_metre) + " N m";
    CHECK_THAT(text, ContainsSubstring("at " + torque + ": no result at 4000 N m, see the notes"));
    CHECK_THAT(text, ContainsSubstring("twist at " + torque + " of "));
    CHECK(text.find("bearing, at 4000 N m") == std::string::npos);
}

TEST_CASE("many balls are a continuous row of balls", "[load][balls]")
{
    LoadStudy const line = study_load(quick(), at_torque(20 * newton_metre));
    double last = 1e9;
    double total = 0;
    for (int balls : {20, 60, 200}) {
        LoadStudy const single =
            study_load(quick({"bearing.balls=" + std::to_string(balls)}), at_torque(20 * newton_metre));
        CAPTURE(balls);
        double const apart = std::abs(only(single).wave_generator_force / only(line).wave_generator_force - 1);
        CHECK(apart < 0.8 * last);
        last = apart;
        BearingMap const& map = single.cases.front().bearing;
        CHECK(map.ball_force.size() == static_cast<std::size_t>(balls / 2));
        CHECK(*std::min_element(map.ball_force.begin(), map.ball_force.end()) >= 0);
        total = 0;
        for (double const force : map.ball_force)
            total += force;
        CHECK(only(single).balls <= balls);
        CHECK(only(single).ball_force == *std::max_element(map.ball_force.begin(), map.ball_force.end()));
    }
    // as many as the harmonics tell apart
    CHECK(last < 1e-6);
    constexpr double radius = 25 - 0.303 - 0.7 - 1.2;  // of the ring's inner circle on type-50 [mm]
    double reaction = 0;
    BearingMap const& map = line.cases.front().bearing;
    for (double const load : map.ball_force)
        reaction += load * radius * std::numbers::pi / static_cast<double>(map.ball_force.size());
    CHECK(total == Approx(reaction).epsilon(1e-6));
}

TEST_CASE("an odd number of balls is a ring without symmetry that differs little from an even one", "[load][balls]")
{
    LoadStudy const even =
        study_load(quick({"bearing.balls=22", "bearing.ball_phase_deg=0"}), at_torque(20 * newton_metre));
    LoadStudy const odd = study_load(quick({"bearing.balls=23"}), at_torque(20 * newton_metre));
    CHECK(even.sectors == 2);
    CHECK(odd.sectors == 1);
    CHECK(odd.cases.front().bearing.ball_force.size() == 23);
    CHECK(only(odd).twist == Approx(only(even).twist).epsilon(0.05));
    CHECK(only(odd).wave_generator_force == Approx(only(even).wave_generator_force).epsilon(0.02));
    CHECK(only(odd).gap_mismatch < 1e-6);
    CHECK(only(odd).complementarity < 1e-10);
}

TEST_CASE("balls with play stand off the ring under load too", "[load][balls]")
{
    for (Keys const& more : {Keys{}, Keys{"bearing.balls=24"}}) {
        Keys keys = more;
        for (std::string const loose : {"bearing.cam_oversize=-0.01", "circular_spline.inner_radius=25.06"})
            keys.push_back(loose);
        LoadStudy const study = study_load(quick(keys), at_torque(20 * newton_metre));
        std::vector<double> const& force = study.cases.front().bearing.ball_force;
        CHECK(*std::min_element(force.begin(), force.end()) == 0);
        CHECK(*std::max_element(force.begin(), force.end()) > 0);
        CHECK(only(study).gap_mismatch < 1e-6);
        CHECK(only(study).complementarity < 1e-10);
        CHECK(only(study).wave_generator_force <
              only(study_load(quick(more), at_torque(20 * newton_metre))).wave_generator_force);
    }
}

TEST_CASE("estimates bound the distance to a fine grid", "[load][errors]")
{
    // seeded: amplitude, wall, side clearance, angle of the wave generator, torque
    struct Drawn
    {
        double w0, wall, clearance, angle, torque;
    };
    for (Drawn const& d :
         {Drawn{0.254, 0.66, 0.09, 0.4, 22}, Drawn{0.262, 0.55, 0.065, 1.1, 9}, Drawn{0.258, 0.8, 0.08, 0.2, 40}}) {
        Keys const keys{"wave_generator.radial_deformation=" + std::to_string(d.w0),
                        "flexspline.wall=" + std::to_string(d.wall),
                        "circular_spline.backlash_offset=" + std::to_string(d.clearance),
                        "contact.wave_generator_angle_deg=" + std::to_string(d.angle)};
        Keys fine = keys, coarse = keys;
        for (std::string const more : {"slices.count=5", "contact.flank_points=80", "bearing.circles=5"})
            coarse.push_back(more);
        for (std::string const more : {"slices.count=9", "contact.flank_points=160", "bearing.circles=9"})
            fine.push_back(more);
        LoadStudy const a = study_load(builtin_scene(coarse), at_torque(d.torque * newton_metre, true));
        LoadStudy const b = study_load(builtin_scene(fine), at_torque(d.torque * newton_metre));
        LoadCase const& c = a.cases.front();
        CAPTURE(d.w0, d.wall, d.clearance, d.torque);
        REQUIRE(c.estimated);
        for (double LoadedState::*const figure :
             {&LoadedState::twist, &LoadedState::stiffness, &LoadedState::contact_fraction,
              &LoadedState::fraction_within_gap, &LoadedState::largest_force, &LoadedState::wave_generator_force,
              &LoadedState::lobe_force}) {
            CAPTURE(only(a).*figure, only(b).*figure);
            CHECK(c.error.*figure > 0);
            CHECK(std::abs(only(a).*figure - only(b).*figure) <= c.error.*figure);
        }
        CHECK(std::abs(c.backlash - b.cases.front().backlash) <= c.backlash_error);
        CHECK(std::abs(a.cup.coning_major - b.cup.coning_major) <= a.cup.coning_major_error);
        CHECK(c.error.largest_stress > 0);
    }
    LoadStudy const two = study_load(quick({"slices.count=2"}), at_torque(20 * newton_metre, true));
    CHECK_FALSE(two.cases.front().estimated);
    CHECK(two.cases.front().curve_error.empty());
}

TEST_CASE("errors contain what grids agree on by chance", "[load][errors]")
{
    DesignWishes wishes;
    wishes.ratio = 77;
    wishes.diameter = 50;
    std::string const text = scene_text(design_drive(wishes));
    auto const with_slices = [&](char const* count, bool errors) {
        return study_load(parse_scene(text, "designed", {},
                                      {count, "slices.surface=tilted", "circular_spline.backlash_offset=0.105"}),
                          at_torque(28 * newton_metre, errors));
    };
    LoadStudy const coarse = with_slices("slices.count=9", true), fine = with_slices("slices.count=17", false);
    LoadedState const &a = only(coarse), &b = only(fine), &error = coarse.cases.front().error;
    CHECK(std::abs(b.wave_generator_torque - a.wave_generator_torque) < error.wave_generator_torque);
    CHECK(std::abs(b.lobe_force_across - a.lobe_force_across) < error.lobe_force_across);
    // the knee is not known better than the worse line, the second line not better than a third of it
    LoadOptions curve;
    curve.torque = 28 * newton_metre;
    StiffnessStages const stages =
        study_load(builtin_scene({"slices.count=9", "circular_spline.backlash_offset=0.075"}), curve)
            .cases.front()
            .stages;
    CHECK(stages.second_error / stages.second >= 0.333 * stages.first_error / stages.first);
    CHECK(stages.knee_error / stages.knee >= 0.999 * stages.first_error / stages.first);
}

TEST_CASE("members in series, which are known, leave the error of the lost motion", "[load][errors]")
{
    // here the error of the lost motion is that of the twist, relative to its size
    auto const lost_motion = [](Keys more) {
        more.push_back("circular_spline.backlash_offset=0.065");
        LoadOptions options;
        options.torque = 28 * newton_metre;
        options.points = 5;
        CatalogueFigures const found = *study_load(quick(more), options).cases.front().catalogue;
        return std::pair(found.lost_motion, found.lost_motion_error);
    };
    auto const alone = lost_motion({}),
               with = lost_motion({"compliance.flange=200000", "compliance.shaft=25000", "compliance.hub=300000"});
    double const compliance = 1e-3 * (1 / 200000.0 + 1 / 25000.0 + 1 / 300000.0);  // rad/(N mm)
    CHECK(with.first == Approx(alone.first + 2 * 0.04 * 28 * newton_metre * compliance).epsilon(1e-9));
    CHECK(with.second == Approx(alone.second).epsilon(1e-6));
}

TEST_CASE("the coning of three slices is within its error of that of many", "[load][errors]")
{
    AssembledCup const few = study_load(quick(), at_torque(20 * newton_metre, true)).cup;
    AssembledCup const many = study_load(quick({"slices.count=25"}), at_torque(20 * newton_metre)).cup;
    CHECK(std::abs(few.coning_major - many.coning_major) <= few.coning_major_error);
    CHECK(std::abs(few.coning_minor - many.coning_minor) <= few.coning_minor_error);
    CHECK(few.coning_major_error < 0.1 * std::abs(few.coning_major));
}

TEST_CASE("every torque of a curve has an estimate that bounds its distance to a fine grid", "[load][errors]")
{
    Keys const keys{"wave_generator.radial_deformation=0.257", "flexspline.wall=0.6",
                    "circular_spline.backlash_offset=0.07", "contact.wave_generator_angle_deg=0.7"};
    Keys fine = keys, coarse = keys;
    for (std::string const more : {"slices.count=3", "contact.flank_points=60", "bearing.circles=5"})
        coarse.push_back(more);
    for (std::string const more : {"slices.count=5", "contact.flank_points=120", "bearing.circles=9"})
        fine.push_back(more);
    LoadOptions options = at_torque(30 * newton_metre, true);
    options.curve = true;
    options.points = 2;
    LoadCase const c = study_load(builtin_scene(coarse), options).cases.front();
    options.errors = false;
    LoadCase const f = study_load(builtin_scene(fine), options).cases.front();
    REQUIRE(c.curve_error.size() == c.curve.size());
    REQUIRE(f.curve.size() == c.curve.size());
    for (std::size_t i = 0; i < c.curve.size(); ++i) {
        CAPTURE(c.curve[i].torque, c.curve[i].twist, f.curve[i].twist);
        REQUIRE(c.curve_error[i]);
        for (double LoadedState::*const figure :
             {&LoadedState::twist, &LoadedState::contact_fraction, &LoadedState::wave_generator_force})
            CHECK(std::abs(c.curve[i].*figure - f.curve[i].*figure) <= (*c.curve_error[i]).*figure);
        CHECK((c.curve[i].torque == 0 || c.curve_error[i]->twist > 0));
    }
    CHECK(c.curve_error[c.rated]->twist == c.error.twist);
    // far from all of it
    CHECK(c.curve_error[c.rated]->twist < 0.5 * c.curve[c.rated].twist);
}

TEST_CASE("errors along the curve of a designed drive bound its distance to a finer grid", "[load][errors]")
{
    DesignWishes wishes;
    wishes.ratio = 80;
    wishes.diameter = 62.5;
    wishes.family = "cycloid";
    std::string const text = scene_text(design_drive(wishes));
    LoadOptions options = at_torque(40 * newton_metre, true);
    options.curve = true;
    options.points = 6;
    LoadCase const here = study_load(parse_scene(text, "designed"), options).cases.front();
    options.errors = false;
    // nine planes against 17, or 33
    std::string const finer = full_run() ? "slices.count=33" : "slices.count=17";
    LoadCase const there = study_load(parse_scene(text, "designed", {}, {finer}), options).cases.front();
    REQUIRE(here.curve_error.size() == here.curve.size());
    REQUIRE(there.curve.size() == here.curve.size());
    for (std::size_t i = 0; i < here.curve.size(); ++i) {
        CAPTURE(here.curve[i].torque, here.curve[i].twist, there.curve[i].twist);
        REQUIRE(here.curve_error[i]);
        for (double LoadedState::*const figure : {&LoadedState::twist, &LoadedState::largest_force,
                                                  &LoadedState::largest_line_load, &LoadedState::edge_force})
            CHECK(std::abs(here.curve[i].*figure - there.curve[i].*figure) <= (*here.curve_error[i]).*figure);
    }
}

TEST_CASE("more harmonics than the teeth tell apart are refused", "[load]")
{
    try {
        (void)study_load(quick({"load.torque=28", "load.harmonics=300"}));
        FAIL("300 harmonics of 200 teeth were taken");
    } catch (InputError const& error) {
        CHECK(std::string(error.what()).find("--set: load.harmonics = 300") != std::string::npos);
        CHECK(std::string(error.what()).find("write at most 100") != std::string::npos);
    }
}

TEST_CASE("a tip circle that nobody gave does not make a load fail", "[load]")
{
    // four fifths of type-50's tooth: the cup cones away from a land at the standard tip circle
    Keys const keys{"drive.module=0.2",
                    "drive.flexspline_teeth=300",
                    "drive.circular_spline_teeth=302",
                    "wave_generator.radial_deformation=0.19",
                    "flexspline.profile.addendum=0.18",
                    "flexspline.profile.dedendum=0.2424",
                    "flexspline.profile.convex_radius=0.21608",
                    "flexspline.profile.convex_offset=0.07856",
                    "flexspline.profile.concave_radius=0.4116",
                    "flexspline.profile.concave_rise=0.05368",
                    "flexspline.profile.tip_line_from=0.152",
                    "contact.flank_points=40",
                    "slices.count=2"};
    Keys standard = keys, narrow = keys;
    standard.push_back("!circular_spline.inner_radius");
    narrow.push_back("circular_spline.inner_radius=30.01");
    LoadStudy const study = study_load(quick(standard), at_torque(10 * newton_metre));
    CHECK(study.standard_tip_increase > 0);
    CHECK(30.01 + study.standard_tip_increase == Approx(30.026).epsilon(1e-12));
    CHECK(study.solution.geometry.circular_spline_inner_radius == study.cases.front().tip);
    CHECK(std::ranges::any_of(study.solution.notes, [](std::string const& note) {
        return note.find("with one of 30.026 mm the circular spline cannot be made") != std::string::npos;
    }));
    CHECK(only(study).gap_mismatch < 1e-6);
    CHECK_THROWS_WITH(study_load(quick(narrow), at_torque(10 * newton_metre)),
                      ContainsSubstring("inner_radius above 30.02"));
    CHECK(study_load(quick(), at_torque(newton_metre)).standard_tip_increase == 0);
}

TEST_CASE("contact and load take the same part: the scene's own where nothing enters it", "[load][contact]")
{
    constexpr double arcmin = std::numbers::pi / (180 * 60);
    // the same grid of the bearing for both
    Keys const coned{"coning.model=elastic", "coning.bottom_to_middle=9", "slices.surface=tilted",
                     "bearing.circles=13"};
    struct Row
    {
        Keys more;
        double least_tip, largest_tip;  // [mm]
    };
    // the scene's tip circle though another, wider one goes with the least side clearance; and where the side
    // clearance leaves no land, one that does
    for (Row const& row : std::vector<Row>{{{"circular_spline.inner_radius=25.2", "tilt.angle_deg=0.3"}, 25.2, 25.2},
                                           {{"circular_spline.backlash_offset=0.08"}, 25.1023, 25.12},
                                           {{}, 25.1127, 25.13}}) {
        Keys keys = coned;
        keys.insert(keys.end(), row.more.begin(), row.more.end());
        INFO(row.more.size() << " more keys, tip circle from " << row.least_tip << " mm");
        ContactCase const rigid = study_contact(quick(keys)).cases.front();
        CHECK(rigid.tip >= row.least_tip);
        CHECK(rigid.tip <= row.largest_tip);
        CHECK(rigid.tip < rigid.least_tip_radius);
        CHECK_FALSE(rigid.side_clearance_increased);
        CHECK(rigid.closest_flank().clearance > 0);
        CHECK(rigid.clearance_error < 1e-3);
        // edges that are round under load are sharp in contact; three slices know the bent cup to about a twentieth of
        // a minute
        constexpr double alike = 0.1 * arcmin;
        keys.push_back("load.edge_radius=0.001");
        LoadCase const loaded = study_load(quick(keys), at_torque(1e-4 * newton_metre)).cases.front();
        CHECK(loaded.tip == Approx(rigid.tip).epsilon(1e-12));
        CHECK(loaded.backlash_offset == rigid.backlash_offset);
        CHECK_FALSE(loaded.side_clearance_increased);
        CHECK(loaded.backlash == Approx(rigid.state.backlash()).margin(alike));
        if (row.least_tip == row.largest_tip)
            CHECK(solve(quick(keys)).geometry.circular_spline_inner_radius == rigid.tip);
        else
            CHECK_THROWS_WITH(solve(quick(keys)),
                              ContainsSubstring("inner_radius above " + std::to_string(row.least_tip).substr(0, 6)));
    }
}

}  // namespace hdconj::test::load_cases
