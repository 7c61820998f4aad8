// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of a loaded drive whose rings of teeth have errors.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "law/errors/load_at_torque.hpp"
#include "support/catch.hpp"

namespace hdconj::test::load_error_cases {

namespace {

using Keys = std::vector<std::string>;

constexpr int z_f = 200, z_c = 202;

std::string pitch(char const* ring, std::vector<double> const& places)
{
    return std::string("errors.") + ring + ".pitch=" + scene_list(places);
}

/// Random places within 2 um, which come again after @p period teeth.
std::vector<double> repeated(int teeth, int period)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> nanometres(-2000, 2000);
    std::vector<double> places;
    for (int i = 0; i < teeth; ++i)
        places.push_back(i < period ? 1e-6 * nanometres(random) : places[static_cast<std::size_t>(i - period)]);
    return places;
}

}  // namespace

TEST_CASE("errors of nothing on the whole ring are those of one lobe", "[load][errors]")
{
    LoadStudy const& plain = plain_load();
    REQUIRE(plain.sectors == 2);
    // 1 nm on one space, which touches nothing, is enough to make the lobes differ
    std::vector<double> places(z_c, 0);
    places[z_c / 4] = 1e-6;
    LoadStudy const whole = load_at_torque(15, {pitch("circular_spline", places)});
    CHECK(whole.sectors == 1);
    check_same_state(only_state(whole), only_state(plain));
    CHECK(whole.cases.front().backlash == Approx(plain.cases.front().backlash).epsilon(1e-6));
    // a list of nothing leaves the lobes alike, and every bit as it is
    LoadStudy const zero = load_at_torque(15, {pitch("circular_spline", std::vector<double>(z_c, 0))});
    CHECK(zero.sectors == 2);
    CHECK(zero.cases.front().map.force == plain.cases.front().map.force);
}

TEST_CASE("the whole ring of few teeth has the angles of its lobes", "[load][errors]")
{
    DesignWishes wishes;
    wishes.ratio = 40;
    wishes.diameter = 32;
    std::string const text = scene_text(design_drive(wishes));
    auto const loaded = [&](Keys keys) {
        keys.insert(keys.end(), {"slices.count=3", "bearing.circles=3", "load.harmonics=80"});
        LoadOptions options;
        options.torque = 3 * newton_metre;
        options.curve = options.errors = false;
        return study_load(parse_scene(text, "designed", {}, keys), options);
    };
    LoadStudy const lobe = loaded({}), ring = loaded({"errors.flexspline.eccentricity=1e-9"});
    CHECK(lobe.sectors == 2);
    CHECK(ring.sectors == 1);
    check_same_state(only_state(ring), only_state(lobe));
    CHECK(ring.cases.front().backlash == Approx(lobe.cases.front().backlash).epsilon(1e-4));
}

TEST_CASE("errors that both lobes have are those of one lobe", "[load][errors]")
{
    Keys both{pitch("flexspline", repeated(z_f, z_f / 2)), pitch("circular_spline", repeated(z_c, z_c / 2))};
    LoadStudy const half = load_at_torque(15, both);
    CHECK(half.sectors == 2);
    std::vector<double> places = repeated(z_c, z_c / 2);
    places[z_c / 4] += 1e-6;
    both.back() = pitch("circular_spline", places);
    LoadStudy const whole = load_at_torque(15, both);
    CHECK(whole.sectors == 1);
    check_same_state(only_state(whole), only_state(half));
    CHECK(std::abs(only_state(half).twist / only_state(plain_load()).twist - 1) > 1e-3);
}

TEST_CASE("a ring whose teeth all stand beside their places is turned, and nothing else", "[load][errors]")
{
    LoadStudy const& plain = plain_load();
    for (auto const& [ring, teeth] : {std::pair("flexspline", z_f), std::pair("circular_spline", z_c)}) {
        CAPTURE(ring);
        LoadStudy const turned =
            load_at_torque(15, {pitch(ring, std::vector<double>(static_cast<std::size_t>(teeth), 4e-3))});
        CHECK(turned.sectors == 2);
        CHECK(turned.cases.front().backlash == Approx(plain.cases.front().backlash).epsilon(1e-6));
        check_same_state(only_state(turned), only_state(plain));
    }
}

TEST_CASE("a tooth that stands ahead carries more, and a space that stands ahead less", "[load][errors]")
{
    LoadStudy const& plain = plain_load();
    LoadMap const& map = plain.cases.front().map;
    auto const force_in = [](LoadMap const& of, double angle) {
        double force = 0;
        for (std::size_t s = 0; s < of.angle.size(); ++s)
            for (std::size_t k = 0; k < of.z.size() && std::abs(of.angle[s] - angle) < 1e-9; ++k)
                force += of.force[of.index(s, GapMap::right, k)];
        return force;
    };
    // the space that carries most stands at the angle of the tooth of the same number
    double const pitch_angle = map.angle[1] - map.angle[0];
    double angle = 0;
    for (double const each : map.angle)
        angle = force_in(map, each) > force_in(map, angle) ? each : angle;
    auto const number = static_cast<int>(std::lround(angle / pitch_angle));
    double const base = force_in(map, angle);
    REQUIRE(base > 0);
    for (auto const& [ring, teeth, more] :
         {std::tuple("flexspline", z_f, true), std::tuple("circular_spline", z_c, false)}) {
        CAPTURE(ring);
        std::vector<double> places(static_cast<std::size_t>(teeth), 0);
        places[static_cast<std::size_t>((number + teeth) % teeth)] = 5e-4;
        LoadStudy const one = load_at_torque(15, {pitch(ring, places)});
        CHECK(one.sectors == 1);
        double const force = force_in(one.cases.front().map, angle);
        CHECK((more ? force > base : force < base));
        CHECK(
            (more ? only_state(one).twist < only_state(plain).twist : only_state(one).twist > only_state(plain).twist));
    }
}

