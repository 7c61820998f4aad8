// SPDX-License-Identifier: GPL-3.0-or-later
// All surfaces of a drive under torque.
#pragma once

#include <functional>
#include <string>

#include "hdconj/contact.hpp"
#include "load/grids/grid_error.hpp"
#include "loaded_scene.hpp"

namespace hdconj::load {

/// Who is told of a study while it is computed.
struct LoadObserver
{
    Progress progress;
    std::function<void(std::string const&)> talk;  ///< first figures in words
};

/// Tells the figures of the assembled cup.
void tell_assembly(LoadObserver const& observer, AssembledCup const& cup);

/// Adds every case that scene and options ask for to @p study, names those that are missing, and draws the cup of the
/// case shown.
/// @throws NumericalError of the first case where none can be computed
void add_cases(contact::ContactContext const& context, DriveGrids const& drives, LoadOptions const& options,
               LoadObserver const& observer, LoadStudy& study);

}  // namespace hdconj::load
