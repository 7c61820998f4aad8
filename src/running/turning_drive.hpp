// SPDX-License-Identifier: GPL-3.0-or-later
// A drive at positions of its wave generator: first contact, and balance under torque.
#pragma once

#include <vector>

#include "contact/study/contact_case.hpp"
#include "contact/study/contact_context.hpp"
#include "load/grids/assembled_drive.hpp"
#include "load/study/play.hpp"
#include "running_motion.hpp"
#include "sliding.hpp"

namespace hdconj::running {

/// Turns of the flexspline at which the flanks of either side first touch, in the shape that the scene prescribes.
/// Without errors of the rings the left side is not looked at: the side clearance is what the scene gives.
/// @param pitches  that the wave generator has turned
/// @throws NumericalError where nothing touches within a pitch
[[nodiscard]] load::Play first_contact(contact::ContactContext const& context, contact::FlankGrid const& flanks,
                                       RunningMotion const& motion, double pitches);

/// A drive in balance at one position.
struct Balance
{
    load::LoadedDrive drive;
    double wave_generator_torque = 0;  ///< from the forces of the bearing [N mm]
    double torque_by_teeth = 0;        ///< from the forces of the teeth [N mm]
    double ball_load = 0;              ///< sum of the forces of the balls, or of the bearing without any [N]
    std::vector<SlidingContact> sliding;
};

/// An elastic drive on one grid. The cup's response to unit forces is computed once, for all positions. Refers to what
/// it was made from.
class TurningDrive
{
  public:
    /// @param middle  a turn within the play of @p drive [rad]
    TurningDrive(contact::ContactContext const& context, load::AssembledDrive const& drive,
                 contact::FlankGrid const& flanks, RunningMotion const& motion, double middle);

    /// Turns of the flexspline at which the flanks of either side first touch on the assembled cup.
    [[nodiscard]] load::Play first_contact(double pitches) const;

    /// Balances at one position, torque by torque.
    /// @param torques    on the circular spline, above 0, in order of growing size [N mm]
    /// @param neighbour  balance at a position nearby under the first torque, where the iteration starts; null: it
    /// starts from the first contact
    /// @throws NumericalError where a torque has no balance
    [[nodiscard]] std::vector<Balance> balances(double pitches, std::vector<double> const& torques,
                                                Balance const* neighbour) const;

    /// Sum of the forces of the balls, or of the bearing without any, of the assembled cup [N].
    [[nodiscard]] double assembled_ball_load() const;

  private:
    class At;

    contact::ContactContext const* context_;
    load::AssembledDrive const* drive_;
    load::LoadProblem problem_;
    RunningMotion motion_;
    double middle_;
};

}  // namespace hdconj::running
