// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The whole cup under load.
#pragma once

#include <Eigen/Core>

#include "hdconj/pipeline/load_study.hpp"
#include "load_model.hpp"

namespace hdconj::detail {

/// Displacement of the whole cup under forces on the drive's stations.
[[nodiscard]] HarmonicField cup_field(LoadModel const& model, Eigen::MatrixXd const& forces, int threads);

/// The cup as it is drawn, stresses at the corners of elements as means of the Gauss points around them.
[[nodiscard]] CupShape cup_shape(LoadModel const& model, HarmonicField const& field, int angles, int threads);

}  // namespace hdconj::detail
