// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The cup on its wave generator, and bent by the teeth.
#pragma once

#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj {

/// The cup in the section plane with its harmonics summed at the angles that are drawn.
struct CupShape
{
    std::vector<double> r;                ///< (p) radii of the nodes of the section [mm]
    std::vector<double> z;                ///< (p) their heights above the middle of the bearing [mm]
    std::vector<std::vector<int>> cells;  ///< corner nodes of each element, counter-clockwise
    std::vector<double> phi;              ///< (a) angles [rad]
    std::vector<double> u_r;              ///< (a,p) radial displacement at the largest torque of that case [mm]
    std::vector<double> u_t;              ///< (a,p) tangential displacement [mm]
    std::vector<double> u_z;              ///< (a,p) axial displacement [mm]
    std::vector<double> stress;           ///< (a,p) von Mises [MPa]; empty: not computed
    std::vector<int> seat;                ///< nodes at the bearing, whose stress is not determined
};

/// The teeth of the flexspline on the cup that torque bends and turns, in the planes of the slices.
///
/// In the frame of the wave generator, where y is the major axis and angles run clockwise, tooth i has its origin at
/// `origin`, and its y axis points along `lean`. The tooth space that meshes with the undeformed angle phi has its
/// centre line at (z_f/z_c) phi, turned back by `turn`. Teeth are rigid here: at a contact they enter the flank by what
/// flank and tooth yield.
struct LoadedTeeth
{
    double turn = 0;           ///< of the circular spline, counter-clockwise [rad]
    std::vector<double> z;     ///< (k) [mm]
    std::vector<double> phi;   ///< (i) undeformed angles, increasing, each tooth once [rad]; empty: the scene has
                               ///< errors of the rings, by which each tooth and space stands elsewhere
    std::vector<Vec2> origin;  ///< (i,k) [mm]
    std::vector<double> lean;  ///< (i,k) clockwise [rad]
};

/// The cup on the wave generator without torque.
struct AssembledCup
{
    double coning_major = 0;          ///< slope of the radial displacement over the slices at the major axis, by least
                                      ///< squares [rad]
    double coning_minor = 0;          ///< at the minor axis [rad]
    std::vector<double> z;            ///< (k) slices [mm]
    std::vector<double> w_major;      ///< (k) radial displacement at the major axis [mm]
    std::vector<double> w_minor;      ///< (k) radial displacement at the minor axis [mm]
    double wave_generator_force = 0;  ///< [N]
    int contacts = 0;                 ///< nodes of the bearing that carry force
    double largest_stress = 0;        ///< von Mises [MPa]; 0: not computed
    double ball_force = 0;            ///< largest of a ball [N], of a line [N/mm]; 0: a rigid bearing
    double ball_phi = 0;              ///< its angle [rad]
    int balls = 0;                    ///< single balls that carry force
    bool estimated = false;           ///< the following errors are estimated, as those of a LoadCase
    double displacement_error = 0;    ///< of each w_major and w_minor [mm]
    double coning_major_error = 0;    ///< [rad]
    double coning_minor_error = 0;    ///< [rad]
    double wave_generator_force_error = 0;  ///< [N]
    double largest_stress_error = 0;        ///< [MPa]
    double ball_force_error = 0;            ///< [N], [N/mm]
};

}  // namespace hdconj
