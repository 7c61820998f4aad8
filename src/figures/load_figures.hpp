// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a load study and of a measured curve.
#pragma once

#include <optional>
#include <string>

#include "contact_figures.hpp"
#include "hdconj/load.hpp"
#include "hdconj/measured.hpp"

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

/// Of a measured curve, but for those that are averages.
[[nodiscard]] Rows<MeasuredStiffness> measured_curve_figures();

/// An average over the cycles of a test rig.
struct MeasuredFigure
{
    Name name;          ///< in HDF5 and JSON, without unit
    char const* words;  ///< in text
    Unit unit;
    Estimate const& (*value)(MeasuredStiffness const&);
    int angles;  ///< power of the angle in it: 1 of an angle, -1 of a torque, -2 of torque over angle; work is the same
                 ///< at both members
    /// The same of the simulation, on the circular spline; none where it has none.
    std::optional<double> (*simulated)(LoadCase const&);
};

[[nodiscard]] std::span<MeasuredFigure const> measured_figures();

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

/// The case that the shape is of; null where there is none.
[[nodiscard]] inline LoadCase const* shown_case(LoadStudy const& study)
{
    return study.written_case < study.cases.size() ? &study.cases[study.written_case] : nullptr;
}

}  // namespace hdconj::figures
