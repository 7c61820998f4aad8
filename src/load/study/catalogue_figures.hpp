// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness and lost motion as catalogues state them.
#pragma once

#include <optional>

#include "grid_error.hpp"

namespace hdconj::load {

/// Solves the torques of the definitions and takes K1, K2, K3 and the lost motion from their twists.
///
/// Errors of a slope come from the estimated errors of both twists, added; those of a twist without estimate leave the
/// figures without.
/// @param solved  has the states of the whole curve, the rated one among them
/// @returns nothing where one of the torques has no equilibrium
[[nodiscard]] std::optional<CatalogueFigures> catalogue_figures(LoadProblem const& problem, DrivePair const& drives,
                                                                contact::FlankGrid const& flanks, Play const& play,
                                                                LoadCase const& solved);

}  // namespace hdconj::load