TEST_CASE("errors in a mirror under the opposite torque are the mirror image", "[load][errors]")
{
    auto const mirrored = [](std::vector<double> const& places) {
        std::vector<double> result(places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            result[(places.size() - i) % places.size()] = -places[i];
        return result;
    };
    std::vector<double> const teeth = repeated(z_f, z_f), spaces = repeated(z_c, z_c);
    LoadStudy const forth = load_at_torque(15, {pitch("flexspline", teeth), pitch("circular_spline", spaces)});
    LoadStudy const back =
        load_at_torque(-15, {pitch("flexspline", mirrored(teeth)), pitch("circular_spline", mirrored(spaces))});
    CHECK(forth.sectors == 1);
    CHECK(only_state(back).twist == Approx(-only_state(forth).twist).epsilon(1e-4));
    CHECK(only_state(back).largest_force == Approx(only_state(forth).largest_force).epsilon(1e-3));
    CHECK(back.cases.front().backlash == Approx(forth.cases.front().backlash).epsilon(1e-6));
    // the drive itself is not
    LoadStudy const other = load_at_torque(-15, {pitch("flexspline", teeth), pitch("circular_spline", spaces)});
    CHECK(std::abs(-only_state(other).twist / only_state(forth).twist - 1) > 1e-4);
}

TEST_CASE("a seed gives the same random places again, and another seed others", "[load][errors]")
{
    auto const twist = [](char const* seed) {
        return only_state(
                   load_at_torque(15, {std::string("errors.seed=") + seed, "errors.flexspline.pitch_deviation=0.002"}))
            .twist;
    };
    double const first = twist("1");
    CHECK(twist("1") == first);
    CHECK(twist("2") != first);
}

TEST_CASE("a ring that is eccentric or wobbles is the same drive after half a turn", "[load][errors]")
{
    LoadStudy const& plain = plain_load();
    for (std::string const ring : {"flexspline", "circular_spline"})
        for (auto const& [error, amount] : {std::pair("eccentricity", "=0.004"), std::pair("wobble", "_deg=0.1")}) {
            CAPTURE(ring, error);
            std::string const key = "errors." + ring + "." + error;
            auto const turned = [&key, amount = amount](char const* phase) {
                return load_at_torque(15, {key + amount, key + "_phase_deg=" + phase});
            };
            LoadStudy const one = turned("70"), other = turned("250");
            CHECK(one.sectors == 1);
            check_same_state(only_state(one), only_state(other));
            CHECK(std::abs(only_state(one).largest_force / only_state(plain).largest_force - 1) > 0.01);
        }
}

TEST_CASE("a profile with more material everywhere is a smaller side clearance", "[load][errors]")
{
    std::string const form = "errors.profile_form=[[-0.3, 0.003], [-0.1, 0.003], [0.1, 0.003], [0.2, 0.003]]";
    LoadStudy const thick = load_at_torque(15, {form}),
                    close = load_at_torque(15, {"circular_spline.backlash_offset=0.087"});
    CHECK(thick.sectors == 2);
    // the land is cut at another place of the flank
    CHECK(thick.cases.front().backlash == Approx(close.cases.front().backlash).epsilon(1e-3));
    check_same_state(only_state(thick), only_state(close), 1e-3);
}

TEST_CASE("a slope of the profile is the form of a straight line", "[load][errors]")
{
    // -0.303 and 0.225 mm are the root and the tip
    constexpr double slope = 0.002 / 0.528;
    std::string rows;
    for (double const y : {-0.303, -0.1, 0.05, 0.225})
        rows += (rows.empty() ? "[" : ", ") + ("[" + std::to_string(y) + ", ") + std::to_string(slope * y) + "]";
    LoadStudy const straight = load_at_torque(15, {"errors.profile_slope=0.002"}),
                    form = load_at_torque(15, {"errors.profile_form=" + rows + "]"});
    check_same_state(only_state(straight), only_state(form), 1e-3);
    CHECK(std::abs(only_state(straight).twist / only_state(plain_load()).twist - 1) > 1e-3);
}

TEST_CASE("a form of the profile that is a tip relief does what that does", "[load][errors]")
{
    std::string rows = "[[-0.303, 0], [0.05, 0]";
    for (double y = 0.06; y < 0.23; y += 0.005)
        rows +=
            ", [" + std::to_string(y) + ", " + std::to_string(-0.003 * std::pow((y - 0.05) / (0.225 - 0.05), 2)) + "]";
    check_same_state(only_state(load_at_torque(15, {"errors.profile_form=" + rows + "]"})),
                     only_state(load_at_torque(15, {"tip_relief.amount=0.003", "tip_relief.from_height=0.05"})), 2e-3);
}

}  // namespace hdconj::test::load_error_cases
