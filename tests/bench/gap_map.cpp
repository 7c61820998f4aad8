// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The gap map of a whole ring: linear in slices, teeth and points, and what threads give.
#include <benchmark/benchmark.h>

#include <numbers>
#include <string>

#include "hdconj/contact/gap_field.hpp"
#include "hdconj/io/scene_toml.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/parameter_at.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "support/type50.hpp"

namespace {

using namespace hdconj;
using namespace hdconj::test;

/// type-50's own flanks in @p slices equal planes: gaps cost the same wherever the teeth are.
struct Ring
{
    Ring(int slices, int points)
    {
        Solution const solution = solve(builtin_scene());
        CircularSplineOutline const& spline = solution.circular_spline;
        grid.z.assign(static_cast<std::size_t>(slices), 0.0);
        grid.station.assign(static_cast<std::size_t>(points), 0.0);
        auto const& line = spline.outline.front();
        auto const between = [&](int from, int to, int i) { return line[static_cast<std::size_t>(from + (to - from) * i / (points - 1))]; };
        for (std::size_t flank = 0; flank < 2; ++flank)
        {
            std::vector<Vec2> row;
            for (int i = 0; i < points; ++i)
                row.push_back(flank == 0 ? between(spline.landmarks[0], spline.landmarks[1], i) : between(spline.landmarks[4], spline.landmarks[3], i));
            grid.point[flank].assign(grid.z.size(), row);
            grid.normal[flank] = grid.point[flank];
        }
        auto const [first, last] = teeth_needed(type50_z_f, type50_z_c, 0);
        places.first = first;
        places.slices = grid.z.size();
        for (int i = first; i <= last; ++i)
        {
            Pose const pose = motion.pose(parameter_at(motion, 2 * std::numbers::pi * i / type50_z_f));
            places.pose.insert(places.pose.end(), grid.z.size(), pose);
        }
    }

    Exact motion = type50_motion();
    Profile tooth = type50_tooth();
    FlankGrid grid;
    ToothPlaces places;
};

void gap_map(benchmark::State& state)
{
    Ring const ring(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    GapField const field(ring.tooth, ring.grid, ring.places, type50_z_f, type50_z_c, 0);
    std::size_t gaps = 0;
    for (auto _ : state)
    {
        GapMap const map = field.map(0, static_cast<int>(state.range(2)));
        gaps = map.gap.size();
        benchmark::DoNotOptimize(map.gap.data());
    }
    state.counters["gaps"] = static_cast<double>(gaps);
    state.counters["gaps/s"] = benchmark::Counter(static_cast<double>(gaps), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(gap_map)->ArgNames({"slices", "points", "threads"})->Args({1, 200, 1})->Args({4, 200, 1})->Args({17, 200, 1})->Args({68, 200, 1})->Args({17, 50, 1})->Args({17, 800, 1})->Args({17, 200, 2})->UseRealTime()->Unit(benchmark::kMillisecond);
