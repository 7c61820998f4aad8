// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Against the limits: envelope points as the program makes them, as bare arithmetic with no logic, many at once, and
/// what reading and writing the numbers alone costs. Lines, arcs and curves; exact and first order; offset; certified
/// roots; HDF5; whole verbs.
#include <benchmark/benchmark.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/contact_files.hpp"
#include "hdconj/envelope/contact_batch.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "profile/measured_points.hpp"
#include "support/arc_batch.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

namespace {

using namespace hdconj;
using namespace hdconj::test;

constexpr int many = 4096;

/// A contact arc on a piece of shape @p Shape, and positions along it.
template <class Shape, class Motion>
struct Sweep
{
    Sweep(profile::Profile const& profile, Motion const& moved, double offset)
        : tooth(profile), motion(moved), envelope(tooth, motion, offset)
    {
        double longest = 0;
        for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
            for (envelope::ContactArc const& each : branch.arcs)
                if (!branch.corner &&
                    std::holds_alternative<Shape>(tooth.pieces[static_cast<std::size_t>(each.piece)].shape) &&
                    each.u_end - each.u_begin > longest) {
                    longest = each.u_end - each.u_begin;
                    arc = each;
                }
        for (int i = 0; i < many; ++i)
            u.push_back(arc.u_begin + (arc.u_end - arc.u_begin) * (i + 0.5) / many);
    }

    profile::Profile tooth;
    Motion motion;
    envelope::Envelope<Motion> envelope;
    envelope::ContactArc arc;
    std::vector<double> u;
};

template <class Made>
void run(benchmark::State& state, Made const& sweep)
{
    for (auto _ : state) {
        double sum = 0;
        for (double const at : sweep.u)
            sum += sweep.envelope.point(sweep.arc, at).p.x();
        benchmark::DoNotOptimize(sum);
    }
    state.counters["per_point"] = benchmark::Counter(
        static_cast<double>(many), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// type-50's right flank as a cubic spline.
profile::Profile spline_tooth()
{
    profile::Profile const arcs = type50_tooth();
    std::vector<Vec2> points;
    for (profile::ProfilePiece const& piece : arcs.pieces)
        if (std::holds_alternative<profile::ArcPiece>(piece.shape) && !piece.corner &&
            profile::point_at(piece.shape, 0.5).x() > 0)
            for (int i = points.empty() ? 0 : 1; i <= 10; ++i)
                points.push_back(profile::point_at(piece.shape, i / 10.0));
    profile::Profile tooth;
    tooth.segment_names = {"flank"};
    for (profile::CurvePiece& piece : profile::spline_through(points))
        tooth.pieces.push_back({std::move(piece), 0, 0, 1, false});
    return tooth;
}

void point_on_arc_exact(benchmark::State& state)
{
    run(state, Sweep<profile::ArcPiece, Exact>(type50_tooth(), type50_motion(), 0));
}
void point_on_arc_exact_offset(benchmark::State& state)
{
    run(state, Sweep<profile::ArcPiece, Exact>(type50_tooth(), type50_motion(), 0.004));
}
void point_on_arc_first_order(benchmark::State& state)
{
    run(state, Sweep<profile::ArcPiece, FirstOrder>(type50_tooth(), type50_first_order(), 0));
}
void point_on_line_exact(benchmark::State& state)
{
    run(state, Sweep<profile::LinePiece, Exact>(type50_tooth(), type50_motion(), 0));
}
void point_on_line_first_order(benchmark::State& state)
{
    run(state, Sweep<profile::LinePiece, FirstOrder>(type50_tooth(), type50_first_order(), 0));
}
void point_on_curve_exact(benchmark::State& state)
{
    run(state, Sweep<profile::CurvePiece, Exact>(spline_tooth(), type50_motion(), 0));
}
void point_on_curve_first_order(benchmark::State& state)
{
    run(state, Sweep<profile::CurvePiece, FirstOrder>(spline_tooth(), type50_first_order(), 0));
}
BENCHMARK(point_on_arc_exact)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_arc_exact_offset)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_arc_first_order)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_line_exact)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_line_first_order)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_curve_exact)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_curve_first_order)->Unit(benchmark::kMicrosecond);

