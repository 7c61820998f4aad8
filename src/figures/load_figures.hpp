// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a load study.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact_figures.hpp"
#include "hdconj/load.hpp"

namespace hdconj::figures {

/// Of the map of forces: where the smallest gap is, as in the map of gaps.
inline constexpr Name flank_position_of_gap{flank_position.now, "height"};

/// Of the study as a whole.
[[nodiscard]] Rows<LoadStudy> load_study_figures();

/// At one torque. An error is the same member of the state that holds the errors.
/// @param balls  of the bearing: forces of single balls are in N, those of a line of balls (0) in N/mm
[[nodiscard]] Rows<LoadedState> loaded_state_figures(int balls);

/// Of the surface, with its stages.
[[nodiscard]] Rows<LoadCase> load_case_figures();

/// Of the cup without torque. @param balls  as above
[[nodiscard]] Rows<AssembledCup> assembled_cup_figures(int balls);

/// Stiffness and lost motion of a case by the definitions of catalogues.
[[nodiscard]] Rows<CatalogueFigures> catalogue_rows();

/// What the twist at the largest torque consists of, one record for each member in series.
[[nodiscard]] Rows<TwistMember> twist_member_rows();

[[nodiscard]] inline std::string case_name(LoadCase const& each)
{
    return surface_name(each.surface, each.kind, each.tilt);
}

/// At the largest torque; null where nothing was computed.
[[nodiscard]] inline LoadedState const* rated_state(LoadCase const& each)
{
    return each.rated < each.curve.size() ? &each.curve[each.rated] : nullptr;
}

/// Estimated errors of a state of the curve; null where there are none.
[[nodiscard]] inline LoadedState const* error_of(LoadCase const& each, std::size_t state)
{
    return state < each.curve_error.size() && each.curve_error[state] ? &*each.curve_error[state] : nullptr;
}

/// Figures of a case, at its largest torque and of the catalogue whose error exceeds a third of them, by their names in
/// HDF5.
[[nodiscard]] std::vector<std::string> unconverged_figures(LoadCase const& each, int balls);

/// The case that the shape is of; null where there is none.
[[nodiscard]] inline LoadCase const* shown_case(LoadStudy const& study)
{
    return study.written_case < study.cases.size() ? &study.cases[study.written_case] : nullptr;
}

}  // namespace hdconj::figures
