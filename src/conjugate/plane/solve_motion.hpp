// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `solve` from the neutral curve on, one source file per motion model so that they compile side by side.
#pragma once

#include <numbers>
#include <vector>

#include "drive/stage_clock.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/wavegen/neutral_curve.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::conjugate {

void solve_exact(wavegen::AnyWaveShape const& shape, Solution& out, profile::Profile const& tooth,
                 drive::StageClock& clock);
void solve_first_order(wavegen::AnyWaveShape const& shape, Solution& out, profile::Profile const& tooth,
                       drive::StageClock& clock);
void solve_material(wavegen::AnyWaveShape const& shape, Solution& out, profile::Profile const& tooth,
                    drive::StageClock& clock);
/// With the displacements of the elastic cup at z = 0.
void solve_elastic(Solution& out, profile::Profile const& tooth, drive::StageClock& clock);

/// One turn of the neutral curve rho = r_0 + w in the fixed frame; every point is on the curve.
template <wavegen::WaveShape Shape>
[[nodiscard]] std::vector<Vec2> sampled_neutral_curve(Shape const& shape, double mean_radius)
{
    constexpr int points = 720;
    std::vector<Vec2> result;
    result.reserve(points);
    for (int i = 0; i < points; ++i) {
        double const u = 2 * std::numbers::pi * i / points;
        double const rho = mean_radius + shape(u).w;
        result.emplace_back(rho * std::sin(u), rho * std::cos(u));
    }
    return result;
}

[[nodiscard]] inline double tooth_ratio(Scene const& scene)
{
    return static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
}

}  // namespace hdconj::conjugate
