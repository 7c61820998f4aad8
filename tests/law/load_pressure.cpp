// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pressures and forces on edges of a loaded drive, from the contacts alone; and a load without error estimates.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::load_pressure_cases {

namespace {

LoadStudy study(std::vector<std::string> const& more, bool errors = false)
{
    std::vector<std::string> keys{"slices.count=9", "contact.flank_points=80", "bearing.circles=5"};
    keys.insert(keys.end(), more.begin(), more.end());
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.curve = false;
    options.errors = errors;
    return study_load(builtin_scene(keys), options);
}

/// 1/E* of two bodies of 30CrMnSiA [1/MPa]
double const compliance = 2 * (1 - 0.3 * 0.3) / 206000;

struct Pressed
{
    double flank_pressure = 0, edge_force = 0, edge_fraction = 0, largest_pressure = 0;
};

/// From force and half width of each contact: by Hertz, the relative curvature is 4 q/(pi E* a^2) and the pressure
/// 2 q/(pi a). A contact is on an edge where its curvature is at least half that of the edge radius. Slices are at
/// equal distances h > e = 0.5 mm: of a load that is linear between them, the ends hold q_0 (e - e^2/2h) + q_1 e^2/2h.
Pressed pressed(LoadStudy const& of)
{
    constexpr double e = 0.5;
    LoadCase const& each = of.cases.front();
    LoadMap const& map = each.map;
    double const h = map.z[1] - map.z[0], along = e / h, second = 0.5 * e * along;
    REQUIRE(along < 1);
    std::size_t const last = map.z.size() - 1;
    Pressed result;
    std::map<std::pair<int, int>, double> on_edges;
    std::map<std::pair<int, int>, std::vector<double>> off_edges;
    double all = 0, edges = 0;
    for (ContactForce const& c : each.contacts) {
        auto const slice = static_cast<std::size_t>(c.slice), from_end = std::min(slice, last - slice);
        auto const node = map.index(static_cast<std::size_t>(c.space), c.flank, slice);
        double const q = c.force * map.line_load[node] / map.force[node];
        double const curvature = 4 * q * compliance / (std::numbers::pi * c.half_width * c.half_width);
        double const pressure = 2 * q / (std::numbers::pi * c.half_width);
        bool const on_edge = curvature > 0.5 / of.edge_radius;
        result.largest_pressure = std::max(result.largest_pressure, pressure);
        all += c.force;
        double const at_end = q * (from_end == 0 ? e - second : from_end == 1 ? second : 0);
        edges += on_edge ? c.force : at_end;
        on_edges[{c.space, c.flank}] += on_edge ? c.force : at_end;
        auto& off = off_edges[{c.space, c.flank}];
        off.resize(last + 1);
        if (!on_edge)
            off[slice] = std::max(off[slice], pressure);
    }
    for (auto const& [flank, force] : on_edges)
        result.edge_force = std::max(result.edge_force, force);
    for (auto& [flank, pressure] : off_edges) {
        pressure.front() = std::lerp(pressure[0], pressure[1], along);
        pressure.back() = std::lerp(pressure[last], pressure[last - 1], along);
        result.flank_pressure = std::max(result.flank_pressure, *std::ranges::max_element(pressure));
    }
    result.edge_fraction = edges / all;
    return result;
}

}  // namespace

TEST_CASE("edges and ends carry what their contacts carry, and the flank's pressure is that of the others",
          "[load][pressure]")
{
    // both: nearly all on edges of lands, and nearly all on flanks
    auto const [surface, clearance, on_edges] =
        GENERATE(std::tuple("tilted", "0.09", true), std::tuple("per-slice", "0.04", false));
    CAPTURE(surface);
    LoadStudy const solved =
        study({std::string("slices.surface=") + surface, std::string("circular_spline.backlash_offset=") + clearance});
    LoadedState const& state = solved.cases.front().curve.front();
    Pressed const found = pressed(solved);
    constexpr double rounding = 1e-9;  // of sums
    CHECK(state.largest_pressure == Approx(found.largest_pressure).epsilon(rounding));
    CHECK(state.flank_pressure == Approx(found.flank_pressure).epsilon(rounding));
    CHECK(state.edge_force == Approx(found.edge_force).epsilon(rounding));
    CHECK(state.edge_fraction == Approx(found.edge_fraction).epsilon(rounding));
    CHECK((state.edge_fraction > 0.5) == on_edges);
    CHECK(state.edge_force > 0);
    if (!on_edges)
        CHECK(state.flank_pressure > 0);
}

TEST_CASE("what the ends of the face width carry does not depend on where slices stand", "[load][pressure]")
{
    // half a millimetre holds one slice of nine, two of seventeen and two of twenty-one, of which each stands for a
    // different part of the width
    auto const at_ends = [](char const* slices) {
        LoadStudy const solved = study({std::string("slices.count=") + slices, "slices.surface=per-slice",
                                        "circular_spline.backlash_offset=0.04"});
        return solved.cases.front().curve.front();
    };
    LoadedState const coarse = at_ends("9"), fine = at_ends("17"), finest = at_ends("21");
    CHECK(coarse.edge_fraction == Approx(finest.edge_fraction).epsilon(0.06));
    CHECK(fine.edge_fraction == Approx(finest.edge_fraction).epsilon(0.02));
}

