// SPDX-License-Identifier: GPL-3.0-or-later
// Anderson mixing of loaded shapes (D. G. Anderson, J. ACM 12, 1965); private to src/load.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "load_problem.hpp"

namespace hdconj::load {

/// One iteration of the loaded shape.
struct MixingStep
{
    Eigen::MatrixXd forces;  ///< that the shape led to, on the stations of the cup
    double turn = 0;         ///< that it led to [rad]
    Eigen::VectorXd change;  ///< of all displacements against those of the shape itself [mm]
};

/// Displacements under @p forces and @p turn less those of @p shape at @p turn_of_shape: zero where the shape
/// reproduces itself. Turns of teeth count as what they move the tips by.
[[nodiscard]] Eigen::VectorXd displacement_change(LoadProblem const& problem, LoadedShape const& shape,
                                                  double turn_of_shape, Eigen::MatrixXd const& forces, double turn);

/// Forces and turn of @p now become the affine combination of those of @p history whose changes have the least sum of
/// squares. Domain: a history whose last step is that of @p now.
void anderson_mix(std::vector<MixingStep> const& history, LoadedDrive& now);

}  // namespace hdconj::load
