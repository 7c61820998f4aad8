// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What certification costs: the same roots with proof, and by scans and Newton's method without.
/// The tooth is type-50's right flank as a spline through points, so that every piece is a general curve.
#include <benchmark/benchmark.h>

#include <vector>

#include "hdconj/envelope/find_branches.hpp"
#include "profile/measured_points.hpp"
#include "support/type50.hpp"

namespace {

using namespace hdconj;
using namespace hdconj::test;

/// Cubic pieces through @p count points of the right flank.
std::vector<profile::CurvePiece> flank(int count)
{
    profile::Profile const tooth = type50_tooth();
    std::vector<Vec2> points;
    for (profile::ProfilePiece const& piece : tooth.pieces) {
        auto const* arc = std::get_if<profile::ArcPiece>(&piece.shape);
        if (arc == nullptr || piece.corner || profile::point_at(piece.shape, 0.5).x() < 0)
            continue;
        // the two arcs share their joint
        for (int i = points.empty() ? 0 : 1; i <= count / 2; ++i)
            points.push_back(profile::point_at(piece.shape, 2.0 * i / count));
    }
    return profile::spline_through(points);
}

struct Case
{
    Exact motion = type50_motion();
    double end = motion.half_lobe();
    motion::RatesModel rates = motion::rates_model(motion, -end, end);
    std::vector<profile::CurvePiece> pieces;

    explicit Case(benchmark::State const& state) : pieces(flank(static_cast<int>(state.range(0)))) {}
};

constexpr int instants = 64;

/// Calls @p count with every piece at 64 instants: its contacts then.
template <class Count>
void contacts(benchmark::State& state, Count count)
{
    Case const c(state);
    int found = 0;
    for (auto _ : state) {
        found = 0;
        for (int k = 0; k < instants; ++k) {
            PlanarVelocity const twist = c.motion.rates(-c.end + (2 * k + 1) * c.end / instants).twist;
            for (profile::CurvePiece const& piece : c.pieces)
                found += count(piece, twist);
        }
    }
    state.counters["roots"] = found;
}

/// Proved.
void contacts_certified(benchmark::State& state)
{
    contacts(state, [](profile::CurvePiece const& piece, PlanarVelocity const& twist) {
        return envelope::curve_contacts(piece, twist).count;
    });
}
BENCHMARK(contacts_certified)->Arg(20)->Arg(200)->Unit(benchmark::kMicrosecond);

/// The same by signs at 9 points a piece and bracketing.
void contacts_by_scan(benchmark::State& state)
{
    contacts(state, [](profile::CurvePiece const& piece, PlanarVelocity const& twist) {
        numeric::BernsteinWork f{};
        std::span<double> const coefficients(f.data(), piece.a().size());
        (void)envelope::meshing_polynomial(piece, twist, coefficients);
        auto const value = [&](double t) { return numeric::bernstein_value(coefficients, t); };
        constexpr int steps = 8;
        int found = 0;
        double before = value(0);
        for (int i = 1; i <= steps; ++i) {
            double const now = value(static_cast<double>(i) / steps);
            if ((before < 0) != (now < 0)) {
                benchmark::DoNotOptimize(
                    numeric::bracketed_root(value, (i - 1.0) / steps, static_cast<double>(i) / steps, before, now));
                ++found;
            }
            before = now;
        }
        return found;
    });
}
BENCHMARK(contacts_by_scan)->Arg(20)->Arg(200)->Unit(benchmark::kMicrosecond);

/// Where contacts begin and end, over the lobe, proved: crossings of both ends and merges; the model of the motion
/// included.
void ends_certified(benchmark::State& state)
{
    Case const c(state);
    std::size_t found = 0;
    for (auto _ : state) {
        found = 0;
        motion::RatesModel const rates = motion::rates_model(c.motion, -c.end, c.end);
        envelope::TraceRecord record;
        for (profile::CurvePiece const& piece : c.pieces)
            found +=
                envelope::critical_angles(profile::PieceShape(piece), 0, c.motion, rates, -c.end, c.end, record).size();
    }
    state.counters["ends"] = static_cast<double>(found);
}
BENCHMARK(ends_certified)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMicrosecond);

