// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `run`: the drive while it turns: transmission error, torque on the wave generator, friction and efficiency.
/// Torques in N mm, angles in rad, speeds in rad/s, temperatures in degrees Celsius.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/load.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// Over which turn of the wave generator a sequence of positions goes.
enum class RunSpan
{
    tooth_pitch,  ///< until every tooth stands where its neighbour stood
    input_turn,   ///< one turn against a ring of teeth, at whole pitches
    output_turn   ///< until all teeth of both rings meet as before, a turn of the output where z_c - z_f divides both
                  ///< numbers of teeth; at whole pitches
};

/// Its name in results: "tooth_pitch", "input_turn", "output_turn".
[[nodiscard]] std::string to_string(RunSpan span);

/// The drive at one position of the wave generator.
struct RunPosition
{
    double angle = 0;  ///< of the wave generator against the ring of teeth that is held [rad]
    /// Transmission error: by how much the output is ahead of angle/i in its working direction [rad].
    double error = 0;
    double wave_generator_torque = 0;  ///< without friction, from the forces of its bearing; unloaded: 0 [N mm]
    double torque_by_teeth = 0;        ///< the same from the forces of the teeth [N mm]
    double error_error = 0;            ///< of `error` about its mean over the positions [rad]
    double torque_error = 0;           ///< of both torques [N mm]
};

/// One order of a transmission error: amplitude cos(order angle - phase).
struct RunOrder
{
    double per_input = 0;        ///< periods in a turn of the wave generator
    double per_output = 0;       ///< periods in a turn of the output
    double amplitude = 0;        ///< [rad]
    double phase = 0;            ///< [rad]
    double amplitude_error = 0;  ///< [rad]
    double phase_error = 0;      ///< pi where the amplitude is not known [rad]
};

/// Positions of the wave generator under one torque, and what their transmission error comes to.
///
/// A sequence over a tooth pitch shows what comes again with every tooth. Errors of the rings of teeth change little
/// from tooth to tooth: the other sequences take positions that are whole pitches apart, at which what comes again with
/// every tooth is a constant, so that it does not look like a low order.
struct RunSequence
{
    RunSpan span = RunSpan::tooth_pitch;      ///< that the positions go over
    double torque = 0;                        ///< on the output [N mm]; 0: first contact of the loaded flanks
    std::size_t planned = 0;                  ///< positions asked for: those without a result are not in `positions`
    std::vector<RunPosition> positions = {};  ///< in order of angle, the end of the period left out
    std::vector<RunOrder> orders = {};        ///< from the first on, as many as the positions tell apart
    double peak_to_peak = 0;                  ///< of the error over the positions; of fewer than three positions this
                                              ///< and the other figures are NaN [rad]
    double peak_to_peak_error = 0;            ///< [rad]
    double rms = 0;                           ///< of the error about its mean [rad]
    double rms_error = 0;                     ///< [rad]
    double mean_torque = 0;                   ///< of wave_generator_torque over the positions [N mm]
    double mean_torque_error = 0;             ///< difference of the mean by teeth or of T/i, the larger one [N mm]
    double torque_ripple = 0;                 ///< its peak to peak [N mm]
    /// Largest difference of both ways about their means, twice, and that of the grids [N mm].
    double torque_ripple_error = 0;
    bool estimated = false;  ///< false: errors are 0, or too small, and mean nothing
    double seconds = 0;      ///< wall time [s]
};

/// What the drive loses at one torque, speed and temperature: torques on the wave generator [N mm].
struct EfficiencyRow
{
    double torque = 0;            ///< on the output
    double speed = 0;             ///< of the wave generator [rad/s]
    double temperature = 0;       ///< of the lubricant [degrees Celsius]
    double efficiency = 0;        ///< power of the output over that of the wave generator; NaN where both are 0
    double efficiency_error = 0;  ///< NaN as that is; this and the next error: 0 where RunLosses::estimated is false
    double input_torque = 0;  ///< that drives the wave generator; without torque on the output: no-load running torque
    double input_torque_error = 0;  ///< [N mm]
    double flanks = 0;              ///< part of the input that sliding flanks take; its error is that of the input
    double bearing_load = 0;        ///< that of the bearing under its balls' forces, Palmgren's M1
    double bearing_speed = 0;       ///< that of the bearing's lubricant, Palmgren's M0
    double seal = 0;                ///< of the seals
    double churning = 0;            ///< of the lubricant around the wave generator
};

