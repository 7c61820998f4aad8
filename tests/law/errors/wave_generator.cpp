// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of a loaded drive whose wave generator, or whose circular spline's profile, has errors.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/load.hpp"
#include "law/errors/load_at_torque.hpp"
#include "support/catch.hpp"

namespace hdconj::test::load_generator_error_cases {

namespace {

using Keys = std::vector<std::string>;

constexpr int z_c = 202;

/// Rows of angle and excess over the whole turn, every 5 degrees.
template <class Excess>
std::string cam_deviation(Excess const& excess)
{
    std::string rows;
    for (int angle = 0; angle < 360; angle += 5)
        rows += (rows.empty() ? "[[" : ", [") + std::to_string(angle) + ", " +
                std::to_string(1e3 * excess(angle * std::numbers::pi / 180)) + "e-3]";
    return "errors.wave_generator.cam_deviation=" + rows + "]";
}

Keys eccentric(double amount, double phase)
{
    return {"errors.wave_generator.eccentricity=" + std::to_string(1e6 * amount) + "e-6",
            "errors.wave_generator.eccentricity_phase_deg=" + std::to_string(phase)};
}

/// Forces on the right flank of a tooth space, over all slices. Spaces of one sector stand for all.
double force_in(LoadStudy const& study, std::size_t space)
{
    LoadMap const& map = study.cases.front().map;
    double force = 0;
    for (std::size_t k = 0; k < map.z.size(); ++k)
        force += map.force[map.index(space, GapMap::right, k)];
    return force;
}

}  // namespace

TEST_CASE("a wave generator with errors of nothing keeps every bit", "[load][errors]")
{
    LoadStudy const& plain = plain_load();
    for (Keys const& nothing : {eccentric(0, 30), Keys{cam_deviation([](double) { return 0.0; })}}) {
        LoadStudy const same = load_at_torque(15, nothing);
        CHECK(same.sectors == 2);
        CHECK(same.cases.front().map.force == plain.cases.front().map.force);
        CHECK(only_state(same).twist == only_state(plain).twist);
    }
    // 0.01 nm make the whole ring of it, and nothing else
    LoadStudy const whole = load_at_torque(15, eccentric(1e-8, 30));
    CHECK(whole.sectors == 1);
    check_same_state(only_state(whole), only_state(plain));
}

TEST_CASE("a deviation of the cam that is its own wave is a larger radial deformation", "[load][errors]")
{
    constexpr double more = 0.002;
    LoadStudy const deviating =
        load_at_torque(15, {cam_deviation([](double phi) { return more * std::cos(2 * phi); })});
    LoadStudy const larger = load_at_torque(15, {"wave_generator.radial_deformation=0.252"});
    LoadStudy const& plain = plain_load();
    CHECK(deviating.sectors == 2);
    constexpr double same = 1e-6;
    CHECK(deviating.cup.wave_generator_force == Approx(larger.cup.wave_generator_force).epsilon(same));
    CHECK(deviating.cup.coning_major == Approx(larger.cup.coning_major).epsilon(same));
    CHECK(deviating.cup.coning_minor == Approx(larger.cup.coning_minor).epsilon(same));
    CHECK(std::abs(deviating.cup.wave_generator_force / plain.cup.wave_generator_force - 1) > 1e-3);
}

TEST_CASE("a deviation of the cam all round is an oversize of the cam", "[load][errors]")
{
    LoadStudy const deviating = load_at_torque(15, {cam_deviation([](double) { return 0.003; })});
    LoadStudy const larger = load_at_torque(15, {"bearing.cam_oversize=0.003"});
    CHECK(deviating.sectors == 2);
    CHECK(deviating.cup.wave_generator_force == Approx(larger.cup.wave_generator_force).epsilon(1e-8));
    CHECK(deviating.cup.coning_minor == Approx(larger.cup.coning_minor).epsilon(1e-8));
}

TEST_CASE("an eccentric wave generator is a deviation of its cam with one wave in a turn", "[load][errors]")
{
    constexpr double amount = 0.004, phase = 40;
    LoadStudy const one = load_at_torque(15, eccentric(amount, phase));
    LoadStudy const other = load_at_torque(
        15, {cam_deviation([](double phi) { return amount * std::cos(phi - phase * std::numbers::pi / 180); })});
    CHECK(one.sectors == 1);
    check_same_state(only_state(one), only_state(other), 1e-5);
    CHECK(one.cases.front().backlash == Approx(other.cases.front().backlash).epsilon(1e-5));
    // and half a turn further the same drive, seen from the other lobe
    LoadStudy const turned = load_at_torque(15, eccentric(amount, phase + 180));
    check_same_state(only_state(one), only_state(turned));
    CHECK(std::abs(only_state(one).largest_force / only_state(plain_load()).largest_force - 1) > 0.02);
}

TEST_CASE("an eccentric wave generator moves the cup as a whole at the bearing", "[load][errors]")
{
    // The cup has as good as no stiffness against the tilt about its bottom: its wall follows the cam, with the same
    // shift at both lobes and in opposite directions. Where the bearing presses at the rear, the wall in front of it is
    // moved by more, as the distances from the bottom of 9 mm are.
    constexpr double amount = 0.002;
    auto const middle = [](LoadStudy const& study) { return study.cup.w_major[1]; };
    double const none = middle(plain_load()), out = middle(load_at_torque(15, eccentric(amount, 0))),
                 in = middle(load_at_torque(15, eccentric(amount, 180)));
    CHECK(out - none > amount);
    CHECK(out - none < amount * 9 / (9 - 3));
    CHECK(in - none == Approx(none - out).epsilon(0.02));
}

TEST_CASE("a small eccentricity changes forces in opposite zones by opposite amounts, and in proportion",
          "[load][errors]")
{
    constexpr double amount = 1e-4;
    LoadStudy const& plain = plain_load();
    LoadStudy const once = load_at_torque(15, eccentric(amount, 0)),
                    twice = load_at_torque(15, eccentric(2 * amount, 0));
    constexpr std::size_t half = z_c / 2;
    double largest = 0, unlike = 0, bent = 0;
    for (std::size_t space = 0; space < half; ++space) {
        double const base = force_in(plain, space);
        // the plain drive has the spaces of one lobe, from -50 on; those of the whole ring begin at -100
        double const here = force_in(once, space + half / 2) - base;
        double const there = force_in(once, (space + half / 2 + half) % z_c) - base;
        largest = std::max(largest, std::abs(here));
        unlike = std::max(unlike, std::abs(here + there));
        bent = std::max(bent, std::abs(force_in(twice, space + half / 2) - base - 2 * here));
    }
    CAPTURE(largest, unlike, bent);
    CHECK(largest > 0.01);
    CHECK(unlike < 0.05 * largest);
    CHECK(bent < 0.05 * largest);
}

TEST_CASE("a profile of the circular spline with more material everywhere is a smaller side clearance",
          "[load][errors]")
{
    std::string const form =
        "errors.circular_spline.profile_form=[[-0.3, 0.003], [-0.1, 0.003], [0.1, 0.003], [0.2, 0.003]]";
    LoadStudy const thick = load_at_torque(15, {form}),
                    close = load_at_torque(15, {"circular_spline.backlash_offset=0.087"});
    CHECK(thick.sectors == 2);
    // the land is cut at another place of the flank
    CHECK(thick.cases.front().backlash == Approx(close.cases.front().backlash).epsilon(1e-3));
    check_same_state(only_state(thick), only_state(close), 1e-3);
    // the same on the flexspline
    LoadStudy const inner = load_at_torque(
        15, {"errors.flexspline.profile_form=[[-0.3, 0.003], [-0.1, 0.003], [0.1, 0.003], [0.2, 0.003]]"});
    check_same_state(only_state(thick), only_state(inner), 1e-4);
}

TEST_CASE(
    "a slope of the circular spline is the form of a straight line, and the keys of the flexspline mean one thing",
    "[load][errors]")
{
    LoadStudy const one = load_at_torque(15, {"errors.profile_slope=0.002"}),
                    other = load_at_torque(15, {"errors.flexspline.profile_slope=0.002"});
    CHECK(one.cases.front().map.force == other.cases.front().map.force);
    CHECK(other.sectors == 2);

    LoadStudy const steep = load_at_torque(15, {"errors.circular_spline.profile_slope=0.003"});
    LoadStudy const& plain = plain_load();
    // two drives with a straight form, from which the height of the tooth follows
    std::string rows;
    for (double const height : {-0.4, -0.1, 0.1, 0.4})
        rows += (rows.empty() ? "[[" : ", [") + std::to_string(height) + ", " + std::to_string(height * 0.006) + "]";
    LoadStudy const straight = load_at_torque(15, {"errors.circular_spline.profile_form=" + rows + "]"});
    double const by_slope = steep.cases.front().backlash - plain.cases.front().backlash,
                 by_form = straight.cases.front().backlash - plain.cases.front().backlash;
    // 0.003 over the height of a tooth of about 1.8 modules, against 0.006 for each millimetre
    CHECK(by_slope / by_form == Approx(0.003 / 0.45 / 0.006).epsilon(0.08));
}

}  // namespace hdconj::test::load_generator_error_cases
