// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The whole of `solve`, without process start and files: time against tolerance, threads and motion model.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"

namespace {

using namespace hdconj;

void run(benchmark::State& state, Scene const& scene)
{
    std::size_t points = 0;
    std::size_t contacts = 0;
    for (auto _ : state) {
        Solution const solution = solve(scene);
        points = solution.circular_spline.outline.front().size();
        contacts = solution.work.envelope_points;
        benchmark::DoNotOptimize(points);
    }
    state.counters["points"] = static_cast<double>(points);
    state.counters["contacts"] = static_cast<double>(contacts);
}

/// state.range(0): digits of the tolerance; range(1): threads.
void type_50(benchmark::State& state)
{
    run(state, builtin_scene({"solver.tolerance=1e-" + std::to_string(state.range(0)),
                              "solver.threads=" + std::to_string(state.range(1))}));
}
BENCHMARK(type_50)->ArgsProduct({{3, 4, 5, 6, 7, 8, 9, 10}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

void type_50_first_order(benchmark::State& state)
{
    run(state, builtin_scene({"solver.kinematics=first-order", "solver.threads=1"}));
}
BENCHMARK(type_50_first_order)->Unit(benchmark::kMillisecond);

void type_50_material(benchmark::State& state)
{
    run(state, builtin_scene({"solver.kinematics=material", "solver.threads=1"}));
}
BENCHMARK(type_50_material)->Unit(benchmark::kMillisecond);

/// The case that the fastest public peer solves for 19 points.
void liu(benchmark::State& state)
{
    std::string const file = std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/liu-2025.toml";
    run(state, read_scene(file, {"solver.tolerance=1e-" + std::to_string(state.range(0))}));
}
BENCHMARK(liu)->Arg(6)->Arg(7)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
