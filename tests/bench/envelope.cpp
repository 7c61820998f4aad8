// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Single steps: rates, pose, one envelope point, tracing, the arrangement, one full-turn check.
#include <benchmark/benchmark.h>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/contact/full_turn.hpp"
#include "support/type50.hpp"

namespace {

using namespace hdconj;
using namespace hdconj::test;

void rates(benchmark::State& state)
{
    Exact const motion = type50_motion();
    double u = 0.1;
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(motion.rates(u));
        u += 1e-6;
    }
}
BENCHMARK(rates);

void pose(benchmark::State& state)
{
    Exact const motion = type50_motion();
    double u = 0.1;
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(motion.pose(u));
        u += 1e-6;
    }
}
BENCHMARK(pose);

void envelope_point_on_arc(benchmark::State& state)
{
    Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    Envelope<Exact> const envelope(tooth, motion, 0);
    ContactArc arc;
    arc.piece = 7;
    arc.candidate = 1;
    double u = 0.1;
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(envelope.point(arc, u));
        u += 1e-7;
    }
}
BENCHMARK(envelope_point_on_arc);

void trace_all_branches(benchmark::State& state)
{
    Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    Envelope<Exact> const envelope(tooth, motion, 0);
    for (auto _ : state)
        benchmark::DoNotOptimize(find_branches(envelope, 1));
}
BENCHMARK(trace_all_branches)->Unit(benchmark::kMicrosecond);

void tooth_space(benchmark::State& state)
{
    Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    Envelope<Exact> const envelope(tooth, motion, 0);
    std::vector<ContactArc> arcs;
    for (Branch const& branch : find_branches(envelope, 1).branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    for (auto _ : state)
        benchmark::DoNotOptimize(ToothSpaceFinder<Exact>(envelope, arcs, 25.025, type50_z_c, {1e-6, 26}, 1e-4)());
}
BENCHMARK(tooth_space)->Unit(benchmark::kMicrosecond);

void full_turn_of_one_point(benchmark::State& state)
{
    Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    FullTurnClearance<Exact> const clearance(tooth, motion, 2 * std::numbers::pi / type50_z_c, 1);
    Vec2 const p{0.2212, 25.1266};
    for (auto _ : state)
        benchmark::DoNotOptimize(clearance(p));
}
BENCHMARK(full_turn_of_one_point)->Unit(benchmark::kMicrosecond);

}  // namespace