/// The same by signs at 64 instants for each end, and Newton's method for merges from a grid of 3 by 16 starts.
void ends_by_scan(benchmark::State& state)
{
    Case const c(state);
    std::size_t found = 0;
    for (auto _ : state) {
        found = 0;
        std::vector<motion::MotionRates> rates;
        for (int k = 0; k <= instants; ++k)
            rates.push_back(c.motion.rates(-c.end + 2 * k * c.end / instants));
        for (profile::CurvePiece const& piece : c.pieces) {
            profile::PieceShape const shape(piece);
            for (profile::PieceEnd const& end : {profile::start_of(shape), profile::end_of(shape)}) {
                auto const f = [&](double u) { return end.normal.dot(c.motion.rates(u).twist(end.point)); };
                double before = end.normal.dot(rates[0].twist(end.point));
                for (int k = 1; k <= instants; ++k) {
                    double const now = end.normal.dot(rates[static_cast<std::size_t>(k)].twist(end.point));
                    if ((before < 0) != (now < 0)) {
                        double const b = -c.end + 2 * k * c.end / instants;
                        benchmark::DoNotOptimize(numeric::bracketed_root(f, b - 2 * c.end / instants, b, before, now));
                        ++found;
                    }
                    before = now;
                }
            }
            for (int i = 0; i < 48; ++i) {
                double t = (i % 3 + 0.5) / 3;
                double u = -c.end + (i / 3 + 0.5) * c.end / 8;
                for (int step = 0; step < 12; ++step) {
                    motion::MotionRates const r = c.motion.rates(u);
                    Vec2 const x = piece.point(t), x1 = piece.first(t), x2 = piece.second(t);
                    Vec2 const v = r.twist(x), w = r.change(x);
                    // f = N.v, f_t = N'.v + N.v_t with v_t = theta' (x' turned), N = x' turned
                    Vec2 const n = left_of(x1), n1 = left_of(x2), v1 = r.twist.omega * right_of(x1),
                               w1 = r.change.omega * right_of(x1);
                    double const f = n.dot(v), f_t = n1.dot(v) + n.dot(v1), f_u = n.dot(w),
                                 f_tu = n1.dot(w) + n.dot(w1);
                    double const f_tt = 2 * n1.dot(v1) +
                                        n.dot(r.twist.omega * right_of(x2));  // x''' left out: Newton need not be exact
                    double const determinant = f_t * f_tu - f_u * f_tt;
                    double const dt = (f * f_tu - f_u * f_t) / determinant, du = (f_t * f_t - f * f_tt) / determinant;
                    t -= dt;
                    u -= du;
                    if (!(std::abs(t - 0.5) < 1) || !(std::abs(u) < 1.2 * c.end))
                        break;
                    if (std::abs(dt) + std::abs(du) < 0x1p-40) {
                        found += t > 0 && t < 1 && std::abs(u) < c.end;
                        break;
                    }
                }
            }
        }
    }
    state.counters["ends"] = static_cast<double>(found);
}
BENCHMARK(ends_by_scan)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMicrosecond);

/// All branches of a whole tooth whose flank is a spline.
void trace_spline_tooth(benchmark::State& state)
{
    profile::Profile tooth;
    tooth.segment_names = {"flank"};
    for (profile::CurvePiece& piece : flank(static_cast<int>(state.range(0))))
        tooth.pieces.push_back({std::move(piece), 0, 0, 1, false});
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    std::size_t branches = 0;
    for (auto _ : state)
        branches = envelope::find_branches(envelope, 1).branches.size();
    state.counters["pieces"] = static_cast<double>(tooth.pieces.size());
    state.counters["branches"] = static_cast<double>(branches);
}
BENCHMARK(trace_spline_tooth)->Arg(20)->Arg(200)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
