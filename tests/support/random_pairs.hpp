// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What seeded random drives have in common, whichever tooth is given: the pair around the tooth, and what makes a
/// drawn tooth a tooth.
#pragma once

#include <cmath>

#include "draws.hpp"
#include "hdconj/scene.hpp"
#include "support/oracle/motion.hpp"
#include "support/oracle/tooth.hpp"

namespace designs {

using hdconj::Scene;

/// Teeth, module, a cosine cam and a wall for @p scene; returns the cam's radial deformation.
inline double draw_pair(Draws& draws, Scene& scene)
{
    double const m = scene.drive.module = std::exp(draws.between(std::log(0.1), std::log(2.0)));
    int const n = scene.wave_generator.waves = draws.chance(0.6) ? 2 : draws.chance(0.5) ? 1 : 3;
    int const difference = draws.chance(0.7) ? n : 2 * n;
    scene.drive.flexspline_teeth = draws.whole(60, 320);
    scene.drive.circular_spline_teeth = scene.drive.flexspline_teeth + difference;
    // The pitch lines roll at the major axis when w0 = m (z_c - z_f) / 2.
    double const rolling = m * difference / 2;
    double const w0 = draws.chance(0.1) ? rolling : rolling * draws.between(0.7, 1.15);
    scene.wave_generator.shape.family = "cosine";
    scene.wave_generator.shape.given["radial_deformation"] = {w0, 0};
    scene.flexspline.wall = m * draws.between(0.5, 3);
    return w0;
}

/// What a drive may have or not: another neutral layer, another inner radius of a flexspline whose teeth have that @p
/// dedendum, side clearance.
inline void draw_options(Draws& draws, Scene& scene, double dedendum)
{
    double const m = scene.drive.module;
    if (draws.chance(0.3))
        scene.flexspline.neutral_offset = scene.flexspline.wall * draws.between(-0.2, 0.3);
    if (draws.chance(0.2))
        scene.flexspline.inner_radius =
            m * scene.drive.flexspline_teeth / 2 - dedendum - scene.flexspline.wall + m * draws.between(-0.1, 0.1);
    if (draws.chance(0.25))
        scene.circular_spline.backlash_offset = m * draws.between(0, 0.03);
}

/// Whether every piece of @p tooth goes up and, above the root, gets thinner, and the tooth fits into its pitch.
inline bool is_upright(oracle::Tooth<double> const& tooth, double module)
{
    for (auto const& piece : tooth.flank) {
        bool const flat = piece.name == "tip";
        if (piece.curve && !piece.curve->rises())
            return false;
        if (piece.name == "radial")
            continue;
        if (!(piece.lower.x - piece.upper.x > (flat ? 0.03 : 1e-3) * module))
            return false;
        if (!flat && !(piece.upper.y - piece.lower.y > 1e-3 * module))
            return false;
    }
    auto const& foot = tooth.flank.front();
    if (foot.arc && !(foot.at(0.0).y > foot.centre.y - 0.97 * foot.radius))
        return false;
    return !(tooth.root().x > 0.49 * oracle::pi<double>() * module);
}

/// The neutral curve is not bent inwards, nor nearly so.
inline bool is_gently_bent(oracle::Motion<double> const& motion)
{
    double const n = motion.waves;
    return !(motion.w0 * (n * n + 1) > 0.5 * motion.r_m);
}

}  // namespace designs
