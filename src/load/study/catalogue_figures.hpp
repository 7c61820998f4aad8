// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness and lost motion as catalogues state them, and the two lines of the thesis.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/load.hpp"

namespace hdconj::load {

/// Both signs of torque on one grid, each in order of growing size from zero on.
struct CurveBranches
{
    std::vector<LoadedState> forth;
    std::vector<LoadedState> back;
    double free = 0;  ///< twist at zero torque where `forth` begins [rad]
};

/// K1, K2, K3 and lost motion from the states at their torques; nothing where one of them is missing.
/// @param coarser         the same drive on grids that are each half as fine as the one before; empty: no errors
/// @param relative_twist  relative error of the twist along the branch without members in series, the least of the lost
///                        motion without these
/// @param series          compliance of the members in series, which is known [rad/(N mm)]
[[nodiscard]] std::optional<CatalogueFigures> catalogue_figures(CatalogueTorques const& torques,
                                                                CurveBranches const& fine,
                                                                std::vector<CurveBranches> const& coarser,
                                                                double safety, double relative_twist, double series);

/// Two lines through the polygon of the states of `forth`, at even torques: so that they do not depend on where the
/// states lie. The errors are those of the grid and of the polygon, whose chords cut the bends of the curve. All zero
/// without @p coarser. Fewer than two states: all zero.
[[nodiscard]] StiffnessStages stages_of(CurveBranches const& fine, std::vector<CurveBranches> const& coarser,
                                        double safety);

}  // namespace hdconj::load
