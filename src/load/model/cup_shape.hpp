// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement and stress of the whole cup under load.
#pragma once

#include <Eigen/Core>

#include "elastic/harmonic_field.hpp"
#include "hdconj/load.hpp"
#include "load_model.hpp"

namespace hdconj::load {

/// Displacement of the whole cup under forces on the drive's stations.
[[nodiscard]] elastic::HarmonicField cup_field(LoadModel const& model, Eigen::MatrixXd const& forces, int threads);

/// @p forces on the drive's stations with each force of a tooth spread over the face width that its slice stands for,
/// by its mean and its mean square along the axis. Of the slice at an end a quarter comes to the next one: it stands
/// for half a distance inward, while all of its force acts at the end itself. From an inner slice 1/24 comes to either
/// side. What that changes of a figure tells how far it depends on forces being in slices.
[[nodiscard]] Eigen::MatrixXd spread_over_slices(DriveStations const& stations, Eigen::MatrixXd const& forces);

/// The cup at 180 angles as it is drawn; the stress at a corner is the mean of the elements around it.
[[nodiscard]] CupShape cup_shape(LoadModel const& model, elastic::HarmonicField const& field, int threads);

/// The largest von Mises stress of the cup on its surfaces, but for the inner one under the bearing and one wall beside
/// it: under the bearing's edges stress grows without limit with finer elements.
struct CupStress
{
    elastic::StressPeak peak;  ///< at 90 angles of a sector [MPa]
    Vec2 at = Vec2::Zero();    ///< (r, z) [mm]
    double unresolved = 0;     ///< by how much the corners of that side of the element exceed it, and no less than half
                               ///< of it at a ramp, in whose sharp corners it grows without limit [MPa]
};
[[nodiscard]] CupStress cup_stress(LoadModel const& model, elastic::HarmonicField const& field, int threads);

}  // namespace hdconj::load
