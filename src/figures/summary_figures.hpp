// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a solution, which every verb's summary shows. In HDF5 the geometry, the clearance and the errors are
// attributes of `/summary` that have the names and the units of JSON.
#pragma once

#include <string>

#include "figure_of.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::figures {

/// The scene's drive.
[[nodiscard]] Rows<Solution> drive_figures();
/// Derived dimensions.
[[nodiscard]] Rows<Solution> geometry_figures();
/// Result of the check over a full turn; only of a solution that was checked.
[[nodiscard]] Rows<Solution> clearance_figures();
/// Errors that are no single figure's.
[[nodiscard]] Rows<Solution> error_figures();
/// Work done, independent of the clock.
[[nodiscard]] Rows<WorkCount> work_figures();
[[nodiscard]] Rows<ConjugateZone> zone_figures();
[[nodiscard]] Rows<UndecidedPlace> undecided_figures();

/// Branches of a kind, "regular" or "corner".
[[nodiscard]] std::size_t branches_of_kind(Solution const& solution, std::string const& kind);

/// The member whose tooth the scene gives: "flexspline" or "circular spline".
[[nodiscard]] std::string given_member(Solution const& solution);

/// The motion model as the summaries name it.
[[nodiscard]] std::string kinematics_name(Solution const& solution);

/// Sum of the stages [s].
[[nodiscard]] double total_seconds(Solution const& solution);

/// Points of the outline of one slice.
[[nodiscard]] std::size_t outline_points(Solution const& solution);

}  // namespace hdconj::figures
