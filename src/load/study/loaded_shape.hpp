// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of the teeth on a cup that forces deform.
#pragma once

#include <vector>

#include "contact/gap_field.hpp"
#include "contact/study/contact_context.hpp"
#include "hdconj/loaded_cup.hpp"
#include "load/equilibrium.hpp"

namespace hdconj::load {

/// A deformed cup.
struct LoadedShape
{
    std::vector<std::vector<double>> series;  ///< displacement of every station of the drive
    contact::ToothPoses places;               ///< in the planes of the slices
};

/// The shape under forces on the cup's stations (forces_on_cup()).
///
/// The foot of a tooth is the displaced point of the neutral curve, the tooth stands on that curve's normal
/// (MaterialMotion). Displacements are those of the linear cup, with the second-order part that leaves the stretch of
/// the neutral curve as it is: with e = (w' - v)^2/(2 r_m) the mean of w falls by that of e, and v' by the rest of e.
/// The plane of a slice holds those parts of the cup that have moved into it along the axis (u_z), interpolated between
/// the slices, and continued beyond the last one by the cubic through four of them.
[[nodiscard]] LoadedShape loaded_shape(contact::ContactContext const& context, ElasticDrive const& drive,
                                       Eigen::MatrixXd const& forces);

/// Poses of the teeth on a cup with the displacements @p series, as loaded_shape() takes them.
/// @param phase  undeformed angle of tooth 0 [rad]: other than that of @p drive where the wave generator has turned by
/// a little and the shape with it
[[nodiscard]] contact::ToothPoses tooth_poses(contact::ContactContext const& context, ElasticDrive const& drive,
                                              std::vector<std::vector<double>> const& series, double phase);

/// The teeth of a shape, for LoadStudy. @param turn  of the circular spline
[[nodiscard]] LoadedTeeth loaded_teeth(contact::ContactContext const& context, ElasticDrive const& drive,
                                       LoadedShape const& shape, double turn);

/// Displacement of the tooth of a flank contact along its normal [mm] by the linear model.
[[nodiscard]] double normal_displacement(ElasticDrive const& drive, LoadedShape const& shape, FlankContact const& c);

}  // namespace hdconj::load
