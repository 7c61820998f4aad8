// SPDX-License-Identifier: GPL-3.0-or-later
// Members in series with the teeth: what each adds to the twist.
#pragma once

#include <vector>

#include "elastic/elasticity.hpp"
#include "hdconj/load.hpp"
#include "load/elastic_drive.hpp"

namespace hdconj::load {

/// Torque over turn of a disc that is turned at one circle and held at another [N mm/rad]: 4 pi G b/(1/r_i^2 - 1/r_o^2)
/// with the width b. A torque T shears it by tau = T/(2 pi r^2 b), and a ring of the thickness dr turns by tau/(G r)
/// dr. Domain: 0 < inner < outer.
[[nodiscard]] double disc_in_torsion(double inner, double outer, double width, elastic::Elasticity const& material);

/// The members of [compliance] with their stiffness; none without that table.
/// @param root_radius  of the circular spline [mm]
/// @throws NumericalError where its body has no thickness
[[nodiscard]] std::vector<TwistMember> series_members(Scene const& scene, double root_radius);

/// Sum of 1/stiffness [rad/(N mm)].
[[nodiscard]] double compliance_of(std::vector<TwistMember> const& members);

/// Torque over turn of the cup between its toothed ring, loaded evenly over the slices, and its flange [N mm/rad]:
/// harmonic 0 of its response.
/// @param radius  at which the stations of the slices stand [mm]
[[nodiscard]] double cup_in_torsion(ElasticDrive const& drive, double radius);

/// Stiffness of a spring over that of the same with @p compliance in series: 1 + c K.
[[nodiscard]] inline double softening(double compliance, double stiffness)
{
    return 1 + compliance * stiffness;
}

/// What a compliance in series makes of a state of teeth, cup and bearing: theta + c T, K/(1 + c K).
void add_in_series(double compliance, LoadedState& state);

/// What the twist of @p state consists of: half the backlash, teeth with their bearing (the rest), cup, @p series.
/// None without torque.
/// @param free  twist at zero torque on that side of the backlash [rad]
/// @param cup   its torsional stiffness [N mm/rad]
[[nodiscard]] std::vector<TwistMember> twist_members(LoadedState const& state, double free, double cup,
                                                     std::vector<TwistMember> series);

}  // namespace hdconj::load
