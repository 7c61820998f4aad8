// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "conjugate_solver.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/envelope/avoid_stationary_centres.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "reverse_solver.hpp"
#include "solve_motion.hpp"

namespace hdconj::conjugate {

namespace {

/// One turn of the displaced points in the fixed frame.
std::vector<Vec2> displaced_points(wavegen::MaterialDisplacement const& displacement, double r_m)
{
    constexpr int points = 720;
    std::vector<Vec2> result;
    result.reserve(points);
    for (int i = 0; i < points; ++i) {
        double const phi = 2 * std::numbers::pi * i / points;
        auto const [w, v] = wavegen::displacement_at(displacement, phi);
        double const s = std::sin(phi);
        double const c = std::cos(phi);
        result.emplace_back((r_m + w[0]) * s + v[0] * c, (r_m + w[0]) * c - v[0] * s);
    }
    return result;
}

}  // namespace

namespace {

/// @param given  the displacement, once it is asked for
template <class Given>
void solve_displaced(Given&& given, Solution& out, profile::Profile const& tooth, drive::StageClock& clock)
{
    wavegen::MaterialDisplacement displacement;
    // a linear model measures w from the undeformed circle: its mean radius is r_m, its length right to first order
    clock.run(Stage::neutral_curve, [&] {
        displacement = given();
        out.geometry.r_0 = out.geometry.r_m;
        out.neutral_curve = displaced_points(displacement, out.geometry.r_m);
    });
    std::optional<motion::MaterialMotion> motion;
    clock.run(Stage::motion, [&] { motion.emplace(displacement, out.geometry.r_m, tooth_ratio(out.scene)); });
    if (out.scene.is_reverse())
        return solve_reverse(out, tooth, motion::ErasedMotion(*motion), clock);
    profile::Profile const clear = envelope::avoid_stationary_centres(tooth, *motion);
    ConjugateSolver<motion::MaterialMotion>(out, clear, *motion, clock)(tooth);
}

}  // namespace

void solve_material(wavegen::AnyWaveShape const& shape, Solution& out, profile::Profile const& tooth,
                    drive::StageClock& clock)
{
    solve_displaced([&] { return wavegen::inextensional_mode(shape); }, out, tooth, clock);
}

void solve_elastic(Solution& out, profile::Profile const& tooth, drive::StageClock& clock)
{
    solve_displaced([&] { return drive::displacement_at(*out.cup, 0, out.geometry.r_m); }, out, tooth, clock);
}

}  // namespace hdconj::conjugate
