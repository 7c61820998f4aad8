// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `load`: the elastic cup on its wave generator, teeth under torque.
/// Lengths in mm, forces in N, torques in N mm, stresses in MPa, angles in rad.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/loaded_cup.hpp"
#include "hdconj/pitch_errors.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/twist_member.hpp"

namespace hdconj {

/// The drive at one torque, in equilibrium.
///
/// The wave generator and the cup's flange are held; torque and `twist` are those of the circular spline, so that their
/// product is work. They count positive where the teeth go clockwise in their spaces, the twist from the middle of the
/// backlash. With a held circular spline the flange turns z_c/z_f as far, under z_f/z_c of the torque
/// (docs/explanation/theory.md). A positive torque loads the right flanks of the tooth spaces (GapMap::right).
struct LoadedState
{
    double torque = 0;               ///< on the circular spline [N mm]
    double twist = 0;                ///< of the circular spline [rad]
    double stiffness = 0;            ///< dT/d(twist) of the curve [N mm/rad]
    int teeth = 0;                   ///< tooth spaces that carry force
    double contact_area = 0;         ///< of Hertz strips, cut where the force becomes zero between slices [mm^2]
    double contact_fraction = 0;     ///< the same as a fraction of the area of all flanks on the loaded side
    double fraction_within_gap = 0;  ///< fraction of that area with gap <= contact_gap in the loaded shape
    double carrying_fraction = 0;    ///< fraction of the (space, slice) nodes of that side that carry force
    double largest_pressure = 0;     ///< Hertz, of edges with their radius [MPa]; as an error NaN: on an edge or an end
    int pressure_space = 0;          ///< its tooth space, an index into LoadMap::angle
    double pressure_z = 0;           ///< its slice [mm]
    double largest_force = 0;        ///< on one tooth [N]
    double largest_line_load = 0;    ///< mean over half a millimetre of width of one flank [N/mm]
    double flank_pressure = 0;       ///< largest Hertz pressure, edges and half a millimetre at each end left out [MPa]
    double edge_force = 0;           ///< largest that edges and these ends of one flank carry [N]
    double edge_fraction = 0;        ///< fraction of all flank forces on edges and these ends
    double flowing_fraction = 0;     ///< fraction of all flank forces where the steel flows; 0 without [flow]
    double wave_generator_force = 0;   ///< sum of the forces between wave generator and cup, without direction [N]
    double wave_generator_torque = 0;  ///< that the wave generator feels [N mm]
    double lobe_force = 0;             ///< resultant on the cup over the lobe at the major axis, along that axis [N]
    double lobe_force_across = 0;      ///< across that axis, clockwise positive [N]
    double lobe_z = 0;                 ///< height of lobe_force above the middle of the bearing [mm]; NaN: a couple
    double ball_force = 0;             ///< largest of a ball [N], of a line of balls [N/mm]; 0: a rigid bearing
    double ball_phi = 0;               ///< its angle from the major axis [rad]
    int balls = 0;                     ///< single balls that carry force
    double largest_stress = 0;         ///< von Mises in the cup [MPa]; 0: not computed
    double stress_z = 0;               ///< its height above the middle of the bearing [mm]
    double stress_r = 0;               ///< its radius [mm]
    double stress_phi = 0;             ///< its angle from the major axis [rad]
    int iterations = 0;                ///< iterations of the loaded shape
    int steps = 0;                     ///< of the active set, in all iterations
    double gap_mismatch = 0;     ///< largest difference between the gaps of the loaded shape and the linear model [mm]
    double complementarity = 0;  ///< relative residual of force and gap
};

/// Forces on the flanks at one torque over (space, flank, slice). The spaces are those of one sector of the ring, which
/// repeats around it.
struct LoadMap
{
    double torque = 0;              ///< [N mm]
    std::vector<double> z;          ///< (k) [mm]
    std::vector<double> angle;      ///< (s) centre line of the space from the major axis [rad], increasing
    std::vector<double> force;      ///< (s,2,k) along the normal [N], all points of a flank together
    std::vector<double> line_load;  ///< (s,2,k) [N/mm]
    std::vector<double> pressure;   ///< (s,2,k) largest [MPa]
    /// (s,2,k) smallest in the loaded shape [mm]; of a loaded contact minus its Hertz approach
    std::vector<double> gap;
    std::vector<double> height;  ///< (s,2,k) of that point along the flank, 0 at the land corner ... 1 at the flank end
    std::vector<double> tooth_force;        ///< (s) on the tooth in the space, both flanks and all slices together [N]
    std::vector<double> tooth_force_error;  ///< (s) estimated discretisation error [N]; empty: not estimated

