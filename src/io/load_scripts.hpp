// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The pictures of a load study as gnuplot scripts; private to src/io.
#pragma once

#include "load_figures.hpp"
#include "picture_script.hpp"

namespace hdconj {

/// Whether some case was computed at two torques or more.
[[nodiscard]] bool has_curve(LoadStudy const& study);

/// Torque against twist: every case with its play, its two lines, and what was measured. @param measured  null: nothing
[[nodiscard]] std::string load_curve_script(LoadStudy const& study, Measurement const* measured, PictureFormat format);

/// Pressure over tooth space and slice of the case shown, and the force on each tooth. Needs its map.
[[nodiscard]] std::string load_pressure_script(LoadStudy const& study, PictureFormat format);

/// Section of the cup, as it is and deformed, at the major and the minor axis. Needs a shape.
[[nodiscard]] std::string load_cup_script(LoadStudy const& study, PictureFormat format);

/// Section of the cup coloured by the largest stress over all angles, and the stress around the axis where it is largest. Needs a shape with stress.
[[nodiscard]] std::string load_stress_script(LoadStudy const& study, PictureFormat format);

/// Whether there are single balls in the bearing of the case shown.
[[nodiscard]] bool has_balls(LoadStudy const& study);

/// Forces of the balls all round the ring at the largest torque of the case shown. Needs balls.
[[nodiscard]] std::string load_ball_script(LoadStudy const& study, PictureFormat format);

/// "type-50:  tilted, radial 0.2 deg,  28 N m"
[[nodiscard]] std::string shown_load(LoadStudy const& study);

}  // namespace hdconj
