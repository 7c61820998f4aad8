// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of the circular spline under torque.
#pragma once

#include <functional>
#include <vector>

#include "contact/study/contact_context.hpp"
#include "elastic/harmonic_field.hpp"
#include "grid_error.hpp"
#include "hdconj/load.hpp"

namespace hdconj::load {

/// Who is told of a case while it is computed.
struct CaseObserver
{
    std::function<void(LoadCase const&)> on_play;  ///< when the play is known, before any torque
    std::function<void()> on_state;                ///< after each torque
};

/// A case and the displacement of the whole cup at its largest torque.
struct SolvedCase
{
    LoadCase result;
    elastic::HarmonicField field;
};

/// States at all torques that have an equilibrium. After one without, the next torque starts from the last one with.
/// @throws NumericalError of the first torque without equilibrium where no torque but zero has one
[[nodiscard]] LoadedCurve loaded_curve(LoadProblem const& problem, LoadedDrive const& unloaded, Play const& play,
                                       std::vector<double> const& torques, std::function<void()> const& on_state);

/// @param drives   with a coarse grid: errors are estimated
/// @param torques  in the order of loading [N mm]
/// @throws NumericalError where the teeth interfere at every turn, or a torque has no equilibrium
[[nodiscard]] SolvedCase load_case(contact::ContactContext const& context, DrivePair const& drives,
                                   surface::SurfaceSpec const& choice, std::vector<double> const& torques,
                                   CaseObserver const& observer);

}  // namespace hdconj::load
