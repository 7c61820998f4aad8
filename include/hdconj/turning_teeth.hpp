// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The motion of a flexspline tooth through one wave, as a table that another program interpolates.
/// Lengths in mm, angles in rad, clockwise from the major axis.
#pragma once

#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/scene.hpp"

namespace hdconj {

/// Poses of the tooth with the undeformed angle phi_j = j period/steps, in the frame of the wave generator.
///
/// Its origin is at the polar angle phi + advance and at the radius `radius`; its y axis points along phi + lean. All
/// three are periodic. In the frame of its tooth space, whose centre line is at (z_f/z_c) phi, both angles are less by
/// that.
struct TurningTeeth
{
    std::vector<double> z;        ///< (k) planes [mm]
    int steps = 0;                ///< of the table
    double period = 0;            ///< of the motion: 2 pi/n of n waves [rad]
    std::vector<double> radius;   ///< (k,j) of the tooth's origin [mm]
    std::vector<double> advance;  ///< (k,j) polar angle of the origin less phi [rad]
    std::vector<double> lean;     ///< (k,j) angle of the tooth's y axis less phi [rad]
    std::vector<Vec2> tooth;      ///< (n) outline of the tooth, left to right, in its own frame [mm]
    double chord = 0;             ///< largest distance of that polygon from the tooth [mm]
    /// Largest distance of a point of the tooth from its true place where cubics through four neighbouring entries
    /// interpolate the table: found in the middle between the entries [mm].
    double interpolation_error = 0;
};

/// The motion of the flexspline's teeth of @p scene in the planes @p z, which the contact of the scene is computed with
/// (docs/explanation/theory.md, section 1).
///
/// The table is doubled until its interpolation error is below 1e-6 mm, up to 4,096 steps: a wave generator whose
/// curvature jumps needs more than one that is smooth.
/// @param scene     the drive, lengths in mm; domain: no faults, and the neutral curve is given. In the
///                  reverse problem the tooth is the one that is solved for
/// @param z         planes, evenly spaced over the face width [mm]; one plane: z = 0
/// @param on_stage  called with each stage that begins; null: not called
/// @throws NumericalError as solve()
[[nodiscard]] TurningTeeth turning_teeth(Scene const& scene, std::vector<double> const& z,
                                         StageObserver const& on_stage = {});

}  // namespace hdconj
