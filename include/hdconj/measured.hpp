// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A torque-twist curve from a test rig: backlash and two-stage stiffness with their uncertainty. Angles in rad,
/// torques in N mm, at the output.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene_words.hpp"

namespace hdconj {

/// How readings of a test rig become torque and angle at the output; the input shaft is held by nothing, the output by
/// the rig.
struct RigInputs
{
    double torque_constant =
        0;  ///< of the motor [N m/A]; 0: torques were read. Negative: current and angle count in opposite senses
    double counts_per_turn = 0;   ///< of the encoder on the motor shaft, after multiplication; 0: angles were read
    double ratio = 0;             ///< of the drive, without sign: motor turns per turn of the output
    double efficiency = 1;        ///< static, of the torque between motor and output
    double angle_per_spline = 1;  ///< angle of the output over that of a circular spline in the same contact, which a
                                  ///< simulation turns; torques the other way round. Output cup: z_c/z_f
};

/// Samples in the order in which they were taken.
struct MeasuredCurve
{
    std::string file;            ///< as the user gave it; empty: no curve
    std::string columns;         ///< what was read of it, such as "current [A], position [counts]"
    RigInputs rig;               ///< what was used of it
    std::vector<double> twist;   ///< at the output [rad]
    std::vector<double> torque;  ///< at the output [N mm]
    std::vector<int> line;       ///< of the file, where each sample stands
};

/// A mean and its standard error.
struct Estimate
{
    double value = 0;  ///< the mean
    double error = 0;  ///< the larger of two: scatter of what was averaged / sqrt(count), and what the deviations from
                       ///< each fit let expect
    int count = 0;     ///< 0: nothing was averaged, value and error mean nothing
};

/// What a measured loop says, by the definitions of the thesis (5-2): C = dT/dphi in two stages, backlash the width of
/// the loop without torque.
struct MeasuredStiffness
{
    int cycles = 0;                   ///< pairs of a positive and a negative load
    double largest_torque = 0;        ///< [N mm]
    double angle_step = 0;            ///< steps in which the angle is read; 0: it has none [rad]
    double middle = 0;                ///< of the loop at zero torque [rad]; what `twist` of a simulation counts from
    double torque_middle = 0;         ///< of the loop [N mm]: the reading without load; taken out. 0: none was found
    std::vector<std::size_t> strays;  ///< samples left out: they leave the run of their neighbours
    Estimate drift;       ///< of the angle, over the whole log [rad]; taken out. Count 0: no branch is repeated
    Estimate loop_width;  ///< angle where the load has gone, from the positive side less from the negative one [rad]
    Estimate friction_width;  ///< of the loop's width what friction makes [rad]; count 0: not determined
    Estimate backlash;        ///< of the loop's width the rest, the jump between both sides [rad]; without
                              ///< friction_width the whole loop. Count 0: not determined
    Estimate
        friction;      ///< torque that friction takes: half of what loading and unloading differ by at one angle [N mm]
    Estimate first;    ///< stiffness of the first stage, over the loading branches that have a bend [N mm/rad]
    Estimate second;   ///< stiffness of the second stage [N mm/rad]
    Estimate knee;     ///< torque of the loading branches where they meet, which contains the friction [N mm]
    Estimate whole;    ///< stiffness of one line over each loading branch [N mm/rad]
    int straight = 0;  ///< loading branches without a bend
};

/// Shares of the largest torque at which the loop is looked at.
namespace measured_at {
inline constexpr double reversal = 0.1;  ///< a branch ends where the torque has turned back by this; smaller is noise
inline constexpr double loaded =
    0.8;  ///< a branch that reaches less is no load cycle: the thesis ends with 1 N m of 28
inline constexpr double no_load = 0.02;    ///< below, the drive may lie anywhere in its backlash
inline constexpr double near_zero = 0.12;  ///< up to here the curves to zero torque use the readings
}  // namespace measured_at

/// Splits a curve where the torque turns, and evaluates each branch.
///
/// The load cycles are 0, T, 0, -T, 0 in any number, beginning anywhere. Readings far from their neighbours are left
/// out first, and so is the torque about which the loop is symmetric, where it is far from zero. Where a part of the
/// cycle is repeated, an even drift of the angle is found and taken out. Backlash is the jump between two parallel
/// curves where a branch passes from one side to the other, at zero torque or, with friction, beyond it; readings
/// nearer than no_load to that torque may lie within the backlash and are left out. Where readings are too few to show
/// the jump, backlash is the loop's width less twice the friction over the stiffness of the first stage; with friction
/// above no_load, backlash and stiffness are then not determined. The width of the loop is found for
/// each cycle: a curve through the samples of each unloading branch between no_load and near_zero is extended to zero
/// torque. With fewer than three samples there, a line goes through the two nearest to zero. The curves are means of
/// lines and parabolas, weighted by the curvature up to twice as far; what a parabola may leave is in the error. The
/// rest of the width is friction. Stiffness is found for each loading branch, where it is determined in all that have a
/// bend: stiffness_stages() of the angle over the torque, with negative branches turned round.
/// @throws InputError where the samples are no such loop: one sign only, no unloading, torque that falls with the angle
[[nodiscard]] MeasuredStiffness measured_stiffness(MeasuredCurve const& curve);

/// A curve from a test rig and what it says; laid over the simulation.
struct Measurement
{
    MeasuredCurve curve;      ///< as read
    MeasuredStiffness found;  ///< backlash and stiffness of it
};

/// A larger file is refused before it is read. [bytes]
inline constexpr std::size_t largest_measured_file = std::size_t{64} << 20;
/// The fit looks at all pairs of a branch's samples: a second or two for this many.
inline constexpr std::size_t most_samples = 100000;

/// What the user says about the rig; units as typed.
struct RigOptions
{
    std::optional<double> torque_constant;  ///< [N m/A]
    std::optional<double> counts_per_turn;  ///< of the encoder on the motor shaft
    std::optional<double> ratio;            ///< motor turns per turn of the output
    std::optional<double> efficiency;       ///< of the torque between motor and output, 0 ... 1
};

/// A measured curve as far as it could be read, and every fault found.
struct MeasuredReading
{
    MeasuredCurve curve;  ///< of no use where there are faults
    Faults faults;        ///< all of them: of the options, the header, the rows, with line and column
};

/// Reads the columns "torque" or "current", and "angle" or "position"; others are left alone. Between the fields stands
/// what the header has: semicolon, tab or comma. A line that begins with '#' is a comment. Units stand in brackets:
/// torque [N m, N mm, mN m], current [A, mA], angle [deg, arcmin, arcsec, rad, mrad], position [counts]. Torque =
/// torque constant x current x |ratio| x efficiency, angle = 2 pi counts / (counts per turn x |ratio|).
/// @param file         CSV
/// @param rig          what the user says about the rig
/// @param scene_ratio  of the drive, where @p rig says none
[[nodiscard]] MeasuredReading examine_measured(std::filesystem::path const& file, RigOptions const& rig,
                                               double scene_ratio);

/// Member of the drive that turns at the output of a rig.
enum class OutputMember
{
    cup,             ///< the flexspline; the circular spline is held
    circular_spline  ///< the flexspline is held
};
/// Words of OutputMember.
template <>
inline constexpr std::array<std::string_view, 2> words_of<OutputMember>{"cup", "circular-spline"};

/// A measurement, and every fault of it.
struct MeasurementReading
{
    std::optional<Measurement> measurement;  ///< nothing where there are faults
    Faults faults;                           ///< of the options, of the file, or of the loop
};

/// Reads a measured curve as examine_measured() does, and evaluates it as measured_stiffness() does.
///
/// The motor turns z_f/|z_c - z_f| times for a turn of the cup, and z_c/|z_c - z_f| times for one of the circular
/// spline, where @p rig gives no ratio. Angles of a cup are z_c/z_f times those of a simulation, which turns the
/// circular spline. Equal or negative numbers of teeth, which a scene with faults may have, count as a ratio of 1.
/// @param file                   CSV
/// @param rig                    what the user says about the rig
/// @param member                 that turns at its output
/// @param flexspline_teeth       z_f
/// @param circular_spline_teeth  z_c
[[nodiscard]] MeasurementReading examine_measurement(std::filesystem::path const& file, RigOptions const& rig,
                                                     OutputMember member, int flexspline_teeth,
                                                     int circular_spline_teeth);

}  // namespace hdconj