    /// Place of a node in the datasets over (s,2,k).
    [[nodiscard]] std::size_t index(std::size_t space, int flank, std::size_t slice) const
    {
        return (space * 2 + static_cast<std::size_t>(flank)) * z.size() + slice;
    }
};

/// A contact of a flank that carries force, in the plane of a slice. Places and directions are those of the tooth
/// space: y along its centre line, outward.
struct ContactForce
{
    int space = 0;               ///< index into LoadMap::angle
    int flank = 0;               ///< as in GapMap
    int slice = 0;               ///< index into LoadMap::z
    Vec2 place = Vec2::Zero();   ///< on the flank of the circular spline [mm]
    Vec2 normal = Vec2::Zero();  ///< of the force on the circular spline
    double lever = 0;            ///< clockwise torque of a unit force on the circular spline: normal x place [mm]
    double force = 0;            ///< [N]
    double half_width = 0;       ///< of its Hertz strip [mm]
};

/// Forces of the bearing at one torque over one sector of the ring.
struct BearingMap
{
    std::vector<double> angle;                  ///< (i) from the major axis [rad]
    std::vector<double> z;                      ///< (j) above the middle of the bearing [mm]
    std::vector<double> force;                  ///< (i,j) on the cup, outward [N]
    std::vector<double> ball_angle;             ///< (b) [rad]; empty: a rigid bearing
    std::vector<double> ball_force;             ///< (b) of single balls [N], of a line [N/mm]
    std::vector<double> ball_force_error = {};  ///< (b) estimated discretisation error; empty: not estimated
};

/// Two straight lines through a torque-twist curve, and their bend (thesis 5-2: C = dT/dphi in two stages).
struct StiffnessStages
{
    double first = 0;       ///< [N mm/rad]
    double second = 0;      ///< [N mm/rad]
    double knee = 0;        ///< torque where they meet [N mm]; one line: 0
    double knee_twist = 0;  ///< twist there [rad]
    /// Standard error of the fit; in a LoadCase the estimated discretisation error, and `rms` tells how far the curve
    /// is from two lines [N mm/rad].
    double first_error = 0;
    double second_error = 0;      ///< likewise [N mm/rad]
    double knee_error = 0;        ///< likewise, of the knee's torque [N mm]
    double rms = 0;               ///< of the fit, in torque [N mm]
    bool found = false;           ///< enough points for two lines
    double knee_twist_error = 0;  ///< likewise, of the twist there [rad]
};

/// Two straight lines through (twist, torque) by least squares, and the bend where they fit best. Points are in order
/// of growing torque, all of one sign. With fewer than six points `found` is false, and both slopes are those of one
/// line. The same holds where a straight line with noise would show such a bend by chance (1 %). Fewer than two
/// different twists: all zero. The bend lies between the third point and the third last. Where it fits best at one of
/// these, the true one may lie beyond: the error of the stage on that side and those of the knee are then infinite.
/// Global least squares over slopes and bend (Hudson 1966), in time points^2.
/// @throws std::logic_error where there are not as many torques as twists
[[nodiscard]] StiffnessStages stiffness_stages(std::vector<double> const& twist, std::vector<double> const& torque);

/// Torques that catalogues define stiffness and lost motion by [N mm].
struct CatalogueTorques
{
    double first = 0;        ///< T1
    double second = 0;       ///< T2
    double lost_motion = 0;  ///< 4 % of the rated torque
};

/// A slope of torque over twist.
struct Stiffness
{
    double value = 0;  ///< [N mm/rad]
    double error = 0;  ///< estimated discretisation error [N mm/rad]
};

/// Stiffness and lost motion as catalogues of harmonic drives state them: slopes of straight lines between the points
/// of the torque-twist curve at zero torque (backlash left out), T1, T2 and the rated torque, and the turn between both
/// signs of 4 % of the rated torque. Without friction the lost motion is backlash and elastic twist alone.
struct CatalogueFigures
{
    CatalogueTorques torque;       ///< as the scene gives them, else 0.175 and 0.625 of the rated torque
    Stiffness k1;                  ///< from zero torque to T1
    Stiffness k2;                  ///< from T1 to T2
    Stiffness k3;                  ///< from T2 to the rated torque
    double lost_motion = 0;        ///< [rad]
    double lost_motion_error = 0;  ///< estimated discretisation error [rad]
    bool estimated = false;        ///< false: the errors are 0 and mean nothing
};

/// A torque for which no equilibrium was found.
struct UnsettledTorque
{
    double torque = 0;  ///< [N mm]
    std::string cause;  ///< in words, with what can be done
};

/// Tips of the assembled drive that interfere along a radius as they pass each other: no turn brings them apart.
struct TipInterference
{
    double depth = 0;      ///< [mm]
    double least_tip = 0;  ///< tip circle of the circular spline with which they pass [mm]
};

/// One surface of the circular spline under load.
struct LoadCase
{
    ToothSurface surface = ToothSurface::tilted;  ///< as in ContactCase
    std::optional<TiltKind> kind;                 ///< of the tilt, as in ContactCase; nothing where there is no tilt
    double tilt = 0;                              ///< [rad]
    double backlash_offset = 0;                   ///< side clearance [mm]
    double backlash_offset_error = 0;             ///< estimated, where it was found; else 0
    bool side_clearance_increased =
        false;       ///< the side clearance exceeds the scene's, with which the teeth press on both flanks
    double tip = 0;  ///< tip circle at z = 0 [mm]
    /// By how much the tip circle was widened beyond the surface's own, so that the teeth are clear or that a land is
    /// left [mm].
    double tip_radius_increase = 0;
    /// Side clearance and tip circle are those with which the teeth of the unloaded cup clear over a full turn: with
    /// the scene's the assembled teeth press on both flanks, or their tips interfere.
    bool cleared = false;
    std::optional<TipInterference> given_tips;  ///< with the scene's side clearance and tip circle, where not used
    std::optional<TipInterference> tips;        ///< with those used; the backlash is negative then
    double backlash = 0;             ///< without torque [rad]; negative: the assembled teeth press on both flanks
    std::vector<LoadedState> curve;  ///< in order of growing torque, from -T to T; without a curve: T alone
    std::vector<UnsettledTorque> unsettled;  ///< torques of the path that are missing in curve
    std::size_t rated = 0;                   ///< index of the largest torque in curve
    LoadMap map;                             ///< at that torque
    std::vector<ContactForce> contacts;      ///< at that torque, of one sector: sectors sum(lever force) = torque
    BearingMap bearing;                      ///< at that torque
    /// Estimated discretisation error of curve[rated]: four times the difference to a grid half as fine in slices,
    /// flank points, circles of the bearing and harmonics (numbers of teeth and balls: twice). Not a bound where a
    /// figure does not converge: pressure_at_edge, LoadStudy::sharp_steps.
    LoadedState error;
    double backlash_error = 0;  ///< the same of the backlash [rad]
    /// False: errors are not asked for, fewer than three slices, or no equilibrium on the coarse grid; the errors are 0
    /// and mean nothing.
    bool estimated = false;
    /// The error of each state of the curve; none where the coarse grid has no equilibrium. Empty: fewer than three
    /// slices, or errors are not asked for.
    std::vector<std::optional<LoadedState>> curve_error;
    /// The largest pressure is at an end of the face width, where it grows with the number of slices.
    bool pressure_at_edge = false;
    std::vector<TwistMember> members;           ///< in series, at that torque: their twists add up
    StiffnessStages stages;                     ///< of the curve from 0 to the rated torque, at even torques
    std::optional<CatalogueFigures> catalogue;  ///< with a curve only; none where T2 is not below its largest torque,
                                                ///< or one of its torques has no equilibrium
    double seconds = 0;                         ///< wall time [s]
};

/// All cases of a drive under load.
struct LoadStudy
{
    Solution solution;  ///< of the scene; its circular spline with the surface and slices of cases[written_case]
    AssembledCup cup;   ///< on its wave generator, without torque
    std::vector<LoadCase> cases;       ///< in the order asked for, without those that are missing
    std::vector<std::string> missing;  ///< as in ContactStudy; and torques without an equilibrium
    std::size_t written_case = 0;      ///< case of least line load, which `shape` and `teeth` are of
    CupShape shape;                    ///< of the cup at the largest torque
    LoadedTeeth teeth;                 ///< of the same case at that torque
    int harmonics = 0;                 ///< largest circumferential harmonic
    int sectors = 1;                   ///< how often the solved sector repeats around the ring
    double contact_gap = 0;            ///< of fraction_within_gap [mm]
    double rated_torque = 0;           ///< [N mm]
    double pitch_radius = 0;           ///< m z_f/2 [mm]
    double edge_radius = 0;            ///< of the edges where teeth touch, given or standard [mm]
    double standard_tip_increase = 0;  ///< by how much the tip circle exceeds the standard one, which leaves no land
                                       ///< [mm]; 0 where the scene gives it
    PitchErrors pitch_errors;          ///< that the scene gives, or random ones
    int balls = 0;                     ///< of the bearing; 0: a line, or a rigid bearing
    double ball_constant = 0;          ///< k of F = k d^1.5 of each ball [N/mm^1.5]; 0: not by Hertz
    bool sharp_steps = false;  ///< the wall grows to the tooth ring in ramps, whose corners have no largest stress
};

/// What is asked beside the scene. An empty list leaves the choice to the scene.
struct LoadOptions
{
    std::vector<double> tilts;           ///< [rad]
    std::vector<ToothSurface> surfaces;  ///< kinds of surface
    std::vector<TiltKind> kinds;         ///< of the tilt
    std::optional<double> torque;        ///< rated torque [N mm]
    std::optional<int> points;           ///< even torques on the way up, beside those of the catalogue's figures
    bool curve = true;                   ///< false: the rated torque only
    bool errors = true;                  ///< false: one grid alone, and no estimated errors
    std::function<bool()> stop;          ///< asked before each torque; true: what is there is the result. Null: never
};

/// The options, and scene and options against each other. The torque has to be above 0; study_load() also takes 0, and
/// torques the other way round.
[[nodiscard]] Faults check_load(Scene const& scene, LoadOptions const& options);

/// The scene as `load` takes it: with slices across the width and an elastic cup where it says nothing of them.
[[nodiscard]] Scene loaded_scene(Scene asked, LoadOptions const& options = {});

/// Every combination of surface, kind and tilt under torque (design 3.6).
///
/// The cup is elastic (Fourier harmonics); wave generator and flanks are unilateral contacts. Gaps and normals are
/// recomputed in the loaded shape until the linear model and the geometry agree. Domain: small displacements of the cup
/// about its undeformed shape; no friction. The result has the same bits for any number of threads.
/// @param scene     the drive; it needs an elastic cup, see loaded_scene()
/// @param options   what is asked beside the scene
/// @param on_stage  is told each stage that begins; null: nobody
/// @param progress  is told how much of the work is done; null: nobody
/// @param talk      is told the first figures in words: force and coning of the assembled cup, then the backlash of
/// each surface
/// @throws InputError for a scene or options that cannot be computed; NumericalError with stage, place and cause where
/// no case can be (LoadStudy::missing)
[[nodiscard]] LoadStudy study_load(Scene const& scene, LoadOptions const& options = {},
                                   StageObserver const& on_stage = {}, Progress const& progress = {},
                                   std::function<void(std::string const&)> const& talk = {});

}  // namespace hdconj
