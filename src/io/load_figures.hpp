// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The numbers of a load study under the names that they have in HDF5 and JSON; private to src/io.
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "contact_figures.hpp"
#include "hdconj/io/load_files.hpp"

namespace hdconj {

/// At one torque.
[[nodiscard]] std::span<FigureOf<LoadedState> const> loaded_state_figures();

/// Those of them that have an error estimate, LoadCase::error.
[[nodiscard]] std::span<FigureOf<LoadedState> const> loaded_error_figures();

/// What forces of balls are in: single ones in N, a line of them in N/mm.
[[nodiscard]] inline char const* ball_units(LoadStudy const& study) { return study.balls > 0 ? "N" : "N/mm"; }
[[nodiscard]] inline char const* ball_key(LoadStudy const& study) { return study.balls > 0 ? "ball_force_N" : "ball_force_N_per_mm"; }

/// Of the surface, with its stages.
[[nodiscard]] std::span<FigureOf<LoadCase> const> load_case_figures();

/// Of the cup without torque.
[[nodiscard]] std::span<FigureOf<AssembledCup> const> assembled_cup_figures();

/// What a test rig gave.
struct MeasuredFigure
{
    char const* name;         ///< in HDF5 and JSON, without unit
    char const* words;        ///< in text
    char const* units;        ///< in HDF5
    char const* key_unit;     ///< in JSON, with what leads
    char const* text_units;
    double shown_per_stored;  ///< in JSON and text
    Estimate const& (*value)(MeasuredStiffness const&);
    int angles;               ///< power of the angle in it: 1 of an angle, -1 of a torque, -2 of torque over angle; work is the same at both members
    /// The same of the simulation, on the circular spline; none where it has none.
    std::optional<double> (*simulated)(LoadCase const&);
};

[[nodiscard]] std::span<MeasuredFigure const> measured_figures();

inline constexpr double nm_per_nmm = 1e-3;
/// N m/deg of the thesis per N mm/rad.
inline constexpr double nm_per_deg = nm_per_nmm * std::numbers::pi / 180;

[[nodiscard]] inline std::string case_name(LoadCase const& each) { return surface_name(each.surface, each.kind, each.tilt); }

/// At the largest torque; null where nothing was computed.
[[nodiscard]] inline LoadedState const* rated_state(LoadCase const& each) { return each.rated < each.curve.size() ? &each.curve[each.rated] : nullptr; }

/// Estimated errors of a state of the curve; null where there are none.
[[nodiscard]] inline LoadedState const* error_of(LoadCase const& each, std::size_t state)
{
    return state < each.curve_error.size() && each.curve_error[state] ? &*each.curve_error[state] : nullptr;
}

/// The case that the shape is of; null where there is none.
[[nodiscard]] inline LoadCase const* shown_case(LoadStudy const& study) { return study.shown < study.cases.size() ? &study.cases[study.shown] : nullptr; }

}  // namespace hdconj