TEST_CASE("the largest pressure has an error where it is on a flank, and none on an edge", "[load][pressure]")
{
    std::vector<std::string> relieved{"slices.surface=per-slice", "circular_spline.backlash_offset=0.065",
                                      "end_relief.amount=0.008", "end_relief.length=2"};
    LoadCase const flank = study(relieved, true).cases.front(), edge = study({}, true).cases.front();
    LoadedState const &on_flank = flank.curve.front(), &on_edge = edge.curve.front();
    REQUIRE(on_flank.largest_pressure == on_flank.flank_pressure);
    CHECK(flank.error.largest_pressure == flank.error.flank_pressure);
    REQUIRE(on_edge.largest_pressure > on_edge.flank_pressure);
    CHECK(std::isnan(edge.error.largest_pressure));
    CHECK(edge.error.edge_force > 0);
}

TEST_CASE("the wave generator's torque has an error that reaches its mean over a pitch", "[load][pressure]")
{
    // without friction its work over a pitch is that of the circular spline: (z_c - z_f)/z_c = 1/101 of the torque
    for (char const* const surface : {"tilted", "per-slice"}) {
        CAPTURE(surface);
        LoadCase const found =
            study({std::string("slices.surface=") + surface, "circular_spline.backlash_offset=0.065"}, true)
                .cases.front();
        LoadedState const& state = found.curve.front();
        double const departure = std::abs(state.wave_generator_torque - state.torque / 101);
        REQUIRE(departure > 0);
        CHECK(departure < 0.1 * state.torque / 101);
        CHECK(found.error.wave_generator_torque > departure);
        CHECK(found.error.lobe_force_across * state.wave_generator_torque >
              departure * std::abs(state.lobe_force_across));
    }
}

TEST_CASE("steel that flows lets more teeth carry, at no more than the flow pressure on average", "[load][pressure]")
{
    std::string const clearance = "circular_spline.backlash_offset=0.09";
    LoadStudy const elastic = study({clearance}), soft = study({clearance, "flow.pressure=3000"}, true),
                    softer = study({clearance, "flow.pressure=2000"}), hard = study({clearance, "flow.pressure=1e5"});
    auto const state = [](LoadStudy const& of) -> LoadedState const& { return of.cases.front().curve.front(); };
    // a pressure that is never reached leaves every bit
    CHECK(hard.cases.front().map.force == elastic.cases.front().map.force);
    CHECK(state(hard).flowing_fraction == 0);
    constexpr double peak = 4 / std::numbers::pi;  // of an ellipse, over its mean
    CHECK(state(elastic).largest_pressure > peak * 3000);
    CHECK(state(soft).largest_pressure == Approx(peak * 3000));
    CHECK(state(softer).largest_pressure == Approx(peak * 2000));
    // the error reaches down to the mean
    CHECK(soft.cases.front().error.largest_pressure >= (peak - 1) * 3000);
    // where the mean stays below, the largest pressure is that of elastic steel, above the flow pressure
    double const below = 0.98 * state(elastic).largest_pressure;
    LoadStudy const none = study({clearance, "flow.pressure=" + std::to_string(below)});
    CHECK(state(none).flowing_fraction == 0);
    CHECK(state(none).largest_pressure == state(elastic).largest_pressure);
    CHECK(state(none).flank_pressure == state(elastic).flank_pressure);
    CHECK((none.cases.front().map.pressure == elastic.cases.front().map.pressure));
    CHECK((none.cases.front().map.force == elastic.cases.front().map.force));
    CHECK(state(soft).flowing_fraction > 0);
    CHECK(state(softer).flowing_fraction >= state(soft).flowing_fraction);
    CHECK(state(soft).twist > state(elastic).twist);
    CHECK(state(softer).twist > state(soft).twist);
    CHECK(state(softer).contact_area > state(elastic).contact_area);
    // secants of what is quadratic in the force would take a hundred iterations
    CHECK(state(soft).iterations <= 2 * state(elastic).iterations);
    CHECK(state(softer).iterations <= 2 * state(elastic).iterations);
    for (LoadStudy const* each : {&soft, &softer}) {
        double torque = 0;
        for (ContactForce const& c : each->cases.front().contacts)
            torque += each->sectors * c.lever * c.force;
        CHECK(torque == Approx(state(*each).torque).epsilon(1e-9));
    }
}

TEST_CASE("a load without errors has the same figures, bit for bit", "[load][errors]")
{
    LoadStudy const with = study({"circular_spline.backlash_offset=0.09"}, true),
                    without = study({"circular_spline.backlash_offset=0.09"});
    LoadCase const &a = with.cases.front(), &b = without.cases.front();
    CHECK(a.estimated);
    CHECK_FALSE(b.estimated);
    CHECK(b.curve_error.empty());
    CHECK(with.cup.estimated);
    CHECK_FALSE(without.cup.estimated);
    CHECK(a.map.force == b.map.force);
    CHECK(a.curve.front().twist == b.curve.front().twist);
    CHECK(a.curve.front().largest_stress == b.curve.front().largest_stress);
    CHECK(a.backlash == b.backlash);
    CHECK(b.backlash_error == 0);
}

}  // namespace hdconj::test::load_pressure_cases
