// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where the teeth stand when the cup is deformed by forces.
#pragma once

#include <vector>

#include "contact_bench.hpp"
#include "hdconj/contact/tooth_places.hpp"
#include "hdconj/load/equilibrium.hpp"

namespace hdconj::detail {

/// Displacement of the neutral curve of every slice as series, and of all stations.
struct LoadedShape
{
    std::vector<std::vector<double>> series;  ///< of the drive's stations
    ToothPlaces places;                       ///< in the planes of the slices
};

/// The shape under forces on the cup's stations (forces_on_cup()).
///
/// The foot of a tooth is the displaced point of the neutral curve, the tooth stands on that curve's normal (MaterialMotion). Displacements are
/// those of the linear cup, with the second-order part that leaves the stretch of the neutral curve as it is: with e = (w' - v)^2/(2 r_m)
/// the mean of w falls by that of e, and v' by the rest of e. In the plane of a slice stand those parts of the cup that have moved into it
/// along the axis (u_z), interpolated between the slices.
[[nodiscard]] LoadedShape loaded_shape(ContactBench const& bench, ElasticDrive const& drive, Eigen::MatrixXd const& forces);

/// Displacement of a flank contact's tooth along its normal [mm], as the linear model has it.
[[nodiscard]] double normal_displacement(ElasticDrive const& drive, LoadedShape const& shape, FlankContact const& c);

}  // namespace hdconj::detail
