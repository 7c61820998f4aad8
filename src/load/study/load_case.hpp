// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of the circular spline under torque.
#pragma once

#include <functional>

#include "contact/study/contact_case.hpp"
#include "contact/study/contact_context.hpp"
#include "elastic/harmonic_field.hpp"
#include "hdconj/load.hpp"
#include "load/grids/coarse_path.hpp"
#include "loaded_scene.hpp"
#include "play.hpp"

namespace hdconj::load {

/// A surface with the play that it leaves; the rest is as in LoadCase.
struct SurfaceWithPlay
{
    contact::FlankSurface surface;
    Play play = {};
    bool cleared = false;
    std::optional<TipInterference> given_tips = std::nullopt;
    std::optional<TipInterference> tips = std::nullopt;
};

/// The surface with the scene's side clearance or, where with that the assembled teeth press on both flanks or their
/// tips along a radius, with the smallest that clears.
/// @param error  that of a side clearance that is found is estimated too
/// @throws NumericalError where the teeth interfere at every turn
[[nodiscard]] SurfaceWithPlay surface_with_play(contact::ContactContext const& context, AssembledDrive const& drive,
                                                surface::SurfaceSpec const& choice, bool error = false);

/// Who is told of a case while it is computed.
struct CaseObserver
{
    std::function<void(LoadCase const&)> on_play;  ///< when the play is known, before any torque
    std::function<void(double)> on_state;          ///< after each torque: the fraction of the case that is done
};

/// A case, and the displacement of the whole cup and its teeth at the largest torque.
struct SolvedCase
{
    LoadCase result;
    elastic::HarmonicField field;
    LoadedTeeth teeth;
};

/// @param drives   with coarser grids: errors are estimated
/// @throws NumericalError where the teeth interfere at every turn, or no torque has an equilibrium
[[nodiscard]] SolvedCase load_case(contact::ContactContext const& context, DriveGrids const& drives,
                                   surface::SurfaceSpec const& choice, LoadingPath const& torques,
                                   CaseObserver const& observer);

}  // namespace hdconj::load
