// SPDX-License-Identifier: GPL-3.0-or-later
// How both rings of teeth move past the wave generator.
#pragma once

#include <cmath>
#include <numbers>

#include "contact/flank_deviation.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::running {

/// Ratios of a drive whose member @ref output turns; see study_run().
struct RunningMotion
{
    RunningMotion(Drive const& drive, RunningMember member)
        : output(member), flexspline_teeth(drive.flexspline_teeth), circular_spline_teeth(drive.circular_spline_teeth)
    {
    }

    RunningMember output;
    int flexspline_teeth, circular_spline_teeth;

    [[nodiscard]] bool turns_cup() const { return output == RunningMember::flexspline; }
    [[nodiscard]] int held_teeth() const { return turns_cup() ? circular_spline_teeth : flexspline_teeth; }
    [[nodiscard]] int turning_teeth() const { return turns_cup() ? flexspline_teeth : circular_spline_teeth; }
    /// i: turns of the wave generator for one of the output, which runs against it where the cup turns.
    [[nodiscard]] double ratio() const
    {
        return static_cast<double>(turning_teeth()) / (circular_spline_teeth - flexspline_teeth);
    }
    /// Angle of the wave generator over which every tooth comes to the place of its neighbour [rad].
    [[nodiscard]] double pitch() const { return 2 * std::numbers::pi / held_teeth(); }
    /// c: undeformed angle by which the flexspline goes back for each rad of the wave generator; also the speed of the
    /// wave generator against the cup over that against the held ring.
    [[nodiscard]] double cup_rate() const { return static_cast<double>(held_teeth()) / flexspline_teeth; }
    /// c': turn of the output for each rad that the flexspline turns against the circular spline.
    [[nodiscard]] double turn_rate() const
    {
        return turns_cup() ? static_cast<double>(circular_spline_teeth) / flexspline_teeth : 1;
    }
    /// Torque on the circular spline for one on the output.
    [[nodiscard]] double spline_torque(double torque) const { return torque * turn_rate(); }
};

/// The rings at one angle of the wave generator: whole pitches, and what remains.
struct RingPlace
{
    int pitches = 0;   ///< by which both rings have gone back
    double phase = 0;  ///< undeformed angle of the tooth that stands nearest to where tooth 0 stood [rad]
};

/// @param pitches  that the wave generator has turned, whole or not
[[nodiscard]] inline RingPlace ring_place(RunningMotion const& motion, double pitches)
{
    constexpr double beside_half = 1e-9;  // half a pitch forth stays half a pitch
    double const whole = std::floor(pitches + 0.5 - beside_half);
    return {static_cast<int>(whole), -(pitches - whole) * 2 * std::numbers::pi / motion.flexspline_teeth};
}

/// The errors of both rings that have gone back by @p pitches: tooth n stands where tooth n - pitches stood.
[[nodiscard]] contact::FlankDeviation gone_back(contact::FlankDeviation deviation, int pitches);

}  // namespace hdconj::running