/// What the drive loses, and what it takes to start it.
struct RunLosses
{
    std::vector<EfficiencyRow> efficiency;  ///< torque within speed within temperature; the first torque is 0
    double starting_torque = 0;             ///< on the wave generator at rest, no torque on the output [N mm]
    double starting_torque_error = 0;       ///< [N mm]
    std::optional<double> back_driving;     ///< torque on the output that turns the wave generator [N mm]; none: not
                                            ///< found up to the largest torque
    double back_driving_error = 0;          ///< [N mm]
    double ball_load = 0;                   ///< sum of the forces of the balls at the largest torque [N]
    double ball_load_error = 0;             ///< [N]
    double bearing_diameter = 0;            ///< mean diameter d_m [mm]
    double largest_sliding = 0;             ///< of loaded flanks for each rad of the wave generator [mm/rad]
    double largest_sliding_error = 0;       ///< [mm/rad]
    bool estimated = false;                 ///< false: the errors are 0 and mean nothing
};

/// The drive while it turns.
struct RunStudy
{
    Solution solution;                                 ///< of the scene, its circular spline with the surface that runs
    RunningMember output = RunningMember::flexspline;  ///< the member that turns
    double ratio = 0;                                  ///< i: turns of the wave generator for one of the output
    bool elastic = false;      ///< the cup is elastic and carries a torque; false: the shape that the scene prescribes
    double torque = 0;         ///< the largest, on the output [N mm]
    double spline_torque = 0;  ///< the same on the circular spline, as `load` counts it [N mm]
    double backlash_offset = 0;             ///< side clearance of the flanks [mm]
    double tip = 0;                         ///< tip circle at z = 0 [mm]
    double tip_radius_increase = 0;         ///< how much wider it is than the scene gives, so that teeth clear [mm]
    bool side_clearance_increased = false;  ///< the side clearance is larger than the scene gives
    std::vector<RunSequence> sequences;     ///< in order of span, without torque first
    std::optional<RunLosses> losses;        ///< with [friction] only
    std::vector<std::string> missing;       ///< positions and torques without a result, each with its cause; also in
                                            ///< solution.notes
};

/// What is asked beside the scene. What is left out the scene says.
struct RunOptions
{
    std::optional<double> torque;  ///< largest, on the output [N mm]; 0: first contact only
    std::optional<int> positions;  ///< over one tooth pitch
    bool errors = true;            ///< false: one grid alone
    std::function<bool()> stop;    ///< asked before each position; true: what is there is the result. Null: never
};

/// Scene and options against each other.
[[nodiscard]] Faults check_run(Scene const& scene, RunOptions const& options = {});

/// The stages that `run` goes through, and why. Domain: a scene without faults.
[[nodiscard]] Plan plan_run(Scene const& scene, RunOptions const& options = {});

/// The drive at positions of its wave generator.
///
/// Frames: the wave generator is held and both rings turn past it. With theta the angle of the wave generator against
/// the held ring, tooth 0 of the flexspline has gone back by the undeformed angle c theta, c = z_c/z_f where the
/// circular spline is held and 1 where the cup is, and both rings have moved on by c theta z_f/(2 pi) pitches. Between
/// whole pitches every tooth takes the place of its neighbour. Over theta = 2 pi the teeth of the held ring all come to
/// the place where they were; the other ring is z_c - z_f pitches further. An error of order k of the held ring thus
/// has k periods in a turn of the wave generator, one of the ring that turns k z_c/z_f where that is the flexspline,
/// and k z_f/z_c where it is the circular spline.
///
/// The output leads theta/i, i = z_f/(z_c - z_f) for the cup and z_c/(z_c - z_f) for the circular spline, by
///
///   error(theta) = phi_out - theta/i = -c' turn(theta),   c' = z_c/z_f for the cup and 1 for the circular spline,
///
/// where turn is that of the flexspline against the circular spline at which the loaded flanks first touch, or at which
/// they carry the torque (study_load()). A twist shifts the positions by itself, which is left out: at most a tenth of
/// a pitch. Torque on the wave generator without friction, from the energy of a shape that stands still as the rings
/// turn past it: T/i - sum(F dg/dtheta) over the forces and gaps of the flanks, whose mean is T/i.
///
/// Losses are those of the forces without friction: flanks sum(mu F v)/omega with the velocity of sliding in the plane
/// of the flank and along the axis; the bearing by Palmgren's M0 + M1. Domain: friction so small that it does not move
/// the forces. Single balls stay where the scene puts them against the wave generator.
///
/// Accuracy: each figure has its error, from a grid half as fine and from half of the positions.
/// @param scene     the drive
/// @param options   what is asked beside the scene
/// @param on_stage  is told each stage that begins; null: nobody
/// @param progress  is told how much of the work is done; null: nobody
/// @throws InputError for a scene or options that cannot be computed; NumericalError where no position has a result
[[nodiscard]] RunStudy study_run(Scene const& scene, RunOptions const& options = {}, StageObserver const& on_stage = {},
                                 Progress const& progress = {});

}  // namespace hdconj
