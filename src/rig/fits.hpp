// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares whose errors know the noise of the readings and the steps of the encoder.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "branches.hpp"
#include "found.hpp"

namespace hdconj::rig {

/// What errors every angle has [rad].
struct Noise
{
    double deviation = 0;  ///< standard deviation, from neighbours
    double rounding = 0;   ///< standard deviation by the encoder's steps; 0 where these are finer than the noise
};

/// Standard deviation of the angles: what they differ by from the line through their neighbours of the same branch, by
/// the upper quartile. The curve's own bends count as noise; with readings far apart that makes it too large.
[[nodiscard]] double deviation_from_neighbours(Samples const& samples, std::vector<LoadBranch> const& branches);

/// The value @p wanted^T c of the least squares @p columns c = @p angles, and its standard error. Rows are in order of
/// the torque.
///
/// The variance of a reading is that of the residuals and that of @p noise, which counts as four more of them: a few
/// readings have small residuals by chance. Readings that the encoder gives the same angle share the error of its
/// rounding, and so may the branches: with w the weights of the angles in the value it is the rounding times the root
/// of the sum, over each run of one angle, of (sum of w)^2. Where the angle moves by about one step from reading to
/// reading, neighbouring residuals are alike: with their correlation r the variance is (1 + r)/(1 - r) times as large.
/// Both stand apart, in Found::shared.
[[nodiscard]] Found fitted(Eigen::MatrixXd const& columns, Eigen::VectorXd const& angles, Eigen::VectorXd const& wanted,
                           Noise const& noise);

}  // namespace hdconj::rig
