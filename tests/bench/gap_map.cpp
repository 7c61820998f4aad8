// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The gap map of a whole ring: linear in slices, teeth and points, and what threads give.
#include <benchmark/benchmark.h>

#include <numbers>
#include <string>

#include "contact/gap_field.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/parameter_at.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/type50.hpp"

namespace {

using namespace hdconj;
using namespace hdconj::test;

/// type-50's own flanks in @p slices equal planes, among @p teeth: gaps cost the same wherever the teeth are, so any
/// number may stand around it.
struct Ring
{
    Ring(int slices, int points, int teeth = type50_z_f) : z_f(teeth), z_c(teeth + 2)
    {
        Solution const solution = solve(builtin_scene());
        CircularSplineOutline const& spline = solution.circular_spline;
        grid.z.assign(static_cast<std::size_t>(slices), 0.0);
        grid.station.assign(static_cast<std::size_t>(points), 0.0);
        auto const& line = spline.outline.front();
        auto const between = [&](int from, int to, int i) {
            return line[static_cast<std::size_t>(from + (to - from) * i / (points - 1))];
        };
        for (std::size_t flank = 0; flank < 2; ++flank) {
            std::vector<Vec2> row;
            for (int i = 0; i < points; ++i)
                row.push_back(flank == 0 ? between(spline.landmarks[0], spline.landmarks[1], i)
                                         : between(spline.landmarks[4], spline.landmarks[3], i));
            grid.point[flank].assign(grid.z.size(), row);
            grid.normal[flank] = grid.point[flank];
        }
        auto const [first, last] = contact::teeth_needed(z_f, z_c, 0);
        places.first = first;
        places.slices = grid.z.size();
        for (int i = first; i <= last; ++i) {
            Pose const pose = motion.pose(motion::parameter_at(motion, 2 * std::numbers::pi * i / z_f));
            places.pose.insert(places.pose.end(), grid.z.size(), pose);
        }
    }

    int z_f, z_c;
    Exact motion = type50_motion();
    profile::Profile tooth = type50_tooth();
    contact::FlankGrid grid;
    contact::ToothPoses places;
};

void gap_map(benchmark::State& state)
{
    Ring const ring(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    contact::GapField const field(ring.tooth, ring.grid, ring.places, type50_z_f, type50_z_c, 0);
    std::size_t gaps = 0;
    for (auto _ : state) {
        GapMap const map = field.map(0, static_cast<int>(state.range(2)));
        gaps = map.gap.size();
        benchmark::DoNotOptimize(map.gap.data());
    }
    state.counters["gaps"] = static_cast<double>(gaps);
    state.counters["gaps/s"] =
        benchmark::Counter(static_cast<double>(gaps), benchmark::Counter::kIsIterationInvariantRate);
}

/// Growth over four decades, one number at a time, on one thread; the last rows are the fitted slope and its root mean
/// square deviation.
void growth(benchmark::State& state, Ring const& ring)
{
    contact::GapField const field(ring.tooth, ring.grid, ring.places, ring.z_f, ring.z_c, 0);
    for (auto _ : state)
        benchmark::DoNotOptimize(field.map(0, 1).gap.data());
    state.SetComplexityN(state.range(0));
}

void growth_with_slices(benchmark::State& state)
{
    growth(state, Ring(static_cast<int>(state.range(0)), 4, 20));
}

void growth_with_teeth(benchmark::State& state)
{
    growth(state, Ring(1, 20, static_cast<int>(state.range(0))));
}

void growth_with_points(benchmark::State& state)
{
    growth(state, Ring(1, static_cast<int>(state.range(0)), 20));
}

}  // namespace

BENCHMARK(growth_with_slices)
    ->RangeMultiplier(10)
    ->Range(10, 100000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(growth_with_teeth)
    ->RangeMultiplier(10)
    ->Range(10, 100000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(growth_with_points)
    ->RangeMultiplier(10)
    ->Range(10, 100000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(gap_map)
    ->ArgNames({"slices", "points", "threads"})
    ->Args({1, 200, 1})
    ->Args({4, 200, 1})
    ->Args({17, 200, 1})
    ->Args({68, 200, 1})
    ->Args({17, 50, 1})
    ->Args({17, 800, 1})
    ->Args({17, 200, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
