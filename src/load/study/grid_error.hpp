// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated discretisation errors, from the same drive on a coarser grid.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "assembled_drive.hpp"
#include "torque_continuation.hpp"

namespace hdconj::load {

/// The grid asked for and a coarser one.
struct DrivePair
{
    AssembledDrive fine;
    std::optional<AssembledDrive> coarse;
};

/// Estimated error over the difference to a grid half as fine: two grids, first order, safety 3 of Roache's index (J.
/// Fluids Eng. 116, 1994), and a third more, since grids and meshes may differ in opposite senses. Below nine slices
/// the coarse grid has fewer than five and no longer converges regularly: three times as much.
[[nodiscard]] inline double grid_safety(std::size_t slices)
{
    constexpr double two_grids = 4;
    constexpr std::size_t regular = 9;
    return slices < regular ? two_grids * 3 : two_grids;
}

/// Enters the errors of @p cup, as it is on the fine grid.
/// Domain: a pair with a coarse grid.
void estimate_errors(contact::ContactContext const& context, DrivePair const& drives, AssembledCup& cup);

/// Loading path of one surface on one grid.
struct LoadedCurve
{
    std::vector<LoadedState> states;
    std::vector<BearingMap> bearing;  ///< of each state
    std::vector<UnsettledTorque> unsettled;
    std::size_t rated = 0;  ///< state of the largest torque
    LoadedDrive at_rated;
    double play = 0;    ///< width [rad]
    double middle = 0;  ///< turn from which twists count [rad]
};

/// Errors of the states of a curve.
struct CurveErrors
{
    std::vector<std::optional<LoadedState>> states;  ///< none where the coarse grid has no equilibrium
    double play = 0;                                 ///< [rad]
    Eigen::MatrixXd rated_forces;                    ///< on the coarse cup at the largest torque; empty: unknown
};
/// @param flanks  of the fine grid
[[nodiscard]] CurveErrors curve_errors(contact::ContactContext const& context, AssembledDrive const& coarse,
                                       contact::FlankGrid const& flanks, LoadedCurve const& curve);

}  // namespace hdconj::load
