// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a second thread brings to each verb, beside what the machine gives: one thread, two threads, and two jobs side
/// by side on one thread each, by turns in one process. What two processors share with others, memory and each other
/// changes from minute to minute; of the three, each repeat has the same minute.
///
/// hdconj_threads [REPEATS [NAME]]   20 unless told; `load` takes a quarter of them and its curve one. NAME: only jobs
/// whose name has it in it
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "heap.hpp"

namespace {

using namespace hdconj;

double seconds_of(std::function<void()> const& run)
{
    auto const start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Median and least.
struct Times
{
    std::vector<double> all;

    [[nodiscard]] double least() const { return *std::min_element(all.begin(), all.end()); }
    [[nodiscard]] double median() const
    {
        std::vector<double> sorted = all;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

/// Part of the names of the jobs that are asked for.
std::string asked_for;

void measure(std::string const& name, Scene scene, int repeats, std::function<void(Scene const&)> const& job)
{
    if (name.find(asked_for) == std::string::npos)
        return;
    Scene alone = scene;
    alone.solver.threads = 1;
    scene.solver.threads = 2;
    auto const two_jobs = [&] { parallel_for(2, 2, 1, [&](std::size_t) { job(alone); }); };
    std::array<Times, 3> times;
    job(scene);
    for (int repeat = 0; repeat < repeats; ++repeat) {
        times[0].all.push_back(seconds_of([&] { job(alone); }));
        times[1].all.push_back(seconds_of([&] { job(scene); }));
        times[2].all.push_back(seconds_of(two_jobs));
    }
    auto const& [one, two, apart] = times;
    std::printf("| %s | %.2f, %.2f | %.2f | %.2f | %.2f | %.2f |\n", name.c_str(), 1e3 * one.median(),
                1e3 * two.median(), one.median() / two.median(), 2 * one.median() / apart.median(),
                one.least() / two.least(), 2 * one.least() / apart.least());
    std::fflush(stdout);
}

Scene scene_of(std::string const& name, std::vector<std::string> const& overrides = {})
{
    return read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + name, overrides);
}

}  // namespace

int main(int argc, char** argv)
{
    cli::prepare_heap();
    at_thread_start(cli::prepare_heap_of_thread);
    asked_for = argc > 2 ? argv[2] : "";
    int const repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
    std::printf(
        "| | one, two threads [ms], medians | ratio | two jobs side by side | ratio of the least times | of two jobs "
        "|\n|---|---|---|---|---|---|\n");
    for (char const* const tolerance : {"1e-8", "1e-9", "1e-10", "1e-11"})
        measure(std::string("solve, ") + tolerance,
                scene_of("type-50.toml", {std::string("solver.tolerance=") + tolerance}), 2 * repeats,
                [](Scene const& s) { (void)solve(s); });
    measure("contact of the coned type-50, `per-slice`",
            scene_of("type-50-coned.toml", {"slices.surface=\"per-slice\""}), std::max(1, repeats / 2),
            [](Scene const& s) { (void)study_contact(s); });
    Scene const loaded = scene_of("type-50.toml");
    LoadOptions one;
    one.curve = false;
    measure("load, one torque", loaded, std::max(1, repeats / 4), [&](Scene const& s) { (void)study_load(s, one); });
    measure("load, its curve", loaded, std::max(1, repeats / 10), [](Scene const& s) { (void)study_load(s); });
}
