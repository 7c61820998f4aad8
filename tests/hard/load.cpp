// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Hard cases of a load. Every line is one of the table in docs/explanation/stability.md.
#include <algorithm>
#include <cmath>

#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/units.hpp"
#include "row.hpp"

namespace hdconj::test::load_cases {

namespace {

/// Few slices and points, so that a torque takes a fraction of a second; no estimates of errors, which are computed on
/// other grids after the balance.
LoadCase loaded(Overrides const& keys, double torque_nm, LoadStudy* whole = nullptr)
{
    LoadOptions options;
    options.torque = torque_nm * 1e3;
    options.curve = options.errors = false;
    LoadStudy study = study_load(
        builtin_scene(Overrides{"slices.count=3", "contact.flank_points=60", "bearing.circles=5"} + keys), options);
    LoadCase result = study.cases.front();
    if (whole != nullptr)
        *whole = std::move(study);
    return result;
}

/// What holds for every state in balance.
void check_laws(LoadCase const& c)
{
    LoadedState const& state = c.curve.front();
    CHECK(std::isfinite(state.twist));
    CHECK(state.complementarity <= 1e-10);  // force, gap and torque row
    CHECK(state.gap_mismatch <= 1e-6);      // gaps of the loaded shape
    CHECK(*std::min_element(c.map.force.begin(), c.map.force.end()) >= 0);
    double sum = 0;
    for (double const f : c.map.force)
        sum += f;
    // no flank has a longer lever than the teeth's radius
    CHECK(2 * sum * 25.6 >= std::abs(state.torque));
}

std::string told(LoadCase const& c)
{
    LoadedState const& s = c.curve.front();
    return "twist " + three_digits(s.twist * 180 * 60 / 3.14159265358979) + "', " + std::to_string(s.teeth) +
           " teeth, residual " + three_digits(s.gap_mismatch * 1e6) + " nm, " + std::to_string(s.iterations) +
           " rounds, complementarity " + three_digits(s.complementarity);
}

}  // namespace

HARD_ROW("no contact at all", "no torque within the play", "no force, twist 0")
{
    LoadCase const c = loaded({"circular_spline.backlash_offset=0.09"}, 0);
    check_laws(c);
    CHECK(c.curve.front().twist == 0);
    CHECK(*std::max_element(c.map.force.begin(), c.map.force.end()) == 0);
    say(told(c));
}

HARD_ROW("a torque of 1e-9 N m", "forces of 1e-8 N", "balance")
{
    LoadCase const c = loaded({"circular_spline.backlash_offset=0.09"}, 1e-9);
    check_laws(c);
    CHECK(c.curve.front().twist == Approx(c.backlash / 2).epsilon(1e-3));
    say(told(c));
}

HARD_ROW("every tooth that is near", "a torque of 1000 N m", "balance")
{
    LoadCase const c = loaded({"circular_spline.backlash_offset=0.09"}, 1000);
    check_laws(c);
    CHECK(c.curve.front().teeth > 80);
    say(told(c));
}

HARD_ROW("a tip about to snap over the edge of a land",
         "2.8 N m with 75 um of side clearance: guesses are drawn back to a balance that is not stable",
         "the balance that is")
{
    LoadCase const c = loaded(
        {"slices.count=9", "contact.flank_points=200", "bearing.circles=13", "circular_spline.backlash_offset=0.075"},
        2.8);
    check_laws(c);
    say(told(c));
}

HARD_ROW("more than the teeth can carry", "a torque of 1e7 N m", "an error that names the torque")
{
    try {
        (void)loaded({"circular_spline.backlash_offset=0.09"}, 1e7);
        FAIL("a torque of 1e7 N m was carried");
    } catch (NumericalError const& error) {
        CHECK(std::string(error.what()).starts_with("load: torque of 1e+07 N m: "));
        say(error.what());
    }
}

HARD_ROW("no side clearance", "teeth press without torque", "balance")
{
    LoadCase const c = loaded({"circular_spline.backlash_offset=0.0"}, 5);
    check_laws(c);
    say(told(c));
}

HARD_ROW("a side clearance of 1e-12 mm", "gaps of roundings", "as with none")
{
    LoadCase const c = loaded({"circular_spline.backlash_offset=1e-12"}, 5);
    check_laws(c);
    CHECK(c.curve.front().twist ==
          Approx(loaded({"circular_spline.backlash_offset=0.0"}, 5).curve.front().twist).epsilon(1e-6));
    say(told(c));
}

HARD_ROW("one slice", "no neighbour along the axis", "balance")
{
    LoadCase const c = loaded({"slices.count=1", "circular_spline.backlash_offset=0.065"}, 20);
    check_laws(c);
    say(told(c));
}

HARD_ROW("two circles of the bearing", "as few as there may be", "balance")
{
    LoadCase const c = loaded({"bearing.circles=2", "circular_spline.backlash_offset=0.065"}, 20);
    check_laws(c);
    say(told(c));
}

HARD_ROW("one ball", "the ring may move across it", "an error with reason and remedy")
{
    try {
        (void)loaded({"bearing.balls=1", "circular_spline.backlash_offset=0.065"}, 20);
        FAIL("a ring on one ball was loaded");
    } catch (InputError const& error) {
        CHECK(std::string(error.what()).find("bearing.balls") != std::string::npos);
        CHECK(std::string(error.what()).find("balls") != std::string::npos);
        say(error.what());
    }
}

HARD_ROW("two balls", "on the major axis, the ring hangs between them", "balance, or an error with place")
{
    try {
        LoadStudy study;
        LoadCase const c = loaded({"bearing.balls=2", "circular_spline.backlash_offset=0.065"}, 5, &study);
        check_laws(c);
        REQUIRE(c.bearing.ball_force.size() == 1);
        CHECK(c.bearing.ball_force.front() > 100);
        say(told(c) + ", ball " + three_digits(c.bearing.ball_force.front()) + " N");
    } catch (NumericalError const& error) {
        CHECK(std::string(error.what()).find("load: ") == 0);
        say(error.what());
    }
}

HARD_ROW("two balls beside the major axis", "the cam leaves the ring there", "balance, or an error with place")
{
    try {
        LoadCase const c =
            loaded({"bearing.balls=2", "bearing.ball_phase_deg=90", "circular_spline.backlash_offset=0.065"}, 5);
        check_laws(c);
        say(told(c));
    } catch (NumericalError const& error) {
        CHECK(std::string(error.what()).find(": ") != std::string::npos);
        say(error.what());
    }
}

HARD_ROW("a wall of 5 mm", "it leaves no room for the circular spline's land", "an error with place and remedy")
{
    try {
        (void)loaded({"flexspline.wall=5.0", "circular_spline.backlash_offset=0.065"}, 20);
        FAIL("a circular spline without a land was loaded");
    } catch (NumericalError const& error) {
        CHECK(std::string(error.what()).find("write a circular_spline.inner_radius above") != std::string::npos);
        say(error.what());
    }
}

HARD_ROW("a wall of 0.05 mm", "the ring under the teeth is thinner than the barrel", "balance")
{
    LoadCase const c = loaded({"flexspline.wall=0.05", "circular_spline.backlash_offset=0.065"}, 1);
    check_laws(c);
    say(told(c));
}

HARD_ROW("teeth in each other's way when assembled", "one outline in a cup that cones, no side clearance given",
         "the least clearance is added and said")
{
    LoadCase const c = loaded({"circular_spline.backlash_offset=0.0"}, 0.01);
    check_laws(c);
    CHECK(c.side_clearance_increased);
    CHECK(c.backlash_offset > 0);
    say(told(c));
}

HARD_ROW("an edge of 1 nm", "as sharp as a number can say", "balance")
{
    LoadCase const c = loaded({"load.edge_radius=1e-6", "circular_spline.backlash_offset=0.065"}, 5);
    check_laws(c);
    say(told(c));
}

HARD_ROW("a minimum of the gap that vanishes", "conformal flanks of a drive of module 0.175, 7.5 to 8.5 N m",
         "balance at each torque, the twist a smooth curve")
{
    Overrides const small = {"drive.module=0.175",
                             "flexspline.wall=0.5",
                             "flexspline.cup.length=11",
                             "flexspline.cup.barrel_wall=0.28",
                             "flexspline.cup.bottom=0.4",
                             "flexspline.cup.corner_radius=1.5",
                             "flexspline.cup.flange_radius=8.5",
                             "flexspline.cup.tooth_width=5",
                             "flexspline.cup.front_land=0.8",
                             "flexspline.cup.rear_ramp=0.3",
                             "flexspline.cup.front_ramp=0.3",
                             "flexspline.profile.addendum=0.1575",
                             "flexspline.profile.dedendum=0.2121",
                             "flexspline.profile.convex_radius=0.18907",
                             "flexspline.profile.convex_offset=0.06874",
                             "flexspline.profile.concave_radius=0.36015",
                             "flexspline.profile.concave_rise=0.04697",
                             "flexspline.profile.tip_line_from=0.133",
                             "wave_generator.radial_deformation=0.17",
                             "circular_spline.width=4.5",
                             "circular_spline.backlash_offset=0",
                             "circular_spline.inner_radius=17.535",
                             "coning.model=\"elastic\"",
                             "coning.bottom_to_middle=7.7",
                             "coning.axial_shift=\"mapped\"",
                             "bearing.type=\"elastic\"",
                             "bearing.width=4",
                             "bearing.ring_thickness=0.8",
                             "slices.count=9",
                             "slices.surface=\"per-slice\""};
    std::vector<double> twist;
    for (double const torque : {7.5, 8.0, 8.5}) {
        LoadOptions options;
        options.torque = torque * newton_metre;
        options.curve = options.errors = false;
        LoadCase const c = study_load(builtin_scene(small), options).cases.front();
        check_laws(c);
        twist.push_back(c.curve.front().twist);
        say(told(c));
    }
    CHECK(std::abs(twist[1] - (twist[0] + twist[2]) / 2) < 1e-3 * twist[1]);
}

}  // namespace hdconj::test::load_cases
