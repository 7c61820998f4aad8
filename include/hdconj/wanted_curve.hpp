// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The second problem: both teeth are given, and the neutral curve that makes them conjugate is wanted. Lengths in mm,
/// angles in rad.
#pragma once

#include <string>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/error.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// The neutral curve at one angle of half a wave.
struct WantedCurveRow
{
    double u = 0;             ///< polar angle from the major axis; the undeformed angle in the first-order motion
    double displacement = 0;  ///< rho - r_m
    double slope = 0;         ///< of rho against u [mm/rad]
    double curvature = 0;     ///< of the neutral curve [1/mm]
    double error = 0;       ///< of the displacement, by what is known of the given flanks; NaN where they do not touch
    bool touching = false;  ///< whether flanks touch here
};

/// Result of find_neutral_curve().
struct WantedCurve
{
    Scene scene;            ///< with both teeth
    Plan plan;              ///< that was run
    PairGeometry geometry;  ///< of the completed drive

    double touch_begin = 0;         ///< angle from which on flanks touch
    double touch_end = 0;           ///< and up to which they touch on the closed curve
    double parting = 0;             ///< up to which they would touch, were the curve not to be closed
    double parting_error = 0;       ///< of it
    double touch_begin_error = 0;   ///< of it
    double touch_end_error = 0;     ///< of it
    std::string ends;               ///< why they part at `parting`, in words
    double major_displacement = 0;  ///< rho(0) - r_m
    double major_error = 0;         ///< of it
    double error = 0;               ///< of the displacement: the largest of the rows where flanks touch
    double growth = 0;              ///< error of the curve there over the error of a flank
    double flank_error = 0;         ///< of the given flanks: solver.tolerance
    double length_error = 0;        ///< length of the closed curve less that of the ring, over a turn
    double residual = 0;            ///< largest gap or overlap of the flanks of the closed curve, where they touch
    double residual_error = 0;      ///< of it
    double least_curvature = 0;     ///< of the closed curve [1/mm]
    double largest_curvature = 0;   ///< of the closed curve [1/mm]
    double curvature_error = 0;     ///< of both [1/mm]
    double bending_stress = 0;      ///< largest in the wall, by bending of the ring alone [MPa]
    double stress_error = 0;        ///< of it [MPa]
    double smallest_clearance = 0;  ///< between both teeth over half a wave; negative: they overlap
    double clearance_error = 0;     ///< of it, as the least of the points and positions evaluated
    double clearance_u = 0;         ///< where
    double inner_distance = 0;      ///< from the neutral curve inward to the surface of the cam

    std::vector<WantedCurveRow> rows;  ///< half a wave, from the major to the minor axis
    std::vector<Vec2> neutral_curve;   ///< (n,2) fixed frame, closed, first point not repeated
    std::vector<Vec2> inner_surface;   ///< (n,2) of the cam: parallel to the neutral curve, point for point
    std::vector<std::string> notes;    ///< what a designer should know, in words
    int threads = 1;                   ///< that were used
    std::vector<StageTime> timing;     ///< in the order in which the stages ran
};

/// Finds the neutral curve rho(u) on which the given flexspline tooth and the given circular-spline tooth touch.
///
/// At each place (rho, gamma) of the tooth one inclination theta lets its right flank touch the right wall of the tooth
/// space: g(rho, gamma, theta) = 0. With theta = gamma - atan(rho'/rho), gamma = u - k phi and r_m phi' = sqrt(rho^2 +
/// rho'^2) that is a differential equation of rho, solved from the major axis on until the flanks part. From there to
/// the minor axis rho is the even polynomial about it that goes on with the same rho, rho', rho'', closes the length
/// and has the least integral of rho'''^2 (docs/explanation/second-problem.md).
///
/// Domain: scenes for which check_wanted_scene() finds no fault. Teeth that touch on the major axis determine the curve
/// alone; others do with wave_generator.major_displacement, and then the even polynomial through the axis that goes on
/// into the solved curve stands between.
/// Accuracy: WantedCurve::error; an error of a flank grows along the curve, by WantedCurve::growth. Curvature, stress
/// and clearance: 1.5 times what flanks moved by their error, either way, change them by; infinite where these have no
/// closed curve.
/// @param scene     both teeth, and a wave generator of the family "wanted"; lengths in mm, angles in rad
/// @param on_stage  called with each stage that begins; null: not called
/// @throws InputError      the scene cannot describe a drive (exit status 2)
/// @throws NumericalError  there is no such curve, with the angle at which flanks stop touching; or it closes with a
///                         hollow
[[nodiscard]] WantedCurve find_neutral_curve(Scene const& scene, StageObserver const& on_stage = {});

}  // namespace hdconj
