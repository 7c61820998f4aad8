// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of `solve` as a whole: tolerance, motion model, threads.
#include <algorithm>

#include "hdconj/base/parallel.hpp"
#include "hdconj/solve.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

/// One solution of @p scene against the reference, and its times.
void level(StudyBench const& bench, Scene const& scene, StudyRecord record)
{
    Solution const solution = solve(scene);
    constexpr double clearly = 4;
    CurveDifference const difference = bench.reference.compare(outline_of(solution), clearly * scene.solver.tolerance);
    constexpr std::size_t contacts = 400;
    record.error = difference.points;
    record.hausdorff = difference.hausdorff;
    record.estimate = solution.error.chord + solution.error.point;
    bool const own_model = scene.solver.kinematics == bench.drive.scene.solver.kinematics;
    record.normal_speed = own_model ? residual_of(bench.drive, solution, contacts) : not_measured;
    int const found = static_cast<int>(solution.branches.size()), there = static_cast<int>(bench.drive.branches);
    record.branches = found;
    record.missed = std::max(0, there - found) + (own_model ? difference.missed : 0);
    record.extra = std::max(0, found - there);
    record.evaluations = static_cast<double>(solution.work.envelope_points);
    record.points = static_cast<double>(outline_of(solution).size());
    record.threads = solution.threads;
    bench.measure(record, [&] { (void)solve(scene); });
}

void tolerance_series(StudyBench const& bench, std::string const& study, std::string const& method,
                      Kinematics kinematics, int levels)
{
    constexpr int of_quick = 4;
    for (double const tolerance : tolerances_of(bench.drive.scene.drive, bench.quick ? of_quick : levels)) {
        Scene scene = bench.drive.scene;
        scene.solver.kinematics = kinematics;
        scene.solver.tolerance = tolerance;
        level(bench, scene, {study, {}, method, "solver.tolerance", tolerance});
    }
}

/// solve() on so many threads. A point that differs in any bit from that of one thread is an extra one.
StudyRecord on_threads(StudyBench const& bench, Scene const& scene, std::vector<Vec2>& single)
{
    StudyRecord record{"threads", {}, "solve", "solver.threads", static_cast<double>(scene.solver.threads)};
    record.threads = scene.solver.threads;
    Solution const solution = solve(scene);
    auto const& outline = outline_of(solution);
    if (single.empty())
        single = outline;
    CurveDifference const difference = bench.reference.compare(outline, scene.solver.tolerance);
    record.error = difference.points;
    record.hausdorff = difference.hausdorff;
    record.estimate = solution.error.chord + solution.error.point;
    record.branches = static_cast<int>(solution.branches.size());
    record.extra = static_cast<int>(outline.size() != single.size());
    for (std::size_t i = 0; i < std::min(outline.size(), single.size()); ++i)
        record.extra += outline[i] != single[i];
    record.evaluations = static_cast<double>(solution.work.envelope_points);
    record.points = static_cast<double>(outline.size());
    return record;
}

}  // namespace

void study_tolerance(StudyBench const& bench)
{
    constexpr int levels = 9;
    tolerance_series(bench, "tolerance", "solve", bench.drive.scene.solver.kinematics, levels);
}

void study_motion_model(StudyBench const& bench)
{
    constexpr int levels = 5;
    tolerance_series(bench, "motion-model", "exact", Kinematics::exact, levels);
    tolerance_series(bench, "motion-model", "first order", Kinematics::first_order, levels);
    if (!bench.drive.shape.breaks().empty())
        return bench.note(
            "motion-model",
            "material left out: it is a Fourier series, which cannot follow the jumps in the third derivative of this "
            "wave generator's shape");
    tolerance_series(bench, "motion-model", "material", Kinematics::material, levels);
}

void study_threads(StudyBench const& bench)
{
    constexpr int digits = 9, digits_of_quick = 8;  // of coarser ones a second thread takes no part
    Scene scene = bench.drive.scene;
    scene.solver.tolerance = power_of_ten(bench.quick ? digits_of_quick : digits);
    Scene alone = scene;
    alone.solver.threads = 1;
    std::vector<Vec2> single;
    std::vector<StudyRecord> shared;
    for (int threads = 1; threads <= std::max(2, thread_count(0)); threads *= 2) {
        scene.solver.threads = threads;
        shared.push_back(on_threads(bench, scene, single));
    }
    // by turns: what a machine gives changes from minute to minute
    for (int repeat = 0; repeat < bench.repeats; ++repeat)
        for (StudyRecord const& record : shared) {
            scene.solver.threads = record.threads;
            bench.measure_once(record, repeat, [&] { (void)solve(scene); });
            // as many solves at once, each on a thread of its own: nothing is shared but the machine
            StudyRecord apart = record;
            apart.method = "solves side by side";
            bench.measure_once(
                apart, repeat,
                [&] {
                    parallel_for(static_cast<std::size_t>(record.threads), record.threads, 1,
                                 [&](std::size_t) { (void)solve(alone); });
                },
                record.threads);
        }
}

}  // namespace hdconj::accuracy
