// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `load` computes: plain data, lengths in mm, forces in N, torques in N mm, stresses in MPa, angles in rad.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/pipeline/solution.hpp"

namespace hdconj {

/// The drive at one torque, in equilibrium.
///
/// The wave generator and the cup's flange are held; torque and `twist` are those of the circular spline, so that their product is work. They count positive where the
/// teeth go clockwise in their spaces, the twist from the middle of the play. With a held circular spline the flange turns z_c/z_f as far, under z_f/z_c of the torque
/// (docs/theory.md, Take-up). A positive torque loads the right flanks of the tooth spaces (GapMap::right).
struct LoadedState
{
    double torque = 0;              ///< [N mm] on the circular spline
    double twist = 0;               ///< of the circular spline [rad]
    double stiffness = 0;           ///< dT/d(twist) with the contacts that are closed [N mm/rad]
    int teeth = 0;                  ///< tooth spaces that carry force
    double contact_area = 0;        ///< [mm^2] of flank under pressure: Hertz strips, cut where the force becomes zero between slices
    double contact_share = 0;       ///< of the area of all flanks on the loaded side
    double near_share = 0;          ///< flank area with gap <= contact_gap in the loaded shape, the same share
    double node_share = 0;          ///< share of the (space, slice) nodes of that side that carry force: what a coarse mesh would count
    double largest_pressure = 0;    ///< [MPa] Hertz
    int pressure_space = 0;         ///< where: number of the space in LoadMap::angle
    double pressure_z = 0;          ///< and slice [mm]
    double largest_force = 0;       ///< on one tooth [N]
    double wave_generator_force = 0;///< sum of the forces between wave generator and cup, without direction [N]
    double wave_generator_torque = 0; ///< that the wave generator feels [N mm]
    double lobe_force = 0;          ///< resultant of the bearing's forces on the cup over the lobe at the major axis, along that axis [N]
    double lobe_force_across = 0;   ///< and across it, clockwise positive [N]
    double lobe_z = 0;              ///< where on the axis lobe_force acts, above the middle of the bearing [mm]
    double ball_force = 0;          ///< largest of a ball [N], of a line of balls [N/mm]; 0: a rigid bearing, which has none
    double ball_phi = 0;            ///< where, from the major axis [rad]
    int balls = 0;                  ///< single balls that carry
    double largest_stress = 0;      ///< von Mises in the cup [MPa]; 0: not computed
    double stress_z = 0, stress_r = 0, stress_phi = 0;  ///< where: above the middle of the bearing, radius [mm], angle from the major axis [rad]
    int rounds = 0;                 ///< of the geometry: gaps taken again in the loaded shape
    int steps = 0;                  ///< of the active set, all rounds
    double residual = 0;            ///< largest difference between the gap solved for and the gap of the loaded shape at contacts [mm]
    double complementarity = 0;     ///< relative residual of force and gap
};

/// Forces on the flanks at one torque, over (space, flank, slice); spaces of one sector of the ring, which repeats around it.
struct LoadMap
{
    double torque = 0;             ///< [N mm]
    std::vector<double> z;         ///< (k) [mm]
    std::vector<double> angle;     ///< (s) centre line of the space from the major axis [rad], increasing
    std::vector<double> force;     ///< (s,2,k) along the normal [N], all points of a flank together
    std::vector<double> line_load; ///< (s,2,k) [N/mm]
    std::vector<double> pressure;  ///< (s,2,k) largest [MPa]
    std::vector<double> gap;       ///< (s,2,k) smallest in the loaded shape [mm]; no smaller than what the Hertz contact gives way
    std::vector<double> height;    ///< (s,2,k) place of that point along the flank, 0 at the land corner ... 1 at the flank end

