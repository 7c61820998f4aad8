// SPDX-License-Identifier: GPL-3.0-or-later
// One loop of plain arithmetic. It is compiled with -fno-math-errno and -fno-trapping-math, which change no value, and
// -ffp-contract=off as everything else: each copy of the loop does the same operations in the same order.
#include "arc_batch.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "envelope/sine_cosine.hpp"
#include "hdconj/error.hpp"

namespace hdconj::envelope {
namespace {

HDCONJ_TARGETS
void points(ArcBatch::Numbers const& given, double const* u, double* x, double* y, std::size_t count)
{
    // copies: nothing that is written may be taken for one of these
    double const w0 = given.w0, waves = given.waves, r_0 = given.r_0, ratio = given.ratio, k = given.ratio / given.r_m;
    double const cx = given.centre_x, cy = given.centre_y, radius = given.radius;
    double const a1 = given.sines[0], a2 = given.sines[1], a3 = given.sines[2], a4 = given.sines[3],
                 a5 = given.sines[4], a6 = given.sines[5], a7 = given.sines[6], a8 = given.sines[7];
    double const slope = -waves * w0, bend = -waves * waves * w0, rest = 1 - ratio;
#ifndef __clang__
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < count; ++i) {
        auto const [sn, cn] = sine_cosine(waves * u[i]);
        double const twice = 2 * cn;
        double const b7 = a7 + twice * a8;
        double const b6 = a6 + twice * b7 - a8;
        double const b5 = a5 + twice * b6 - b7;
        double const b4 = a4 + twice * b5 - b6;
        double const b3 = a3 + twice * b4 - b5;
        double const b2 = a2 + twice * b3 - b4;
        double const b1 = a1 + twice * b2 - b3;
        auto const [sg, cg] = sine_cosine(rest * u[i] - ratio * (b1 * sn));
        double const rho = r_0 + w0 * cn, rho1 = slope * sn, rho2 = bend * cn;
        double const s2 = rho * rho + rho1 * rho1;
        double const s = std::sqrt(s2);
        double const one_by_s = 1 / s;
        double const omega = 1 - k * s - (rho * rho2 - rho1 * rho1) * one_by_s * one_by_s;
        double const vx = omega * cy + (s - k * rho * rho);
        double const vy = k * rho * rho1 - omega * cx;
        double const stretch = radius / std::sqrt(vx * vx + vy * vy);
        double const px = cx - stretch * vy, py = cy + stretch * vx;
        double const ct = rho * one_by_s, st = rho1 * one_by_s;
        double const c = cg * ct + sg * st, d = sg * ct - cg * st;
        x[i] = c * px + d * py + rho * sg;
        y[i] = c * py - d * px + rho * cg;
    }
}

}  // namespace

ArcBatch::ArcBatch(motion::ExactMotion<wavegen::CosineCam> const& motion, double tooth_ratio,
                   profile::ArcPiece const& arc, int side, double offset)
    : numbers_{motion.curve().shape().w0,
               static_cast<double>(motion.curve().shape().n),
               motion.curve().r_0(),
               motion.curve().r_m(),
               tooth_ratio,
               arc.centre.x(),
               arc.centre.y(),
               side * (arc.radius + offset),
               {}}
{
    // phi - u is odd and periodic: its sine sums over equal steps, which converge geometrically
    constexpr int steps = 64;
    double const lobe = 2 * motion.half_lobe();
    for (int j = 1; j < steps / 2; ++j) {
        double sum = 0;
        for (int i = 1; i < steps; ++i) {
            double const u = lobe * (static_cast<double>(i) / steps - 0.5);
            sum += (motion.curve().phi(u) - u) *
                   std::sin(2 * std::numbers::pi * j * (static_cast<double>(i) / steps - 0.5));
        }
        double const amplitude = 2 * sum / steps;
        constexpr double lost = 0x1p-50;
        if (j <= terms)
            numbers_.sines[j - 1] = amplitude;
        else if (std::abs(amplitude) > lost)
            throw NumericalError(ErrorCode::not_converged, "envelope", "arc length",
                                 "needs more harmonics than a batch sums");
    }
}

void ArcBatch::operator()(std::span<double const> u, std::span<double> x, std::span<double> y) const
{
    points(numbers_, u.data(), x.data(), y.data(), u.size());
}

}  // namespace hdconj::envelope
