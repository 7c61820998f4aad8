// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Single steps: rates, pose, one envelope point, tracing, the arrangement, one full-turn check.
#include <benchmark/benchmark.h>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/distance/full_turn.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "support/type50.hpp"

namespace {

using namespace hdconj;
using namespace hdconj::test;

struct Drive
{
    profile::Profile tooth = type50_tooth();
    Exact motion = type50_motion();
    envelope::Envelope<Exact> envelope{tooth, motion, 0};
};

/// Calls @p step at angles that follow each other closely, as tracing does.
template <class Step>
void at_angles(benchmark::State& state, double apart, Step step)
{
    double u = 0.1;
    for (auto _ : state) {
        benchmark::DoNotOptimize(step(u));
        u += apart;
    }
}

void rates(benchmark::State& state)
{
    Exact const motion = type50_motion();
    at_angles(state, 1e-6, [&](double u) { return motion.rates(u); });
}
BENCHMARK(rates);

void pose(benchmark::State& state)
{
    Exact const motion = type50_motion();
    at_angles(state, 1e-6, [&](double u) { return motion.pose(u); });
}
BENCHMARK(pose);

void envelope_point_on_arc(benchmark::State& state)
{
    Drive const drive;
    envelope::ContactArc arc;
    arc.piece = 7;
    arc.candidate = 1;
    at_angles(state, 1e-7, [&](double u) { return drive.envelope.point(arc, u); });
}
BENCHMARK(envelope_point_on_arc);

void trace_all_branches(benchmark::State& state)
{
    Drive const drive;
    for (auto _ : state)
        benchmark::DoNotOptimize(envelope::find_branches(drive.envelope, 1));
}
BENCHMARK(trace_all_branches)->Unit(benchmark::kMicrosecond);

void tooth_space(benchmark::State& state)
{
    Drive const drive;
    std::vector<envelope::ContactArc> arcs;
    for (envelope::Branch const& branch : envelope::find_branches(drive.envelope, 1).branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    for (auto _ : state)
        benchmark::DoNotOptimize(
            conjugate::ToothSpaceFinder<Exact>(drive.envelope, arcs, 25.025, type50_z_c, {1e-6, 26}, 1e-4)());
}
BENCHMARK(tooth_space)->Unit(benchmark::kMicrosecond);

void full_turn_of_one_point(benchmark::State& state)
{
    Drive const drive;
    distance::FullTurnClearance<Exact> const clearance(drive.tooth, drive.motion, 2 * std::numbers::pi / type50_z_c, 1);
    Vec2 const p{0.2212, 25.1266};
    for (auto _ : state)
        benchmark::DoNotOptimize(clearance(p));
}
BENCHMARK(full_turn_of_one_point)->Unit(benchmark::kMicrosecond);

}  // namespace
