// SPDX-License-Identifier: GPL-3.0-or-later
// What a running drive loses by the forces that it has without friction.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/running.hpp"
#include "running_motion.hpp"
#include "sliding.hpp"

namespace hdconj::running {

/// Coefficient of flanks that slide at @p speed [mm/s] >= 0: mu + (mu_0 - mu) exp(-v/v_s) (Stribeck; as in Armstrong-
/// Helouvry et al., Automatica 30, 1994), mu at every speed without flanks_at_rest (Coulomb). At
/// rest: mu_0.
[[nodiscard]] double flank_coefficient(Friction const& friction, double speed);

/// Kinematic viscosity [mm^2/s] at @p temperature [degrees Celsius] by Walther's equation, ASTM D341:
/// lg lg(nu + 0.7) = A - B lg(T/K), through the values at 40 and 100 degrees. Domain: both are given. Accuracy: that of
/// the standard, some per cent between -20 and 150 degrees.
[[nodiscard]] double viscosity(Friction const& friction, double temperature);

/// Palmgren's torque of a bearing that carries nothing [N mm] (A. Palmgren, Ball and Roller Bearing Engineering, 1959;
/// T. A. Harris, Rolling Bearing Analysis):
///
///   M0 = 1e-7 f0 (nu n)^(2/3) d_m^3  where nu n >= 2000,  160e-7 f0 d_m^3 below,
///
/// nu in mm^2/s, n in rpm, d_m in mm.
/// @param speed  of one ring against the other [rad/s]
[[nodiscard]] double lubricant_torque(Friction const& friction, double diameter, double viscosity, double speed);

/// Palmgren's torque M1 = f1 P d_m [N mm] of a bearing under @p ball_load, the sum of the forces of its balls [N].
///
/// Palmgren's P is the load of a radial bearing. Of rigid rings without clearance, whose balls have forces that go with
/// cos^(3/2), that is 0.8225 of the sum of its balls' forces: the quotient of the means of cos^(5/2) and cos^(3/2)
/// (Sjövall's integrals, as in Harris). Each ball of a wave generator resists as it would there.
[[nodiscard]] double load_torque(Friction const& friction, double diameter, double ball_load);

/// Mean diameter of the wave generator's bearing [mm]: between the centres of opposite balls. Without a ball diameter
/// that of the groove's surface; of a rigid bearing that of the cup's bore.
[[nodiscard]] double bearing_diameter(Scene const& scene, double flexspline_inner_radius);

/// The contacts of one position, and its share of all.
struct WeighedContacts
{
    std::vector<SlidingContact> contacts;
    double weight = 1;
};

/// The drive under one torque: what its losses follow from.
struct LoadedRun
{
    double torque = 0;                     ///< on the output [N mm]
    std::vector<WeighedContacts> sliding;  ///< weights add up to 1
    double ball_load = 0;                  ///< mean over the positions [N]
};

/// What losses need to know beside a LoadedRun.
struct LossModel
{
    Friction friction;
    RunningMotion motion;
    double diameter = 0;  ///< bearing_diameter() [mm]
};

/// Torque on the wave generator that sliding flanks take [N mm]: sum(mu(v) F v)/omega over the contacts.
/// @param speed  of the wave generator [rad/s]; 0: at rest
[[nodiscard]] double flank_loss(LossModel const& model, LoadedRun const& run, double speed);

/// All losses at one speed and temperature. Without losses the efficiency is 1; without losses and without torque it is
/// 0/0, NaN.
[[nodiscard]] EfficiencyRow efficiency_at(LossModel const& model, LoadedRun const& run, double speed,
                                          double temperature);

/// Torque on the wave generator that the drive takes at rest [N mm]: flanks at rest, the lubricant's least.
[[nodiscard]] double resting_torque(LossModel const& model, LoadedRun const& run);

/// Torque on the output at which the wave generator begins to turn [N mm]: where T/i is resting_torque(), which is
/// linear between the torques of @p runs. None: up to the largest torque it does not.
/// @param runs  in order of growing torque, the first without torque
[[nodiscard]] std::optional<double> back_driving_torque(LossModel const& model, std::vector<LoadedRun> const& runs);

}  // namespace hdconj::running
