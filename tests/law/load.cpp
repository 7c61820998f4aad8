// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of a drive under torque: what must hold whatever the numbers are.
#include "hdconj/pipeline/load.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "hdconj/io/scene_toml.hpp"
#include "hdconj/numeric/error.hpp"
#include "support/catch.hpp"

using namespace hdconj;

namespace {

constexpr double newton_metre = 1e3;

using Keys = std::vector<std::string>;

/// Few enough slices and points that a torque takes a fraction of a second; side clearance as large as the thesis' play.
Scene quick(Keys const& more = {})
{
    Keys keys{"slices.count=3", "contact.flank_points=80", "circular_spline.backlash_offset=0.09", "bearing.circles=5"};
    keys.insert(keys.end(), more.begin(), more.end());
    return builtin_scene(keys);
}

LoadOptions at_torque(double torque)
{
    LoadOptions options;
    options.torque = torque;
    options.curve = false;
    return options;
}

LoadedState const& only(LoadStudy const& study)
{
    return study.cases.front().curve.front();
}

}  // namespace

TEST_CASE("torque the other way round loads the other flanks alike", "[load]")
{
    LoadStudy const forth = load(quick(), at_torque(20 * newton_metre));
    LoadStudy const back = load(quick(), at_torque(-20 * newton_metre));
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
        for (std::size_t k = 0; k < m.z.size(); ++k)
        {
            // the space at -angle, of the sector that repeats
            double const mirrored = -m.angle[s];
            double const pitch = m.angle[1] - m.angle[0];
            auto const i = static_cast<std::size_t>(std::lround((mirrored - n.angle.front()) / pitch) + static_cast<long>(spaces)) % spaces;
            CHECK(n.force[n.index(i, 0, k)] == Approx(m.force[m.index(s, 1, k)]).margin(1e-3 * largest));
        }
}

TEST_CASE("a torque that goes to zero leaves the play, and grows the twist", "[load]")
{
    double last = 0;
    for (double torque : {1e-3, 1.0, 10.0, 28.0})
    {
        LoadStudy const study = load(quick(), at_torque(torque * newton_metre));
        double const half = study.cases.front().backlash / 2;
        CHECK(half > 0);
        CHECK(only(study).twist > half);
        CHECK(only(study).twist > last);
        if (torque < 1e-2)
            CHECK(only(study).twist == Approx(half).epsilon(1e-2));
        last = only(study).twist;
        CHECK(only(study).residual < 1e-6);
        CHECK(only(study).complementarity < 1e-10);
        CHECK(only(study).stiffness > 0);
    }
    LoadStudy const none = load(quick(), at_torque(0));
    CHECK(only(none).twist == 0);
    CHECK(only(none).teeth == 0);
    CHECK(only(none).largest_pressure == 0);
}

TEST_CASE("the wave generator's torque does the work of the drive's", "[load]")
{
    // Turning the wave generator by a turns the circular spline by a (z_c - z_f)/z_c: without friction the mean over a pitch is T times that.
    constexpr double torque = 28 * newton_metre;
    double mean = 0;
    constexpr int angles = 4;
    double const pitch_deg = 360.0 / 202 * 202 / 2 / 101;  // after which the same teeth come again
    for (int i = 0; i < angles; ++i)
    {
        Scene const scene = quick({"contact.wave_generator_angle_deg=" + std::to_string(pitch_deg * i / angles)});
        mean += only(load(scene, at_torque(torque))).wave_generator_torque / angles;
    }
    CHECK(mean == Approx(torque / 101).epsilon(0.05));
}

TEST_CASE("a drive under torque has the same bits for any number of threads", "[load]")
{
    LoadStudy const one = load(quick({"solver.threads=1"}), at_torque(15 * newton_metre));
    for (int threads : {2, 3})
    {
        LoadStudy const more = load(quick({"solver.threads=" + std::to_string(threads)}), at_torque(15 * newton_metre));
        CHECK(only(one).twist == only(more).twist);
        CHECK(only(one).largest_pressure == only(more).largest_pressure);
        CHECK(one.cases.front().map.force == more.cases.front().map.force);
        CHECK(one.shape.stress == more.shape.stress);
        CHECK(one.cup.coning_major == more.cup.coning_major);
    }
}

TEST_CASE("only the verb load enters the stages of a load", "[load]")
{
    std::map<Stage, int> count;
    (void)solve(builtin_scene(), [&](Stage stage) { ++count[stage]; });
    CHECK(count[Stage::cup] + count[Stage::influence] + count[Stage::assembly] + count[Stage::load] == 0);
    (void)load(quick(), at_torque(newton_metre), [&](Stage stage) { ++count[stage]; });
    CHECK(count[Stage::influence] == 1);
    CHECK(count[Stage::assembly] == 1);
    CHECK(count[Stage::load] == 1);
}

TEST_CASE("more than the teeth can carry is said", "[load]")
{
    // a torque that lifts the teeth over each other, or presses them flat: an error that names the torque, or a state in balance
    try
    {
        LoadedState const state = only(load(quick(), at_torque(1e5 * newton_metre)));
        CHECK(std::isfinite(state.twist));
        CHECK(state.residual < 1e-6);
    }
    catch (NumericalError const& error)
    {
        CHECK(std::string(error.what()).find("N m") != std::string::npos);
    }
}
