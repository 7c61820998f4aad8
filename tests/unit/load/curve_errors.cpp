// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Errors of figures of a torque-twist curve, and of numbers of teeth.
#include <cmath>
#include <vector>

#include "load/grids/grid_error.hpp"
#include "load/study/catalogue_figures.hpp"
#include "support/catch.hpp"

namespace hdconj::test::curve_error_cases {

using Counts = std::vector<int>;

TEST_CASE("a number of teeth is known to one tooth of each sector, and to twice what grids differ", "[load]")
{
    CHECK(load::count_error(54, Counts{54, 54}, 2, 4) == 2);
    CHECK(load::count_error(54, Counts{54}, 1, 4) == 1);
    CHECK(load::count_error(54, Counts{46, 42}, 2, 4) == 16);
    // two grids that agree by chance
    CHECK(load::count_error(54, Counts{54, 44}, 2, 4) == 10);
    CHECK(load::count_error(54, Counts{54, 45}, 1, 4) == 10);
    // nothing touches on any grid
    CHECK(load::count_error(0, Counts{0, 0}, 2, 4) == 0);
    CHECK(load::count_error(0, Counts{2, 0}, 2, 4) == 4);
    // below nine slices the safety is three times as large
    CHECK(load::count_error(52, Counts{48}, 2, load::grid_safety(5)) == 24);
}

TEST_CASE("backlash is known no better than the wall, also where first touches of grids agree", "[load]")
{
    constexpr double width = 2e-3, radius = 25, wall = 1e-4, safety = 4;
    std::vector<double> const same{width, width}, other{1.9e-3, width};
    double const by_wall = load::backlash_error(width, same, wall, radius, safety);
    CHECK(by_wall == Approx(1.6 * wall / radius));  // two flanks of 39 degrees
    CHECK(load::backlash_error(width, same, 3 * wall, radius, safety) == Approx(3 * by_wall));
    CHECK(load::backlash_error(width, other, wall, radius, safety) == Approx(0.8 * safety * 1e-4));
    CHECK(load::backlash_error(-width, std::vector<double>{-1.9e-3}, wall, radius, safety) ==
          Approx(3.8 * safety * 1e-4));
}

namespace {

/// A drive that stiffens smoothly, at so many even torques.
/// @param soft   twist that it is softer by [rad]
/// @param scale  torque over which it stiffens [N mm]
load::CurveBranches smooth_curve(int torques, double soft, double scale)
{
    constexpr double rated = 28e3, stiff = 3e6;
    load::CurveBranches curve{.forth = {}, .back = {}, .free = 1e-3};
    for (int i = 1; i <= torques; ++i) {
        LoadedState state;
        state.torque = rated * i / torques;
        state.twist = curve.free + state.torque / stiff + soft * (1 - std::exp(-state.torque / scale));
        curve.forth.push_back(state);
    }
    return curve;
}

}  // namespace

TEST_CASE("the errors of two lines through a curve hold what more torques change", "[load]")
{
    constexpr double StiffnessStages::*pairs[][2] = {
        {&StiffnessStages::first, &StiffnessStages::first_error},
        {&StiffnessStages::second, &StiffnessStages::second_error},
        {&StiffnessStages::knee, &StiffnessStages::knee_error},
        {&StiffnessStages::knee_twist, &StiffnessStages::knee_twist_error}};
    for (double const soft : {0.001, 0.004, 0.01})
        for (double const scale : {2e3, 5e3, 10e3}) {
            StiffnessStages const exact = load::stages_of(smooth_curve(1600, soft, scale), {}, 4);
            REQUIRE(exact.found);
            CHECK(exact.first_error == 0);
            for (int const torques : {6, 7, 8, 10, 13, 16, 25, 40, 60}) {
                CAPTURE(soft, scale, torques);
                load::CurveBranches const curve = smooth_curve(torques, soft, scale);
                // the coarser grids have the same curve: nothing is left but the torques
                StiffnessStages const found = load::stages_of(curve, {curve, curve}, 4);
                for (auto const& [figure, error] : pairs)
                    CHECK(std::abs(found.*figure - exact.*figure) <= found.*error);
                if (torques >= 60)
                    CHECK(found.first_error < 0.02 * found.first);
            }
        }
}

TEST_CASE("where grids differ in the first line, the second one is known to a third of that", "[load]")
{
    load::CurveBranches const fine = smooth_curve(40, 0.004, 2e3);
    load::CurveBranches soft = fine;
    for (LoadedState& state : soft.forth)
        state.twist += 0.001 * (1 - std::exp(-state.torque / 1e3));
    StiffnessStages const found = load::stages_of(fine, {soft, soft}, 4);
    double const first = found.first_error / found.first, second = found.second_error / found.second;
    CHECK(first > 0.1);
    CHECK(second >= first / 3 * (1 - 1e-12));
    CHECK(second < 0.9 * first);
}

}  // namespace hdconj::test::curve_error_cases
