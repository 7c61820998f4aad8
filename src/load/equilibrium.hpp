// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of flanks and wave generator in equilibrium.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "elastic_drive.hpp"
#include "local_compliance.hpp"

namespace hdconj::load {

/// Forces in equilibrium at one torque, for gaps that are linear in them.
struct Equilibrium
{
    std::vector<double> flank;   ///< force of each contact [N]
    Eigen::MatrixXd bearing;     ///< (bearing, bearing_steps) [N]
    std::vector<double> balls;   ///< force of each point of the line of balls [N]
    double turn = 0;             ///< of the flexspline against the circular spline [rad]
    double stiffness = 0;        ///< dT/dturn with the closed contacts, whole ring [N mm/rad]; 0 without torque
    int steps = 0;               ///< of the active set
    double complementarity = 0;  ///< relative residual
};

/// Contacts of a loaded shape, about which gaps are linear in the forces.
struct LinearGaps
{
    std::vector<FlankContact> contacts;
    std::vector<double> displacement;  ///< of the tooth along the normal in that shape, by the linear model [mm]
    LocalCompliance compliance;
    double turn = 0;  ///< of the flexspline in that shape [rad]
};

/// Solves for forces that leave no gap negative and act only where the gap is zero:
///
///   flank:   g = gap + c.u - c.u(f) - lever (turn - turn_0) + compliance(f) >= 0,  f >= 0,  f g = 0
///   bearing: g = u_cup(f) + u_ring(f) - needed >= 0, likewise, and balls push or the ring stands off them,
///   torque:  sectors sum(lever f) = torque.
///
/// @param torque  on the whole ring [N mm]; absent: teeth carry no force, and the turn stays
/// @param guess   equilibrium of a similar problem, where the active set starts; null: none
/// Domain: a drive with `bearing_compliance`.
/// @throws NumericalError where no such forces are found, or no flank can carry the torque
[[nodiscard]] Equilibrium equilibrium(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque,
                                      Equilibrium const* guess, int threads);

/// Forces as they act on the cup's stations: (stations, grid) [N].
[[nodiscard]] Eigen::MatrixXd forces_on_cup(ElasticDrive const& drive, std::vector<FlankContact> const& contacts,
                                            Equilibrium const& state);

}  // namespace hdconj::load