    [[nodiscard]] std::size_t index(std::size_t space, int flank, std::size_t slice) const
    {
        return (space * 2 + static_cast<std::size_t>(flank)) * z.size() + slice;
    }
};

/// What the bearing does at one torque, over one sector of the ring.
struct BearingMap
{
    std::vector<double> angle;      ///< (i) from the major axis [rad]
    std::vector<double> z;          ///< (j) above the middle of the bearing [mm]
    std::vector<double> force;      ///< (i,j) on the cup, outward [N]
    std::vector<double> ball_angle; ///< (b) [rad]; empty: a rigid bearing
    std::vector<double> ball_force; ///< (b) of single balls [N], of a line [N/mm]
};

/// Two straight lines through the loaded branch of a torque-twist curve, and their bend (thesis 5-2: C = dT/dphi in two stages).
struct StiffnessStages
{
    double first = 0;    ///< [N mm/rad]
    double second = 0;   ///< [N mm/rad]
    double knee = 0;     ///< torque where they meet [N mm]; one line: 0
    double knee_twist = 0;  ///< twist there [rad]
    double first_error = 0, second_error = 0;  ///< standard errors of the slopes [N mm/rad]
    double knee_error = 0;  ///< standard error of the knee's torque [N mm]
    double rms = 0;      ///< of the fit, in torque [N mm]
    bool found = false;  ///< enough points for two lines
};

/// One surface of the circular spline under load.
struct LoadCase
{
    std::string surface;          ///< as in ContactCase
    std::string kind;
    double tilt = 0;              ///< [rad]
    double backlash_offset = 0;   ///< side clearance [mm]
    bool raised = false;          ///< it is more than the scene gives, because with that the assembled teeth press on both flanks
    double tip = 0;               ///< tip circle at z = 0 [mm]
    double tip_change = 0;        ///< how much wider than the surface's own it was made, for the same reason or for a land that the side clearance leaves [mm]
    double backlash = 0;          ///< play without torque [rad]; negative: the assembled teeth press on both flanks
    std::vector<LoadedState> curve;  ///< in the order of loading: 0 to T, back to 0, to -T
    std::size_t rated = 0;        ///< index of the largest torque in curve
    LoadMap map;                  ///< at that torque
    BearingMap bearing;           ///< at that torque
    /// How far the figures of curve[rated] and the play are from those of a fine grid: four times their distance from a grid half as fine in slices, flank points, circles of the bearing
    /// and harmonics (numbers of teeth and balls: once). Not a bound where a figure does not converge: pressure_at_edge, sharp_steps of LoadStudy.
    LoadedState error;
    double backlash_error = 0;    ///< [rad]
    bool estimated = false;       ///< false: fewer than three slices, or no balance on the coarse grid; the errors are 0 and say nothing
    std::vector<std::optional<LoadedState>> curve_error;  ///< the same of each state of curve; none where the coarse grid has no balance. Empty: fewer than three slices
    bool pressure_at_edge = false;  ///< the largest pressure is at an end of the face width, where it grows with the number of slices
    StiffnessStages stages;       ///< of the branch 0 to T
    double seconds = 0;
};

/// The cup in the section plane with its harmonics summed at the angles that are drawn.
struct CupShape
{
    std::vector<double> r, z;                 ///< (p) nodes of the section [mm], z above the middle of the bearing
    std::vector<std::vector<int>> cells;      ///< corner nodes of each element, counter-clockwise
    std::vector<double> phi;                  ///< (a) angles [rad]
    std::vector<double> u_r, u_t, u_z;        ///< (a,p) displacement at the largest torque of the case shown [mm]
    std::vector<double> stress;               ///< (a,p) von Mises [MPa]; empty: not computed
};

/// Coning of the cup on the wave generator, without torque.
struct AssembledCup
{
    double coning_major = 0;   ///< slope of the radial displacement along the axis at the major axis, least squares over the toothed width [rad]
    double coning_minor = 0;
    std::vector<double> z;     ///< (k) slices [mm]
    std::vector<double> w_major, w_minor;  ///< (k) radial displacement there [mm]
    double wave_generator_force = 0;  ///< [N]
    int contacts = 0;          ///< nodes of the bearing that carry force
    double largest_stress = 0; ///< von Mises [MPa]; 0: not computed
    double ball_force = 0;     ///< largest of a ball [N], of a line [N/mm]; 0: a rigid bearing
    double ball_phi = 0;       ///< where [rad]
    int balls = 0;             ///< single balls that carry
    bool estimated = false;    ///< whether there are error estimates, as of LoadCase
    double coning_major_error = 0, coning_minor_error = 0;  ///< [rad]
    double wave_generator_force_error = 0;  ///< [N]
    double largest_stress_error = 0;        ///< [MPa]
    double ball_force_error = 0;            ///< [N], [N/mm]
};

struct LoadStudy
{
    Solution solution;            ///< of the scene; its circular spline with the surface and slices of cases[shown]
    AssembledCup cup;
    std::vector<LoadCase> cases;  ///< in the order asked for, without those that are missing
    std::vector<std::string> missing;  ///< as in ContactStudy
    std::size_t shown = 0;        ///< case of least largest pressure, which `shape` is of
    CupShape shape;
    int harmonics = 0;            ///< largest circumferential harmonic
    int sectors = 1;              ///< how often the solved sector repeats around the ring
    double contact_gap = 0;       ///< of near_share [mm]
    double rated_torque = 0;      ///< [N mm]
    double pitch_radius = 0;      ///< m z_f/2 [mm]
    double edge_radius = 0;       ///< of the edges where teeth touch, given or standard [mm]
    double tip_widened = 0;       ///< by how much the tip circle is wider than the standard one, which leaves no land [mm]; 0 where the scene gives it
    int balls = 0;                ///< of the bearing; 0: a line, or a rigid bearing
    bool sharp_steps = false;     ///< the wall grows to that of the tooth ring in ramps, whose corners have no largest stress
};

}  // namespace hdconj