/// The same operations as a point on an arc needs, and no logic: rates, closed form, pose.
void arithmetic_alone(benchmark::State& state)
{
    Sweep<profile::ArcPiece, Exact> const sweep(type50_tooth(), type50_motion(), 0);
    profile::ArcPiece const arc =
        std::get<profile::ArcPiece>(sweep.tooth.pieces[static_cast<std::size_t>(sweep.arc.piece)].shape);
    for (auto _ : state) {
        double sum = 0;
        for (double const at : sweep.u) {
            PlanarVelocity const twist = sweep.motion.rates(at).twist;
            Vec2 const v = twist(arc.centre);
            sum += sweep.motion.pose(at)(arc.centre + sweep.arc.candidate * arc.radius / v.norm() * left_of(v)).x();
        }
        benchmark::DoNotOptimize(sum);
    }
    state.counters["per_point"] = benchmark::Counter(
        static_cast<double>(many), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(arithmetic_alone)->Unit(benchmark::kMicrosecond);

/// Many at once.
void arc_batch(benchmark::State& state)
{
    Sweep<profile::ArcPiece, Exact> const sweep(type50_tooth(), type50_motion(), 0);
    envelope::ArcBatch const batch(
        sweep.motion, type50_ratio,
        std::get<profile::ArcPiece>(sweep.tooth.pieces[static_cast<std::size_t>(sweep.arc.piece)].shape),
        sweep.arc.candidate, 0);
    std::vector<double> x(many), y(many);
    for (auto _ : state) {
        batch(sweep.u, x, y);
        benchmark::DoNotOptimize(x.data());
        benchmark::DoNotOptimize(y.data());
        benchmark::ClobberMemory();
    }
    state.counters["per_point"] = benchmark::Counter(
        static_cast<double>(many), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(arc_batch)->Unit(benchmark::kMicrosecond);

/// Many at once, with normal, parameter and error estimate: what `solve` samples with.
void contact_batch_points(benchmark::State& state)
{
    Sweep<profile::ArcPiece, Exact> const sweep(type50_tooth(), type50_motion(), 0);
    auto const batch = envelope::contact_batch(sweep.envelope, sweep.arc);
    std::vector<envelope::EnvelopePoint> points(many);
    for (auto _ : state) {
        envelope::point_batch(sweep.envelope, sweep.arc, *batch, sweep.u, points);
        benchmark::DoNotOptimize(points.data());
        benchmark::ClobberMemory();
    }
    state.counters["per_point"] = benchmark::Counter(
        static_cast<double>(many), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(contact_batch_points)->Unit(benchmark::kMicrosecond);

/// What it costs to read u and write x and y, from and to main memory.
void memory_traffic_alone(benchmark::State& state)
{
    constexpr std::size_t large = std::size_t{1} << 22;
    std::vector<double> const u(large, 1);
    std::vector<double> x(large), y(large);
    for (auto _ : state) {
        std::memcpy(x.data(), u.data(), large * sizeof(double));
        std::memcpy(y.data(), u.data(), large * sizeof(double));
        benchmark::ClobberMemory();
    }
    state.counters["per_point"] = benchmark::Counter(
        static_cast<double>(large), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(memory_traffic_alone)->Unit(benchmark::kMillisecond);

/// All certified roots of all polynomial pieces at one position.
void certified_roots_of_flank(benchmark::State& state)
{
    profile::Profile const tooth = spline_tooth();
    Exact const motion = type50_motion();
    std::vector<PlanarVelocity> twists;
    for (int i = 0; i < 256; ++i)
        twists.push_back(motion.rates(motion.half_lobe() * ((i + 0.5) / 128 - 1)).twist);
    int roots = 0;
    for (auto _ : state) {
        roots = 0;
        for (PlanarVelocity const& twist : twists)
            for (profile::ProfilePiece const& piece : tooth.pieces)
                roots += envelope::curve_contacts(std::get<profile::CurvePiece>(piece.shape), twist).count;
        benchmark::DoNotOptimize(roots);
    }
    state.counters["roots"] = roots;
    state.counters["per_position"] =
        benchmark::Counter(256.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["per_piece"] =
        benchmark::Counter(256.0 * static_cast<double>(tooth.pieces.size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(certified_roots_of_flank)->Unit(benchmark::kMicrosecond);

/// The result file of a solution, range(0) digits of tolerance.
void hdf5_write(benchmark::State& state)
{
    TemporaryFolder const folder;
    Scene scene = builtin_scene();
    scene.solver.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
    Solution const solution = solve(scene);
    for (auto _ : state)
        write_hdf5(solution, folder / "result.h5");
    state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(folder / "result.h5"));
}
BENCHMARK(hdf5_write)->Arg(6)->Arg(8)->Arg(10)->Unit(benchmark::kMillisecond);

void whole_contact(benchmark::State& state)
{
    Scene const scene = read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50-coned.toml");
    for (auto _ : state)
        benchmark::DoNotOptimize(study_contact(scene).cases.size());
}
BENCHMARK(whole_contact)->Unit(benchmark::kMillisecond);

/// Points along a flank over four decades: linear.
void points_of_a_flank(benchmark::State& state)
{
    Sweep<profile::ArcPiece, Exact> const sweep(type50_tooth(), type50_motion(), 0);
    auto const count = state.range(0);
    for (auto _ : state) {
        double sum = 0;
        for (long i = 0; i < count; ++i)
            sum += sweep.envelope
                       .point(sweep.arc, sweep.arc.u_begin + (sweep.arc.u_end - sweep.arc.u_begin) *
                                                                 (static_cast<double>(i) + 0.5) /
                                                                 static_cast<double>(count))
                       .p.x();
        benchmark::DoNotOptimize(sum);
    }
    state.SetComplexityN(count);
}
BENCHMARK(points_of_a_flank)
    ->RangeMultiplier(10)
    ->Range(10, 100000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
