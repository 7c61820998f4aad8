// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The numbers of a contact study under the names that they have in HDF5 and JSON; private to src/io.
#pragma once

#include <span>
#include <string>

#include "figure_of.hpp"
#include "hdconj/pipeline/contact_study.hpp"

namespace hdconj {

/// At one angle of the wave generator.
[[nodiscard]] std::span<FigureOf<ContactState> const> state_figures();

/// Of the surface, over a full turn.
[[nodiscard]] std::span<FigureOf<ContactCase> const> case_figures();

/// Arc minutes per radian.
inline constexpr double arcmin_per_radian = 57.295779513082320877 * 60;

/// "tilted, radial 0.2 deg", or "per-slice": what a row of the table is of.
[[nodiscard]] std::string surface_name(std::string const& surface, std::string const& kind, double tilt);

[[nodiscard]] inline std::string case_name(ContactCase const& each) { return surface_name(each.surface, each.kind, each.tilt); }

/// An angle as play at the pitch circle [mm].
inline double at_pitch_circle(double angle, ContactStudy const& study) { return angle * study.pitch_radius; }

}  // namespace hdconj
