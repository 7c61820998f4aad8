// SPDX-License-Identifier: GPL-3.0-or-later
// One branch of a torque-twist curve: the torques of one sign, from zero on.
#pragma once

#include <functional>
#include <vector>

#include "hdconj/load.hpp"
#include "torque_continuation.hpp"

namespace hdconj::load {

/// Torques of a branch.
struct BranchTorques
{
    std::vector<double> given;        ///< of one sign, in order of growing size [N mm]
    bool refined = false;             ///< more are put between until the stiffness is known everywhere
    std::function<bool()> stop = {};  ///< LoadOptions::stop

    [[nodiscard]] bool is_stopped() const { return stop && stop(); }
};

/// Equilibria of one sign of torque, in order of growing size.
struct TorqueBranch
{
    std::vector<LoadedState> states;
    std::vector<BearingMap> bearing;  ///< of each state
    std::vector<UnsettledTorque> unsettled;
    LoadedDrive last;  ///< in the last of the states
};

/// Solves a branch. Where it is refined, each interval between two torques is halved until the mean stiffnesses of its
/// halves agree within a tenth, or until it is 1/64 of the branch. A torque without equilibrium is left out, and the
/// next starts from the last one that has one.
/// @param on_state  is told with each torque which fraction of the branch was done before; null: nobody
/// @throws NumericalError of the first torque without equilibrium, or for a stop, where no torque but zero has one
[[nodiscard]] TorqueBranch torque_branch(TorqueContinuation const& path, BranchTorques const& torques,
                                         std::function<void(double)> const& on_state);

/// Twist without torque on the side of the backlash where a branch of torques of the sign of @p torque begins [rad].
[[nodiscard]] double free_twist(TorqueContinuation const& path, double torque);

/// Whether two torques differ by rounding alone: a chord between them has no slope.
[[nodiscard]] bool is_same_torque(double a, double b);

/// The state at @p torque, or at the same but for rounding; null: the branch has none.
[[nodiscard]] LoadedState const* state_at(std::vector<LoadedState> const& branch, double torque);

/// Enters dT/d(twist) into the states of a branch: the parabola twist(torque) through each state and its neighbours.
/// The contacts of a state alone would give too much, because they move along the flanks.
/// @param free  twist at zero torque, where the branch begins [rad]
/// @param end   of the last state, which has no neighbour beyond: stiffness_at()
void enter_stiffness(std::vector<LoadedState>& branch, double free, double end);

/// dT/d(twist) at the torque of @p drive alone: the chord from a torque a little smaller [N mm/rad]. Where
/// that twist is lost in the tolerance of the gaps, or that torque has no equilibrium: of the contacts at rest.
[[nodiscard]] double stiffness_at(TorqueContinuation const& path, LoadedDrive const& drive);

/// The state under the opposite torque of a drive that is its own mirror image in the major axis.
/// @param space_angle  of LoadMap
/// @param period       after which the sectors of the ring repeat [rad]
[[nodiscard]] LoadedState mirror_image(LoadedState state, std::vector<double> const& space_angle, double period);

}  // namespace hdconj::load
